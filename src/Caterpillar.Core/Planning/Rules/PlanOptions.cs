using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Planning;

/// <summary>What planning may add to a design.</summary>
public enum PlanPolicy : byte
{
    /// <summary>Retraction, lifts and detours from the settings, and sorting if the groups of the steps allow it.</summary>
    Printer,

    /// <summary>
    /// Nothing: the moves are as drawn, a gap between paths is one straight travel, E is only what the paths need (as in ExtruderTurtle).
    /// </summary>
    AsDrawn,
}

/// <summary>Options of planning. All numbers come from the settings of the printer, the material and the print.</summary>
public sealed record PlanOptions
{
    /// <summary>What is added to the design.</summary>
    public PlanPolicy Policy { get; init; }

    /// <summary>How paths are sorted inside their groups; ignored as drawn.</summary>
    public SortOptions Sort { get; init; } = new(SortRule.Tour);

    /// <summary>Position of the head at the start of the plan, mm; null if the start code does not state it.</summary>
    public Vec3? Start { get; init; }

    /// <summary>How much memory the moves may take; more is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>
    /// An object on the bed that is printed on: travels stay above it, and the first one rises before it goes there. Null for that of the setup.
    /// </summary>
    public TriMesh? Obstacle { get; init; }
}

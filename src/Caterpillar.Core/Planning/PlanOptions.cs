using Caterpillar.Geometry;

namespace Caterpillar.Planning;

/// <summary>What planning may add to a design.</summary>
public enum PlanPolicy : byte
{
    /// <summary>Retraction, lifts and detours from the settings, and sorting where the groups of the steps allow it.</summary>
    Printer,

    /// <summary>
    /// Nothing: the moves are those drawn, a gap between paths is one straight travel, E is what the paths need and no more (the ExtruderTurtle way).
    /// </summary>
    AsDrawn,
}

/// <summary>How planning turns steps into a toolpath. All numbers come from the settings of the printer, the material and the print.</summary>
public sealed record PlanOptions
{
    public PlanPolicy Policy { get; init; }

    /// <summary>How paths are sorted inside their groups; not used as drawn.</summary>
    public SortOptions Sort { get; init; } = new(SortRule.Tour);

    /// <summary>Where the head stands when the plan begins, mm; null where the start code does not say.</summary>
    public Vec3? Start { get; init; }
}

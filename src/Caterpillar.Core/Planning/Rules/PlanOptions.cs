namespace Caterpillar.Planning;

/// <summary>What planning may add to a design.</summary>
public enum PlanPolicy : byte
{
    /// <summary>Retraction, Z-hops and detours from the settings, and sorting within the groups of the steps.</summary>
    Printer,

    /// <summary>Nothing: the moves are as drawn, a gap between paths is one straight travel move, and only the paths extrude (as in ExtruderTurtle).</summary>
    AsDrawn,
}

/// <summary>Options of planning. All numbers come from the printer, material and print settings.</summary>
public sealed record PlanOptions
{
    /// <summary>What planning may add to the design.</summary>
    public PlanPolicy Policy { get; init; }

    /// <summary>How paths are sorted within their groups; no effect with <see cref="PlanPolicy.AsDrawn"/>.</summary>
    public SortOptions Sort { get; init; } = new(SortRule.Tour);

    /// <summary>Position of the head at the start of the plan, mm; null if the start code does not state it.</summary>
    public Vec3? Start { get; init; }

    /// <summary>Maximum memory of the moves; more is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>
    /// An object on the bed to print on. Travel moves stay above it, and the first one rises before it goes there. Null = the object of the setup.
    /// </summary>
    public TriMesh? Obstacle { get; init; }

    /// <summary>Takes the toolpath as far as it is planned, again and again, on the thread that plans. Null = nobody.</summary>
    internal Action<Toolpath>? Follow { get; init; }
}

namespace Caterpillar.Jobs;

/// <summary>Options of a print besides printer, material and settings.</summary>
public sealed record PrintJobOptions
{
    /// <summary>Number of threads, without effect on the result; 0 = all cores.</summary>
    public int Threads { get; init; }

    /// <summary>Memory limit of each stage; error <see cref="MemoryLimit.Code"/> if it is exceeded.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>Moves that planning may add to a drawing.</summary>
    public PlanPolicy Policy { get; init; }

    /// <summary>Order of paths in their groups, if the settings sort them.</summary>
    public SortRule Sort { get; init; } = SortRule.Tour;

    /// <summary>Object on the bed to print onto. Heights above the bed become heights above its surface. Null = none.</summary>
    public TriMesh? Onto { get; init; }

    /// <summary>Leaves drawings where they are instead of moving them onto the surface of the object, for prints on its side.</summary>
    public bool InPlace { get; init; }

    /// <summary>Distance by which the first extrusions are pressed into the object, mm.</summary>
    public double Squeeze { get; init; }

    /// <summary>Skip parts that are beyond a surface or too steep. Otherwise they are an error.</summary>
    public bool Partial { get; init; }

    /// <summary>Where the tool of a printer with rotary axes points; null = up.</summary>
    public ToolAim? Tilt { get; init; }

    /// <summary>
    /// Infill lines of a layer from the height of its top, instead of the infill pattern (<see cref="SliceOptions.InfillLines"/>); null = pattern.
    /// </summary>
    public Func<double, IReadOnlyList<Polyline>>? InfillLines { get; init; }

    internal PlanOptions Planning => new() { Policy = Policy, Sort = new SortOptions(Sort), Memory = Memory };
}

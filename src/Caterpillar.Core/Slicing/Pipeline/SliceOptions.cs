namespace Caterpillar.Slicing;

/// <summary>Options for slicing, apart from the print settings.</summary>
public sealed record SliceOptions
{
    /// <summary>Number of threads. 0 = all cores. The result does not depend on it.</summary>
    public int Threads { get; init; }

    /// <summary>Memory limit for the layers. Exceeding it is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>The printer whose bed must have room for a purge tower beside the models.</summary>
    public Printer Printer { get; init; } = new();

    /// <summary>
    /// Receives finished layers, all of one height together and from bottom to top, on a thread of the slicer. The layers of the result then have no steps.
    /// With supports, the first come after the supports are found. If models are printed one after the other, all layers come at the end.
    /// </summary>
    internal Action<IReadOnlyList<SlicedLayer>>? Take { get; init; }

    /// <summary>
    /// Returns the lines that replace the infill pattern in a layer. The argument is the height of its top above the bed, mm. Only x and y of the lines count,
    /// mm. They are printed in sparse infill only. Called from any thread. Null = the pattern in the settings.
    /// </summary>
    public Func<double, IReadOnlyList<Polyline>>? InfillLines { get; init; }

    /// <summary>Divides planned layers further: curved slicing limits their thickness.</summary>
    internal Func<PlannedLayer[], PlannedLayer[]>? Divide { get; init; }
}

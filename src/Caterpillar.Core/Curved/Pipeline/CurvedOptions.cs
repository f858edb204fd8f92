namespace Caterpillar.Curved;

/// <summary>Options for curved slicing, apart from the field and the print settings.</summary>
public sealed record CurvedOptions
{
    /// <summary>Number of threads. 0 = all cores. The result does not depend on it.</summary>
    public int Threads { get; init; }

    /// <summary>Memory limit for the layers. Exceeding it is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>The object to print on. Nothing is printed below its surface, and the first extrusions fill the gap to it. Null = the bed.</summary>
    public PlanSurface? Onto { get; init; }

    /// <summary>
    /// Returns the lines that replace the infill pattern in a layer, of which x and y count, mm. The argument is the value of the field at the top of the
    /// layer, mm. They are printed at the height of the layer, in sparse infill only. Called from any thread. Null = the pattern in the settings.
    /// </summary>
    public Func<double, IReadOnlyList<Polyline>>? InfillLines { get; init; }

    /// <summary>Maximum tilt of the tool along the layer normals, 0 to 90 degrees. Layers may be steeper by this angle than an upright head allows.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The angle is not 0 to 90.</exception>
    public double MaxTilt
    {
        get;
        init => field = value is >= 0 and <= 90 ? value : throw new ArgumentOutOfRangeException(nameof(value), "The tilt must be 0 to 90 degrees.");
    }

    /// <summary>
    /// True prints only what is within the plan and not too steep for the head. False reports an error if the part extends beyond the plan or is too steep.
    /// </summary>
    public bool Partial { get; init; }

    /// <summary>Takes the steps of the layers in their order; then the layers of the result have none.</summary>
    internal Action<IReadOnlyList<PathStep>>? Take { get; init; }
}

using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Curved;

/// <summary>What curved slicing needs beyond the field and the print settings.</summary>
public sealed record CurvedOptions
{
    /// <summary>Degree of parallelism, 0 for all cores. It does not change the result.</summary>
    public int Threads { get; init; }

    /// <summary>How much memory the layers may take; more is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>The object that is printed on: nothing is printed below its surface, and the first extrusions fill the gap to it. Null for the bed.</summary>
    public PlanSurface? Onto { get; init; }

    /// <summary>
    /// Gives the lines that take the place of the infill's pattern in a layer, for example those of <see cref="SurfaceLines"/>, from the value of the field at
    /// its top, mm; of the lines x and y count, mm. They are printed at the height of the layer, where it is neither closed nor skin; not where infill is 0 or
    /// 100 %. Called from any thread. Null for the pattern of the settings.
    /// </summary>
    public Func<double, IReadOnlyList<Polyline>>? InfillLines { get; init; }

    /// <summary>
    /// How far the tool of a machine tilts along the normals of the layers, degrees: they may be so much steeper than an upright head allows.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">Not from 0 to 90.</exception>
    public double MaxTilt
    {
        get;
        init => field = value is >= 0 and <= 90 ? value : throw new ArgumentOutOfRangeException(nameof(value), "The tilt must be 0 to 90 degrees.");
    }

    /// <summary>
    /// Where the part reaches beyond the plan, or layers are too steep for the head, the rest is printed; without it that is an error.
    /// </summary>
    public bool Partial { get; init; }
}

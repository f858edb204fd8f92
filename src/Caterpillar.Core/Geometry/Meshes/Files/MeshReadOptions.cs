namespace Caterpillar.Geometry;

/// <summary>Options for reading mesh files.</summary>
public sealed record MeshReadOptions
{
    /// <summary>Memory limit while reading. Exceeding it is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>Length of one unit in files that do not state their unit: all but 3MF.</summary> <value>mm, above 0.</value>
    public double UnitLength { get; init; } = 1;

    /// <summary>Number of threads for large binary files. 0 = all cores. The result does not depend on it.</summary>
    public int Threads { get; init; }
}

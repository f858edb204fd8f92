using Caterpillar.Basics;

namespace Caterpillar.Geometry;

/// <summary>Options of reading meshes.</summary>
public sealed record MeshReadOptions
{
    /// <summary>How much memory the meshes may take while they are read; more is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>Threads used for large binary files; 0 = all cores. The mesh does not depend on it.</summary>
    public int Threads { get; init; }
}

using System;
using Caterpillar.Basics;

namespace Caterpillar.Slicing;

/// <summary>How the slicer works, which changes nothing in its result.</summary>
public sealed record SliceOptions
{
    /// <summary>Degree of parallelism, 0 for all cores.</summary>
    public int Threads { get; init; }

    /// <summary>How much memory the layers may take; more is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>Divides planned layers further: curved slicing limits their thickness.</summary>
    internal Func<PlannedLayer[], PlannedLayer[]>? Divide { get; init; }
}

using System;
using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>How the slicer works, which changes nothing in its result.</summary>
public sealed record SliceOptions
{
    /// <summary>Degree of parallelism, 0 for all cores.</summary>
    public int Threads { get; init; }

    /// <summary>How much memory the layers may take; more is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>
    /// Gets the layers as soon as they are finished, those of a height together and from below, on a thread of the slicer; the layers of the result are then
    /// without steps. With supports the first come once those are found; of objects that are printed one after the other all come at the end.
    /// </summary>
    internal Action<IReadOnlyList<SlicedLayer>>? Follow { get; init; }

    /// <summary>Lines of the infill for a layer of a height, where the pattern is that of the user's curves; mm.</summary>
    internal Func<double, IReadOnlyList<Polyline>>? InfillCurves { get; init; }

    /// <summary>Divides planned layers further: curved slicing limits their thickness.</summary>
    internal Func<PlannedLayer[], PlannedLayer[]>? Divide { get; init; }
}

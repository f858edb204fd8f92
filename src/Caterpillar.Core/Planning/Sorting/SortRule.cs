namespace Caterpillar.Planning;

/// <summary>The order in which paths are printed.</summary>
public enum SortRule : byte
{
    /// <summary>The given order, without reversed or rotated paths.</summary>
    None,

    /// <summary>The given order, but each path starts at the end (a loop at the vertex) nearest to the end of the previous path.</summary>
    Orient,

    /// <summary>From each end to the nearest start, or the given order if it is shorter.</summary>
    Nearest,

    /// <summary>By layer number, paths without a layer first; nearest start within a layer.</summary>
    Layer,

    /// <summary>By the lowest Z of each path; nearest start among paths of the same lowest Z.</summary>
    Z,

    /// <summary>Nearest start, then exchanges (2-opt and Or-opt) until the travel length stops shrinking.</summary>
    Tour,
}

/// <summary>Options of <see cref="PathSorter"/>.</summary>
/// <param name="Rule">The requested order.</param>
/// <param name="Reverse">Allow open paths to be printed from their other end.</param>
/// <param name="Rotate">Allow closed paths to start at any vertex.</param>
/// <param name="Start">Position of the head before the first path, mm; null = any, and the first path stays first.</param>
public sealed record SortOptions(SortRule Rule = SortRule.Nearest, bool Reverse = true, bool Rotate = true, Vec3? Start = null);

/// <summary>The placement of a path in an order.</summary>
/// <param name="Index">Its index in the input.</param>
/// <param name="Reversed">True if an open path is printed from its end.</param>
/// <param name="Vertex">Start vertex of a closed path.</param>
public readonly record struct PathPlacement(int Index, bool Reversed = false, int Vertex = 0)
{
    /// <summary>The path, reversed or rotated.</summary>
    public PrintPath Of(PrintPath path) => Reversed ? path.Reversed() : Vertex > 0 ? path.StartingAt(Vertex) : path;
}

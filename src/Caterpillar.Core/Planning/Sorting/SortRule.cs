using Caterpillar.Geometry;

namespace Caterpillar.Planning;

/// <summary>The order in which paths are printed.</summary>
public enum SortRule : byte
{
    /// <summary>As given: nothing is moved, reversed or rotated.</summary>
    None,

    /// <summary>As given, but every path starts at the end (a loop: at the vertex) that is nearest to the end of the previous one.</summary>
    Orient,

    /// <summary>From each end to the nearest start; as given if that is shorter.</summary>
    Nearest,

    /// <summary>By the number of the layer, paths without one first; nearest start within a layer.</summary>
    Layer,

    /// <summary>By the lowest height of the paths; nearest start among those that begin at the same height.</summary>
    Z,

    /// <summary>The nearest start, then exchanges (2-opt and Or-opt) until the travel between the paths gets no shorter.</summary>
    Tour,
}

/// <summary>Options of <see cref="PathSorter"/>.</summary>
/// <param name="Rule">The requested order.</param>
/// <param name="Reverse">Open paths may be printed from their other end.</param>
/// <param name="Rotate">Closed paths may start at any of their vertices.</param>
/// <param name="Start">Position of the head before the first path, mm; null if it does not matter: the first path then stays first.</param>
/// <param name="Passes">Maximum number of passes of exchanges over all paths for <see cref="SortRule.Tour"/>.</param>
public sealed record SortOptions(SortRule Rule = SortRule.Nearest, bool Reverse = true, bool Rotate = true, Vec3? Start = null, int Passes = 8);

/// <summary>The placement of a path in an order.</summary>
/// <param name="Index">Its index in the input.</param>
/// <param name="Reversed">An open path is printed from its end.</param>
/// <param name="Vertex">The vertex at which a closed path starts.</param>
public readonly record struct PathPlacement(int Index, bool Reversed = false, int Vertex = 0);

using Caterpillar.Geometry;

namespace Caterpillar.Planning;

/// <summary>In which order paths are printed.</summary>
public enum SortRule : byte
{
    /// <summary>As given: nothing is moved, turned or rotated.</summary>
    None,

    /// <summary>As given, but every path begins at its end (a loop: at its vertex) that is nearest to where the last one ended.</summary>
    Orient,

    /// <summary>From each end to the nearest start; as given where that would be shorter.</summary>
    Nearest,

    /// <summary>By the number of the layer, paths without one first; nearest start within a layer.</summary>
    Layer,

    /// <summary>By the lowest height of the paths; nearest start among those that begin at the same height.</summary>
    Z,

    /// <summary>The nearest start, then exchanges (2-opt and Or-opt) until the way between the paths gets no shorter.</summary>
    Tour,
}

/// <summary>How <see cref="PathSorter"/> orders paths.</summary>
/// <param name="Rule">The order wanted.</param>
/// <param name="Reverse">Open paths may be printed from their other end.</param>
/// <param name="Rotate">Closed paths may begin at any of their vertices.</param>
/// <param name="Start">Where the head stands before the first path, mm; null where that does not matter: the first path then stays first.</param>
/// <param name="Passes">The most passes of exchanges over all paths for <see cref="SortRule.Tour"/>.</param>
public sealed record SortOptions(SortRule Rule = SortRule.Nearest, bool Reverse = true, bool Rotate = true, Vec3? Start = null, int Passes = 8);

/// <summary>Where a path went in an order.</summary>
/// <param name="Index">Its number in the input.</param>
/// <param name="Reversed">An open path is printed from its end.</param>
/// <param name="Vertex">The vertex at which a closed path begins.</param>
public readonly record struct PathPlacement(int Index, bool Reversed = false, int Vertex = 0);

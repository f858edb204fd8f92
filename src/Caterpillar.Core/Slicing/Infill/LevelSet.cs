using System.Collections.Generic;

namespace Caterpillar.Slicing;

/// <summary>Lines where a formula is zero.</summary>
internal static class LevelSet
{
    /// <summary>What a formula may use: the place in mm, the number of the layer, spacing and width of the strands in mm.</summary>
    public static IReadOnlyList<string> Variables { get; } = ["x", "y", "z", "layer", "spacing", "width"];
}

namespace Caterpillar.Toolpaths;

/// <summary>
/// Layers as they are counted and chosen everywhere: by their number in their object (<see cref="Layer.Index"/>). Objects on the same bed share the numbers.
/// </summary>
public static class LayerNumbers
{
    /// <summary>The numbers of the layers of a toolpath, ascending, each once.</summary>
    public static IReadOnlyList<int> NumbersOfLayers(this Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        var numbers = new SortedSet<int>();
        foreach (var layer in toolpath.Layers) numbers.Add(layer.Index);
        return [.. numbers];
    }

    /// <summary>How many layers a toolpath has: those of several objects with the same number are one.</summary>
    public static int CountLayers(this Toolpath toolpath) => toolpath.NumbersOfLayers().Count;

    /// <summary>The number of the layer of a move, or null for a move without one.</summary>
    public static int? NumberOfLayer(this Toolpath toolpath, Move move)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        return move.Layer >= 0 ? toolpath.Layers[move.Layer].Index : null;
    }
}

namespace Caterpillar.Toolpaths;

/// <summary>
/// Layer numbers: layers are counted and selected by their number in their object (<see cref="Layer.Index"/>). Objects on the same bed share the numbers.
/// </summary>
public static class LayerNumbers
{
    /// <summary>The layer numbers of a toolpath, ascending, each once.</summary>
    public static IReadOnlyList<int> NumbersOfLayers(this Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        var numbers = new SortedSet<int>();
        foreach (var layer in toolpath.Layers) numbers.Add(layer.Index);
        return [.. numbers];
    }

    /// <summary>Number of layers of a toolpath. Layers of several objects with the same number count once.</summary>
    public static int CountLayers(this Toolpath toolpath) => toolpath.NumbersOfLayers().Count;

    /// <summary>The layer number of a move. Null = no layer.</summary>
    public static int? NumberOfLayer(this Toolpath toolpath, Move move)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        return move.Layer >= 0 ? toolpath.Layers[move.Layer].Index : null;
    }
}

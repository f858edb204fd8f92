namespace Caterpillar.Toolpaths;

/// <summary>
/// Layer numbers: layers are counted and selected by their number in their object (<see cref="Layer.Index"/>). Objects on the same bed share the numbers.
/// </summary>
public static class LayerNumbers
{
    /// <summary>The numbers of the printed layers, ascending, each once.</summary>
    public static IReadOnlyList<int> NumbersOfLayers(this Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        return [.. new SortedSet<int>(toolpath.UsedLayers().Select(l => l.Index))];
    }

    /// <summary>The layers that have extrusions, or moves if none has extrusions.</summary>
    internal static IReadOnlyList<Layer> UsedLayers(this Toolpath toolpath)
    {
        var prints = new bool[toolpath.Layers.Count];
        var moves = new bool[toolpath.Layers.Count];
        foreach (var (layer, isPrinted) in toolpath.Blocks.SelectMany(b => b.Summary.Layers))
        {
            moves[layer] = true;
            prints[layer] |= isPrinted;
        }
        var used = Array.IndexOf(prints, true) >= 0 ? prints : moves;
        return [.. toolpath.Layers.Where((_, i) => used[i])];
    }

    /// <summary>Number of layers of a toolpath. Layers of several objects with the same number count once.</summary>
    public static int CountLayers(this Toolpath toolpath) => toolpath.NumbersOfLayers().Count;

    /// <summary>The layer number of a move. Null = no layer.</summary>
    public static int? NumberOfLayer(this Toolpath toolpath, Move move)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        return move.Layer >= 0 ? toolpath.Layers[move.Layer].Index : null;
    }

    /// <summary>The first move of a layer, by its number. Null if there is none.</summary>
    internal static Move? FirstOfLayer(this Toolpath toolpath, int number)
        => toolpath.Moves().Where(m => toolpath.NumberOfLayer(m) == number).Select(m => (Move?)m).FirstOrDefault();
}

namespace Caterpillar.Slicing;

/// <summary>What one tool prints of the layers at one height.</summary>
internal sealed class ToolTurn(int tool, bool changes, List<SlicedLayer> layers)
{
    public int Tool { get; } = tool;

    /// <summary>Another tool comes before it.</summary>
    public bool Changes { get; } = changes;

    /// <summary>What is to be purged before anything else is printed, mm³.</summary>
    public double Purge { get; set; }

    /// <summary>The layers in their order, each with the paths of this tool only.</summary>
    public List<SlicedLayer> Layers { get; } = layers;
}

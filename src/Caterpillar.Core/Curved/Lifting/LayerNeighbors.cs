namespace Caterpillar.Curved;

/// <summary>What the layers above and below cover, for places where layers are too thin to be printed one by one. Only reads; any thread.</summary>
internal sealed class LayerNeighbors
{
    private readonly Dictionary<string, Dictionary<int, Region>> _objects = new(StringComparer.Ordinal);

    public LayerNeighbors(IEnumerable<SlicedLayer> layers)
    {
        foreach (var layer in layers)
        {
            if (!_objects.TryGetValue(layer.Layer.Object, out var regions)) _objects.Add(layer.Layer.Object, regions = []);
            regions[layer.Layer.Index] = layer.Region;
        }
    }

    /// <summary>
    /// Whether a layer, so many below a given one, is left to those above it where it is too thin. Layers are grouped by powers of two, so that groups of
    /// different places end together; a group also ends below the surface of the part.
    /// </summary>
    public bool IsLeft(Layer layer, int below, Vec3 flat, int wanted)
    {
        var group = 1;
        while (group < wanted && group < 64) group *= 2;
        return (layer.Index - below + 1) % group != 0 && Covers(layer, 1 - below, flat) && (below == 0 || Covers(layer, -below, flat));
    }

    /// <summary>True if no part is below a place of a layer.</summary>
    public bool IsLowest(Layer layer, Vec3 flat) => !Covers(layer, -1, flat);

    private bool Covers(Layer layer, int offset, Vec3 flat)
        => _objects[layer.Object].TryGetValue(layer.Index + offset, out var region) && region.Contains(flat.X, flat.Y);
}

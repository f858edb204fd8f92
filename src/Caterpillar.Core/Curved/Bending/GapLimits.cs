namespace Caterpillar.Curved;

/// <summary>Divides layers that are too thick somewhere, measured across the layer at sample columns of the part.</summary>
internal sealed class GapLimits(LayerField field, PartColumns part, PrintSettings settings, double most)
{
    // Columns that are looked at in each layer.
    private const int Samples = 400;

    /// <summary>Layers in equal parts wherever one is thicker than the limit.</summary>
    public PlannedLayer[] Divide(PlannedLayer[] layers)
    {
        var result = new List<PlannedLayer>(layers.Length);
        foreach (var layer in layers)
        {
            var parts = (int)Math.Min(64, Math.Max(1, Math.Ceiling(Thickest(layer.Top, layer.Thickness, most) / most - 1e-6)));
            for (var i = 1; i <= parts; i++)
            {
                var top = layer.Top - layer.Thickness * (parts - i) / parts;
                result.Add(PlannedLayer.Of(top, layer.Thickness / parts, settings.SlicingPlane));
            }
        }
        return result.ToArray();
    }

    /// <summary>Maximum thickness of all layers, mm. 0 = none found.</summary>
    public double Thickest(IEnumerable<Layer> layers)
    {
        var thickest = 0.0;
        foreach (var layer in layers) thickest = Math.Max(thickest, Thickest(layer.Z, layer.Thickness, thickest));
        return thickest;
    }

    // 0 where nothing is thicker than that.
    private double Thickest(double top, double thickness, double than)
    {
        var thickest = 0.0;
        var step = Math.Max(1, part.Columns.Count / Samples);
        for (var i = 0; i < part.Columns.Count; i += step)
        {
            var column = part.Columns[i];
            var (high, low) = field.Heights(column.X, column.Y, top, top - thickness);
            if (!(high - low > Math.Max(than, thickest)) || !(low < column.High && high > column.Low)) continue;
            thickest = Math.Max(thickest, (high - low) * field.Normal(new Vec3(column.X, column.Y, (high + low) / 2)).Z);
        }
        return thickest;
    }
}

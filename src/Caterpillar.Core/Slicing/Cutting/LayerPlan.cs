namespace Caterpillar.Slicing;

/// <summary>Divides a model into layers: the first of its own thickness, then by ranges of heights, a formula, the slope of the surface, or alike.</summary>
internal sealed class LayerPlan(TriMesh mesh, PrintSettings settings)
{
    private const int MaxLayers = 1_000_000;
    private const double Thinnest = 0.001;
    private readonly Formula? _formula = settings.LayerFormula.Length > 0 ? Formula.Compile(settings.LayerFormula, ["z"]).Value : null;
    private readonly SurfaceSlopes? _slopes = settings.AdaptiveLayers ? new SurfaceSlopes(mesh) : null;

    // Of the model above the bed, mm.
    private readonly double _height = mesh.Bounds.Max.Z;

    /// <summary>The layers from the bed up. A layer is part of the plan if its cutting plane is below the top of the model.</summary>
    /// <returns>The layers, or an error if there would be more than a million layers or the formula gives no thickness.</returns>
    public Result<PlannedLayer[]> Layers()
    {
        var layers = new List<PlannedLayer>();
        double bottom = 0, origin = 0;
        // Multiples of a thickness that stays the same, not sums, so that a hundred layers do not drift.
        var alike = 0;
        var last = 0.0;
        while (true)
        {
            var thickness = layers.Count == 0 ? settings.FirstLayerHeight : ThicknessAt(bottom);
            if (!(thickness >= Thinnest))
            {
                var message = $"The layer height formula gives {NumberFormatter.Format(thickness, 4)} mm at z = {NumberFormatter.Format(bottom, 3)} mm. "
                    + $"The minimum is {NumberFormatter.Format(Thinnest, 3)} mm.";
                return new("slice.layer_formula", message, new SourceLocation(Key: "layer_height_formula"));
            }
            if (thickness != last) (origin, alike, last) = (bottom, 0, thickness);
            var top = origin + ++alike * thickness;
            var layer = PlannedLayer.Of(top, thickness, settings.SlicingPlane);
            if (!(layer.Cut < _height)) return new(layers.ToArray(), []);
            if (layers.Count == MaxLayers)
                return new("slice.too_many_layers", "More than a million layers. Increase the layer height.");
            layers.Add(layer);
            bottom = top;
        }
    }

    private double ThicknessAt(double z)
    {
        const double Rounding = 1e-9;
        foreach (var range in settings.LayerRanges)
        {
            if (z >= range.From - Rounding && z < range.To - Rounding) return range.Thickness;
        }
        return _formula is not null ? _formula.Evaluate(z)
            : _slopes is not null ? _slopes.Thickness(z, settings.AdaptiveMinHeight, settings.AdaptiveMaxHeight, settings.AdaptiveCuspHeight,
                settings.LayerHeight)
            : settings.LayerHeight;
    }
}

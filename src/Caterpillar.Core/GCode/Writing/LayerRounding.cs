namespace Caterpillar.GCode;

/// <summary>Finds layers that the decimals of Z cannot represent.</summary>
internal static class LayerRounding
{
    // The part of a layer's height that rounding may change.
    private const double LargestShare = 0.2;

    /// <summary>
    /// The error <c>gcode.layers_rounded</c> for the first layer that rounding merges with the layer below or makes much thinner or thicker. Otherwise null.
    /// </summary>
    public static Diagnostic? Check(Toolpath toolpath, int decimals, SourceLocation place)
    {
        var below = new Dictionary<string, Layer>(StringComparer.Ordinal);
        foreach (var layer in toolpath.Layers)
        {
            var known = below.TryGetValue(layer.Object, out var lower);
            below[layer.Object] = layer;
            if (!known || !(layer.Z - lower!.Z > 1e-9) || !(Math.Abs(layer.Z) < 1e6)) continue;
            var height = layer.Z - lower.Z;
            var rounded = Rounded(layer.Z, decimals) - Rounded(lower.Z, decimals);
            if (Math.Abs(rounded - height) <= LargestShare * height + 1e-9) continue;
            return new Diagnostic(Severity.Error, "gcode.layers_rounded",
                $"Rounded to {NumberFormatter.Format(decimals)} decimals, layer {NumberFormatter.Format(layer.Index)} at Z {Format(layer.Z)} mm would be "
                    + (rounded <= 0 ? "printed into the layer below" : $"{Format(rounded)} mm high instead of {Format(height)} mm")
                        + ". Use more decimals.",
                place);
        }
        return null;
    }

    private static double Rounded(double value, int decimals) => NumberFormatter.FromUnits(NumberFormatter.ToUnits(value, decimals), decimals);

    private static string Format(double value) => NumberFormatter.Format(value, 4);
}

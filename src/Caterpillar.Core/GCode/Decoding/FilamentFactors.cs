namespace Caterpillar.GCode;

/// <summary>mm³ per unit of E, from the slicer's settings in the comments.</summary>
internal static class FilamentFactors
{
    public static double?[] Of(IReadOnlyDictionary<string, string> settings, double? diameter)
        => settings.TryGetValue("use_volumetric_e", out var volumetric) && volumetric.Split(',')[0].Trim() == "1" ? [1.0] : Areas(settings, diameter);

    /// <summary>Filament cross-section of each tool, mm². If the settings state no diameter, the given one applies.</summary>
    public static double?[] Areas(IReadOnlyDictionary<string, string> settings, double? diameter)
    {
        if (settings.TryGetValue("filament_diameter", out var text))
        {
            var parts = text.Split(',');
            var factors = new double?[Math.Min(parts.Length, 1000)];
            for (var i = 0; i < factors.Length; i++)
                factors[i] = NumberReader.TryParse(parts[i].Trim(), out var d)
                    && d is > 0 and < 1000 ? ExtrusionModel.FilamentAreaOf(d) : diameter is { } other ? ExtrusionModel.FilamentAreaOf(other) : null;
            return factors;
        }
        return diameter is { } given ? [ExtrusionModel.FilamentAreaOf(given)] : [];
    }
}

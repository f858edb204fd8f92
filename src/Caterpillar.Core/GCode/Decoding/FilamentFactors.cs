using Caterpillar.Basics;
using Caterpillar.Machines;

namespace Caterpillar.GCode;

/// <summary>mm³ for one unit of E, from the settings that a slicer left in its comments.</summary>
internal static class FilamentFactors
{
    public static double?[] Of(IReadOnlyDictionary<string, string> settings, double? diameter)
    {
        if (settings.TryGetValue("use_volumetric_e", out var volumetric) && volumetric.Split(',')[0].Trim() == "1") return [1.0];
        return Areas(settings, diameter);
    }

    /// <summary>mm² of the filament of each tool; the diameter that is given where the settings say none.</summary>
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

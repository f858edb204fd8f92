namespace Caterpillar.Cli;

/// <summary>Figures of a print.</summary>
/// <param name="Layers">Number of layers.</param>
/// <param name="Size">Outer dimensions in mm, without skirt and purge; null without extrusions. Z is 0 for flat drawings.</param>
/// <param name="Printed">Length of all extrusions and pen lines in mm.</param>
/// <param name="E">Extruded material in units of E.</param>
/// <param name="Volume">Extruded material in mm³; null if the unit of E is unknown.</param>
/// <param name="Filament">Length of filament in mm; null if there is none or its diameter is unknown.</param>
/// <param name="Mass">In g; null if the density is unknown.</param>
/// <param name="Seconds">Print time in s; null if unknown.</param>
internal sealed record PrintFigures(
    int Layers, Vec3? Size, double Printed, double E, double? Volume, double? Filament, double? Mass, double? Seconds)
{
    // mm. Thicker material is pushed by a plunger.
    private const double ThickestFilament = 3.5;

    /// <summary>Names of the columns of <see cref="Values"/>.</summary>
    public static IReadOnlyList<string> Names { get; } = ["layers", "x_mm", "y_mm", "z_mm", "printed_mm", "volume_mm3", "filament_mm", "mass_g", "time_s"];

    /// <summary>The figures in the order of <see cref="Names"/>; null = unknown.</summary>
    public IReadOnlyList<double?> Values => [Layers, Size?.X, Size?.Y, Size?.Z, Printed, Volume, Filament, Mass, Seconds];

    /// <summary>Of a decoded file, whose moves may have been edited, or of which only the sums were kept.</summary>
    public static PrintFigures Of(DecodedGCode decoding, Toolpath toolpath, ToolpathSums? sums = null)
        => Of(toolpath, sums?.ToTotals(toolpath.Tools) ?? ToolpathTotals.Of(toolpath), sums is null ? toolpath.CountLayers() : decoding.Report.PrintedLayers,
            Setting(decoding, "filament_diameter"), Setting(decoding, "filament_density"), null);

    /// <summary>Of a plan, or of the whole file with start and end code, but with layers and size of the plan.</summary>
    public static PrintFigures Of(Toolpath toolpath, PrintSetup setup, PrintFigures? planned = null)
    {
        var (totals, layers) = (ToolpathTotals.Of(toolpath), planned?.Layers ?? toolpath.CountLayers());
        var figures = Of(toolpath, totals, layers, setup.Material.FilamentDiameter, setup.Material.Density, planned);
        if (setup.ToolMaterials.Count == 0 || figures.Mass is null) return figures;
        var values = PrintValues.Of(setup, toolpath);
        return figures with { Filament = values.Number("filament_used_mm"), Mass = values.Number("material_used_g") };
    }

    // Diameter in mm and density in g/cm³; 0 = unknown.
    private static PrintFigures Of(Toolpath toolpath, ToolpathTotals totals, int layers, double diameter, double density, PrintFigures? planned)
    {
        var (length, volume, box) = (totals.PrintLength, totals.DepositedVolume, totals.PartBounds);
        var isVolume = volume is > 0;
        return new PrintFigures(
            layers,
            planned is not null ? planned.Size : box.IsEmpty ? null : SizeOf(box, toolpath, length > 0 ? (volume - totals.InPlaceVolume) / length : null),
            length, totals.DepositedE, volume,
            isVolume && diameter is > 0 and <= ThickestFilament ? volume / (Math.PI / 4 * diameter * diameter) : null,
            isVolume && density > 0 ? volume / 1000 * density : null, null);
    }

    // From edge to edge: the box of the moves, and an extrusion of the mean width and of the thickness of the layers around them.
    private static Vec3 SizeOf(Bounds box, Toolpath toolpath, double? area)
    {
        var thickness = toolpath.Layers.Count > 0 ? toolpath.Layers[^1].Thickness : 0;
        var width = area > 0 && thickness > 0 ? area.Value / thickness + thickness * (1 - Math.PI / 4) : 0;
        return new Vec3(box.Size.X + width, box.Size.Y + width, box.Size.Z + (toolpath.Layers.Count > 0 ? toolpath.Layers[0].Thickness : 0));
    }

    // Slicers list one number for each tool.
    private static double Setting(DecodedGCode decoding, string key)
        => decoding.Settings.TryGetValue(key, out var text) && Basics.NumberReader.TryParse(text.Split(',', ';')[0].Trim(), out var value) && value > 0
            ? value : 0;
}

namespace Caterpillar.Machines;

/// <summary>Templates of printers: they may contain keys of the three profiles and names of values of the print.</summary>
internal static class PrintTemplate
{
    /// <summary>Names in addition to the keys of profiles, and their meanings.</summary>
    public static IReadOnlyList<KeyValuePair<string, string>> Names { get; } =
    [
        new("printer_name", "Name of the printer profile."),
        new("material_name", "Name of the material profile."),
        new("settings_name", "Name of the settings profile."),
        new("start_nozzle_temperature_c", "Nozzle temperature of the first layer, or nozzle_temperature_c if that is 0."),
        new("start_bed_temperature_c", "Bed temperature of the first layer, or bed_temperature_c if that is 0."),
        new("bed_min_x_mm", "Minimum X that the nozzle can reach."),
        new("bed_min_y_mm", "Minimum Y that the nozzle can reach."),
        new("bed_max_x_mm", "Maximum X that the nozzle can reach."),
        new("bed_max_y_mm", "Maximum Y that the nozzle can reach."),
        new("bed_max_z_mm", "Maximum Z that the nozzle can reach."),
        new("volume_per_e_mm3", "Volume of material per unit of E; 0 = no E."),
        new("tool_count", "Number of tools."),
        new("layer_count", "Number of layers."),
        new("print_min_x_mm", "Minimum X of the extrusions. Without extrusions, this and the next five are 0."),
        new("print_min_y_mm", "Minimum Y of the extrusions."),
        new("print_min_z_mm", "Minimum Z of the extrusions."),
        new("print_max_x_mm", "Maximum X of the extrusions."),
        new("print_max_y_mm", "Maximum Y of the extrusions."),
        new("print_max_z_mm", "Maximum Z of the extrusions."),
        new("material_used_mm3", "Volume of the extrusions."),
        new("filament_used_mm", "Length of filament, or plunger travel, of the extrusions."),
        new("material_used_g", "Mass of the extrusions."),
        new("material_cost", "Cost of the extrusions, in the currency of cost_per_kg."),
        new("layer", "Number of the new layer, from 0 (only in layer_change_gcode)."),
        new("layer_z_mm", "Z of the new layer (only in layer_change_gcode)."),
        new("tool", "Number of the new tool (only in tool_change_gcode)."),
        new("previous_tool", "Number of the previous tool (only in tool_change_gcode)."),
    ];

    private static readonly TemplateNames All = OfAll();

    /// <inheritdoc cref="Template.Parse"/>
    public static Result<Template> Parse(IReadOnlyList<string> lines, SourceLocation? source = null)
        => Template.Parse(lines, All, source ?? new SourceLocation());

    /// <summary>The first error in the lines of a template, or null.</summary>
    public static Diagnostic? Error(IReadOnlyList<string> lines) => Parse(lines).Diagnostics.FirstOrDefault();

    private static TemplateNames OfAll()
    {
        var keys = ProfileKeys.All.ToArray();
        var texts = Names.ToLookup(p => p.Key.EndsWith("_name", StringComparison.Ordinal), p => p.Key);
        return new TemplateNames(
            [.. keys.Where(k => k.Kind is KeyKind.Number or KeyKind.Integer or KeyKind.Boolean).Select(k => k.Name), .. texts[false]],
            [.. keys.Where(k => k.Kind is KeyKind.Choice).Select(k => k.Name), .. texts[true]]);
    }
}

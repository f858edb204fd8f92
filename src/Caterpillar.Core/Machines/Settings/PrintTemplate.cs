using Caterpillar.Basics;

namespace Caterpillar.Machines;

/// <summary>Templates of printers: they may use the keys of the three profiles, and names for what is known about a print.</summary>
internal static class PrintTemplate
{
    /// <summary>Names besides the keys of profiles, and what they mean.</summary>
    public static IReadOnlyList<KeyValuePair<string, string>> Names { get; } =
    [
        new("printer_name", "Name of the printer profile."),
        new("material_name", "Name of the material profile."),
        new("settings_name", "Name of the settings profile."),
        new("start_nozzle_temperature_c", "Nozzle temperature of the first layer; that of the other layers if there is none."),
        new("bed_min_x_mm", "Lowest X that the nozzle can reach."),
        new("bed_min_y_mm", "Lowest Y that the nozzle can reach."),
        new("bed_max_x_mm", "Highest X that the nozzle can reach."),
        new("bed_max_y_mm", "Highest Y that the nozzle can reach."),
        new("bed_max_z_mm", "Highest Z that the nozzle can reach."),
        new("volume_per_e_mm3", "Material per unit of E; 0 if there is no E."),
        new("tool_count", "Number of tools."),
        new("layer_count", "Number of layers."),
        new("print_min_x_mm", "Lowest X of the printed extrusions; 0 if nothing is printed, as for the next five."),
        new("print_min_y_mm", "Lowest Y of the printed extrusions."),
        new("print_min_z_mm", "Lowest Z of the printed extrusions."),
        new("print_max_x_mm", "Highest X of the printed extrusions."),
        new("print_max_y_mm", "Highest Y of the printed extrusions."),
        new("print_max_z_mm", "Highest Z of the printed extrusions."),
        new("material_used_mm3", "Volume of the printed extrusions."),
        new("filament_used_mm", "Length of filament, or travel of the plunger, for the printed extrusions."),
        new("material_used_g", "Mass of the printed extrusions."),
        new("material_cost", "Price of the printed extrusions, in the currency of cost_per_kg."),
        new("layer", "Number of the layer that starts, from 0 (only in layer_change_gcode)."),
        new("layer_z_mm", "Height of the layer that starts (only in layer_change_gcode)."),
        new("tool", "Number of the new tool (only in tool_change_gcode)."),
        new("previous_tool", "Number of the previous tool (only in tool_change_gcode)."),
    ];

    private static readonly TemplateNames All = OfAll();

    /// <inheritdoc cref="Template.Parse"/>
    public static Result<Template> Parse(IReadOnlyList<string> lines, SourceLocation? source = null)
        => Template.Parse(lines, All, source ?? new SourceLocation());

    /// <summary>What is wrong with the lines of a template, after the name of its key; null if nothing is.</summary>
    public static string? Problem(IReadOnlyList<string> lines)
    {
        var first = Parse(lines).Diagnostics.FirstOrDefault();
        return first is null ? null : $"has an error in {first.Source}: {first.Message.TrimEnd('.')}";
    }

    private static TemplateNames OfAll()
    {
        var keys = ProfileKeys.Printer.Concat(ProfileKeys.Material).Concat(ProfileKeys.Settings).ToArray();
        var texts = Names.ToLookup(p => p.Key.EndsWith("_name", StringComparison.Ordinal), p => p.Key);
        return new TemplateNames(
            [.. keys.Where(k => k.Kind is KeyKind.Number or KeyKind.Integer or KeyKind.Boolean).Select(k => k.Name), .. texts[false]],
            [.. keys.Where(k => k.Kind is KeyKind.Choice).Select(k => k.Name), .. texts[true]]);
    }
}

using System;
using System.Collections.Generic;
using System.Linq;

namespace Caterpillar.Machines;

/// <summary>The names that templates may use besides the keys of profiles.</summary>
public static class TemplateNames
{
    /// <summary>Names and what they mean.</summary>
    public static IReadOnlyList<KeyValuePair<string, string>> Print { get; } =
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
        new("print_min_x_mm", "Lowest X of the printed strands; 0 if nothing is printed, as for the next five."),
        new("print_min_y_mm", "Lowest Y of the printed strands."),
        new("print_min_z_mm", "Lowest Z of the printed strands."),
        new("print_max_x_mm", "Highest X of the printed strands."),
        new("print_max_y_mm", "Highest Y of the printed strands."),
        new("print_max_z_mm", "Highest Z of the printed strands."),
        new("material_used_mm3", "Volume of the printed strands."),
        new("filament_used_mm", "Length of filament, or travel of the plunger, for the printed strands."),
        new("material_used_g", "Mass of the printed strands."),
        new("material_cost", "Price of the printed strands, in the currency of cost_per_kg."),
        new("layer", "Number of the layer that starts, from 0 (only in layer_template)."),
        new("layer_z_mm", "Height of the layer that starts (only in layer_template)."),
        new("tool", "Number of the new tool (only in tool_change_template)."),
        new("previous_tool", "Number of the previous tool (only in tool_change_template)."),
    ];

    /// <summary>Names of numbers, in a fixed order: the slots of formulas.</summary>
    internal static readonly string[] Numbers = Keys()
        .Where(k => k.Kind is KeyKind.Number or KeyKind.Integer or KeyKind.Boolean).Select(k => k.Name)
        .Concat(Print.Select(p => p.Key).Where(n => !n.EndsWith("_name", StringComparison.Ordinal))).ToArray();

    /// <summary>Names of text values.</summary>
    internal static readonly string[] Texts = Keys()
        .Where(k => k.Kind is KeyKind.Choice).Select(k => k.Name).Concat(Print.Select(p => p.Key).Where(n => n.EndsWith("_name", StringComparison.Ordinal)))
            .ToArray();

    private static IEnumerable<ProfileKey> Keys() => ProfileKeys.Printer.Concat(ProfileKeys.Material).Concat(ProfileKeys.Settings);
}

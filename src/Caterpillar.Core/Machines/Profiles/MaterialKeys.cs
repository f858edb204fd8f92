using System.Collections.Generic;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.Material>;

namespace Caterpillar.Machines;

/// <summary>The keys of materials.</summary>
internal static class MaterialKeys
{
    public static readonly ProfileKey<Material, string> Title = K.Text(
        "title", m => m.Title, (m, v) => m with { Title = v }, "Display name.");

    public static readonly ProfileKey<Material, double> FilamentDiameter = K.Number(
        "filament_diameter_mm", 0.01, 1000, m => m.FilamentDiameter, (m, v) => m with { FilamentDiameter = v },
        "Diameter of the filament, or of the plunger whose travel E measures.");

    public static readonly ProfileKey<Material, double> NozzleTemperature = K.Number(
        "nozzle_temperature_c", 0, 2000, m => m.NozzleTemperature, (m, v) => m with { NozzleTemperature = v },
        "Temperature of the nozzle; 0 = off.");

    public static readonly ProfileKey<Material, double> FirstLayerNozzleTemperature = K.Number(
        "first_layer_nozzle_temperature_c", 0, 2000, m => m.FirstLayerNozzleTemperature, (m, v) => m with { FirstLayerNozzleTemperature = v },
        "Temperature of the nozzle in the first layer; 0 for that of the other layers.");

    public static readonly ProfileKey<Material, double> BedTemperature = K.Number(
        "bed_temperature_c", 0, 500, m => m.BedTemperature, (m, v) => m with { BedTemperature = v }, "Temperature of the bed; 0 = off.");

    public static readonly ProfileKey<Material, double> FlowMultiplier = K.Number(
        "flow_multiplier", 0.01, 100, m => m.FlowMultiplier, (m, v) => m with { FlowMultiplier = v }, "Scales E of all strands.");

    public static readonly ProfileKey<Material, double> FanPercent = K.Number(
        "fan_percent", 0, 100, m => m.FanPercent, (m, v) => m with { FanPercent = v }, "Part cooling.");

    public static readonly ProfileKey<Material, double> FanMaxPercent = K.Number(
        "fan_max_percent", 0, 100, m => m.FanMaxPercent, (m, v) => m with { FanMaxPercent = v },
        "Part cooling of the quickest layers; less than fan_percent means the same as that.");

    public static readonly ProfileKey<Material, double> FanLayerTime = K.Number(
        "fan_layer_time_s", 0, 10_000, m => m.FanLayerTime, (m, v) => m with { FanLayerTime = v },
        "Layers that take less time than this get more part cooling, up to fan_max_percent at min_layer_time_s; 0 for the same in all layers.");

    public static readonly ProfileKey<Material, int> FanOffLayers = K.Integer(
        "fan_off_layers", 0, 1_000_000, m => m.FanOffLayers, (m, v) => m with { FanOffLayers = v },
        "Number of first layers that are printed without part cooling.");

    public static readonly ProfileKey<Material, double> Density = K.Number(
        "density_g_cm3", 0.01, 30, m => m.Density, (m, v) => m with { Density = v }, "Mass per volume.");

    public static readonly ProfileKey<Material, double> CostPerKg = K.Number(
        "cost_per_kg", 0, 1_000_000, m => m.CostPerKg, (m, v) => m with { CostPerKg = v },
        "Price of a kilogram in any currency; 0 if unknown.");

    public static readonly ProfileKey<Material, double> MaxFlow = K.Number(
        "material_max_flow_mm3_s", 0, 1_000_000, m => m.MaxFlow, (m, v) => m with { MaxFlow = v },
        "Material that can be melted or pumped; 0 if unknown.");

    public static readonly IReadOnlyList<ProfileKey<Material>> All =
    [
        Title, FilamentDiameter, NozzleTemperature, FirstLayerNozzleTemperature, BedTemperature, FlowMultiplier, FanPercent,
        FanMaxPercent, FanLayerTime, FanOffLayers, Density, CostPerKg, MaxFlow,
    ];
}

using OptionalKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.Material, double?>;

namespace Caterpillar.Machines;

/// <summary>
/// A material. The keys of profiles are in <see cref="ProfileKeys"/>. A value outside its key's range throws an
/// <see cref="System.ArgumentOutOfRangeException"/>. Immutable.
/// </summary>
public sealed record Material
{
    /// <summary>Name of the profile.</summary>
    public string Name { get; init; } = "pla";

    /// <summary>Display name.</summary>
    public string Title { get; init => field = MaterialKeys.Title.Check(value); } = "PLA";

    /// <summary>Diameter of the filament, or of the plunger whose travel E measures.</summary> <value>mm.</value>
    public double FilamentDiameter { get; init => field = MaterialKeys.FilamentDiameter.Check(value); } = 1.75;

    /// <summary>Nozzle temperature; 0 = off.</summary> <value>°C.</value>
    public double NozzleTemperature { get; init => field = MaterialKeys.NozzleTemperature.Check(value); } = 210;

    /// <summary>Nozzle temperature of the first layer; 0 = nozzle_temperature_c.</summary> <value>°C.</value>
    public double FirstLayerNozzleTemperature { get; init => field = MaterialKeys.FirstLayerNozzleTemperature.Check(value); }

    /// <summary>Nozzle temperature of a tool while another one prints; 0 = unchanged.</summary> <value>°C.</value>
    public double StandbyTemperature { get; init => field = MaterialKeys.StandbyTemperature.Check(value); }

    /// <summary>Bed temperature; 0 = off.</summary> <value>°C.</value>
    public double BedTemperature { get; init => field = MaterialKeys.BedTemperature.Check(value); } = 60;

    /// <summary>Bed temperature of the first layer; 0 = bed_temperature_c.</summary> <value>°C.</value>
    public double FirstLayerBedTemperature { get; init => field = MaterialKeys.FirstLayerBedTemperature.Check(value); }

    /// <summary>Chamber temperature; 0 = off.</summary> <value>°C.</value>
    public double ChamberTemperature { get; init => field = MaterialKeys.ChamberTemperature.Check(value); }

    /// <summary>Flow ratio of all extrusions.</summary> <remarks>1 if the material exactly fills the requested bead.</remarks>
    public double FlowRatio { get; init => field = MaterialKeys.FlowRatio.Check(value); } = 1;

    /// <summary>Minimum fan speed.</summary> <value>%.</value>
    public double MinFanSpeedPercent { get; init => field = MaterialKeys.MinFanSpeedPercent.Check(value); } = 100;

    /// <summary>Maximum fan speed, for the shortest layers. Values below the minimum have no effect.</summary> <value>%.</value>
    public double MaxFanSpeedPercent { get; init => field = MaterialKeys.MaxFanSpeedPercent.Check(value); } = 100;

    /// <summary>Layer time below which the fan speeds up, to the maximum at min_layer_time_s; 0 = off.</summary> <value>s.</value>
    public double FanLayerTime { get; init => field = MaterialKeys.FanLayerTime.Check(value); }

    /// <summary>Number of first layers without fan.</summary>
    public int FanOffLayers { get; init => field = MaterialKeys.FanOffLayers.Check(value); } = 1;

    /// <summary>Density of the material.</summary> <value>g/cm³.</value>
    public double Density { get; init => field = MaterialKeys.Density.Check(value); } = 1.24;

    /// <summary>Cost per kilogram, in any currency; 0 = unknown.</summary>
    public double CostPerKg { get; init => field = MaterialKeys.CostPerKg.Check(value); }

    /// <summary>Maximum volumetric flow of the material; 0 = unknown.</summary> <value>mm³/s.</value>
    public double MaxFlow { get; init => field = MaterialKeys.MaxFlow.Check(value); }

    /// <summary>Pressure advance (linear advance K); empty = as the firmware has it.</summary> <value>s.</value>
    public double? PressureAdvance { get; init => field = MaterialKeys.PressureAdvance.Check(value); }

    /// <summary>Retraction length of the material; empty = retraction_length_mm.</summary> <value>mm.</value>
    public double? RetractionLength { get; init => field = MaterialKeys.RetractionLength.Check(value); }

    /// <summary>Retraction speed of the material; empty = retraction_speed_mm_s.</summary> <value>mm/s.</value>
    public double? RetractionSpeed { get; init => field = MaterialKeys.RetractionSpeed.Check(value); }

    /// <summary>Z-hop of the material; empty = z_hop_mm.</summary> <value>mm.</value>
    public double? ZHop { get; init => field = MaterialKeys.ZHop.Check(value); }

    /// <summary>Wipe distance of the material; empty = wipe_distance_mm.</summary> <value>mm.</value>
    public double? WipeDistance { get; init => field = MaterialKeys.WipeDistance.Check(value); }

    public override string ToString() => Title;
}

/// <summary>The keys of materials.</summary>
internal static class MaterialKeys
{
    public static readonly KeyTable<Material> All = new();

    public static readonly ProfileKey<Material, string> Title = All.Text("title", m => m.Title, (m, v) => m with { Title = v });
    public static readonly MaterialNumberKey FilamentDiameter
        = All.Number("filament_diameter_mm", 0.01, 1000, m => m.FilamentDiameter, (m, v) => m with { FilamentDiameter = v });
    public static readonly MaterialNumberKey NozzleTemperature
        = All.Number("nozzle_temperature_c", 0, 2000, m => m.NozzleTemperature, (m, v) => m with { NozzleTemperature = v });
    public static readonly MaterialNumberKey FirstLayerNozzleTemperature
        = All.Number("first_layer_nozzle_temperature_c", 0, 2000, m => m.FirstLayerNozzleTemperature, (m, v) => m with { FirstLayerNozzleTemperature = v });
    public static readonly MaterialNumberKey StandbyTemperature
        = All.Number("standby_temperature_c", 0, 2000, m => m.StandbyTemperature, (m, v) => m with { StandbyTemperature = v });
    public static readonly MaterialNumberKey BedTemperature
        = All.Number("bed_temperature_c", 0, 500, m => m.BedTemperature, (m, v) => m with { BedTemperature = v });
    public static readonly MaterialNumberKey FirstLayerBedTemperature
        = All.Number("first_layer_bed_temperature_c", 0, 500, m => m.FirstLayerBedTemperature, (m, v) => m with { FirstLayerBedTemperature = v });
    public static readonly MaterialNumberKey ChamberTemperature
        = All.Number("chamber_temperature_c", 0, 500, m => m.ChamberTemperature, (m, v) => m with { ChamberTemperature = v });
    public static readonly MaterialNumberKey FlowRatio = All.Number("flow_ratio", 0.01, 100, m => m.FlowRatio, (m, v) => m with { FlowRatio = v });
    public static readonly MaterialNumberKey MinFanSpeedPercent
        = All.Number("min_fan_speed_percent", 0, 100, m => m.MinFanSpeedPercent, (m, v) => m with { MinFanSpeedPercent = v });
    public static readonly MaterialNumberKey MaxFanSpeedPercent
        = All.Number("max_fan_speed_percent", 0, 100, m => m.MaxFanSpeedPercent, (m, v) => m with { MaxFanSpeedPercent = v });
    public static readonly MaterialNumberKey FanLayerTime
        = All.Number("fan_layer_time_s", 0, 10_000, m => m.FanLayerTime, (m, v) => m with { FanLayerTime = v });
    public static readonly MaterialIntegerKey FanOffLayers
        = All.Integer("fan_off_layers", 0, 1_000_000, m => m.FanOffLayers, (m, v) => m with { FanOffLayers = v });
    public static readonly MaterialNumberKey Density = All.Number("density_g_cm3", 0.01, 30, m => m.Density, (m, v) => m with { Density = v });
    public static readonly MaterialNumberKey CostPerKg = All.Number("cost_per_kg", 0, 1_000_000, m => m.CostPerKg, (m, v) => m with { CostPerKg = v });
    public static readonly MaterialNumberKey MaxFlow = All.Number("material_max_flow_mm3_s", 0, 1_000_000, m => m.MaxFlow, (m, v) => m with { MaxFlow = v });
    public static readonly OptionalKey PressureAdvance
        = All.Optional("pressure_advance_s", 0, 10, m => m.PressureAdvance, (m, v) => m with { PressureAdvance = v });
    public static readonly OptionalKey RetractionLength
        = All.Optional("material_retraction_length_mm", 0, 1000, m => m.RetractionLength, (m, v) => m with { RetractionLength = v });
    public static readonly OptionalKey RetractionSpeed
        = All.Optional("material_retraction_speed_mm_s", 0.01, 10_000, m => m.RetractionSpeed, (m, v) => m with { RetractionSpeed = v });
    public static readonly OptionalKey ZHop = All.Optional("material_z_hop_mm", 0, 1000, m => m.ZHop, (m, v) => m with { ZHop = v });
    public static readonly OptionalKey WipeDistance
        = All.Optional("material_wipe_distance_mm", 0, 1000, m => m.WipeDistance, (m, v) => m with { WipeDistance = v });
}

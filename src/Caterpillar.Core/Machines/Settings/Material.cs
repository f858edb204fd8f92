namespace Caterpillar.Machines;

/// <summary>
/// A material. The keys of profiles are in <see cref="ProfileKeys"/>. A value outside its key's range throws an
/// <see cref="System.ArgumentOutOfRangeException"/>. Immutable.
/// </summary>
public sealed record Material
{
    private static ProfileKind<Material> Keys => ProfileKinds.Material;

    /// <summary>Name of the profile.</summary>
    public string Name { get; init; } = "pla";

    /// <summary>Display name.</summary>
    public string Title { get; init => field = Keys.Check(value); } = "PLA";

    /// <summary>Diameter of the filament, or of the plunger whose travel E measures.</summary> <value>mm.</value>
    public double FilamentDiameter { get; init => field = Keys.Check(value); } = 1.75;

    /// <summary>Nozzle temperature; 0 = off.</summary> <value>°C.</value>
    public double NozzleTemperature { get; init => field = Keys.Check(value); } = 210;

    /// <summary>Nozzle temperature of the first layer; 0 = nozzle_temperature_c.</summary> <value>°C.</value>
    public double FirstLayerNozzleTemperature { get; init => field = Keys.Check(value); }

    /// <summary>Nozzle temperature of a tool while another one prints; 0 = unchanged.</summary> <value>°C.</value>
    public double StandbyTemperature { get; init => field = Keys.Check(value); }

    /// <summary>Bed temperature; 0 = off.</summary> <value>°C.</value>
    public double BedTemperature { get; init => field = Keys.Check(value); } = 60;

    /// <summary>Bed temperature of the first layer; 0 = bed_temperature_c.</summary> <value>°C.</value>
    public double FirstLayerBedTemperature { get; init => field = Keys.Check(value); }

    /// <summary>Chamber temperature; 0 = off.</summary> <value>°C.</value>
    public double ChamberTemperature { get; init => field = Keys.Check(value); }

    /// <summary>Flow ratio of all extrusions.</summary> <remarks>1 if the material exactly fills the requested bead.</remarks>
    public double FlowRatio { get; init => field = Keys.Check(value); } = 1;

    /// <summary>Minimum fan speed.</summary> <value>%.</value>
    public double MinFanSpeedPercent { get; init => field = Keys.Check(value); } = 100;

    /// <summary>Maximum fan speed, for the shortest layers. Values below the minimum have no effect.</summary> <value>%.</value>
    public double MaxFanSpeedPercent { get; init => field = Keys.Check(value); } = 100;

    /// <summary>Layer time below which the fan speeds up, to the maximum at min_layer_time_s; 0 = off.</summary> <value>s.</value>
    public double FanLayerTime { get; init => field = Keys.Check(value); }

    /// <summary>Number of first layers without fan.</summary>
    public int FanOffLayers { get; init => field = Keys.Check(value); } = 1;

    /// <summary>Density of the material.</summary> <value>g/cm³.</value>
    public double Density { get; init => field = Keys.Check(value); } = 1.24;

    /// <summary>Cost per kilogram, in any currency; 0 = unknown.</summary>
    public double CostPerKg { get; init => field = Keys.Check(value); }

    /// <summary>Maximum volumetric flow of the material; 0 = unknown.</summary> <value>mm³/s.</value>
    public double MaxFlow { get; init => field = Keys.Check(value); }

    /// <summary>Maximum volumetric flow at nozzle temperatures: a list of [°C, mm³/s], straight lines between. Replaces material_max_flow_mm3_s.</summary>
    public ValueList<FlowLimit> FlowLimits { get; init => field = Keys.Check(value); } = ValueList<FlowLimit>.Empty;

    /// <summary>Pressure advance (linear advance K); empty = as the firmware has it.</summary> <value>s.</value>
    public double? PressureAdvance { get; init => field = Keys.Check(value); }

    /// <summary>Retraction length of the material; empty = retraction_length_mm.</summary> <value>mm.</value>
    public double? RetractionLength { get; init => field = Keys.Check(value); }

    /// <summary>Retraction speed of the material; empty = retraction_speed_mm_s.</summary> <value>mm/s.</value>
    public double? RetractionSpeed { get; init => field = Keys.Check(value); }

    /// <summary>Z-hop of the material; empty = z_hop_mm.</summary> <value>mm.</value>
    public double? ZHop { get; init => field = Keys.Check(value); }

    /// <summary>Wipe distance of the material; empty = wipe_distance_mm.</summary> <value>mm.</value>
    public double? WipeDistance { get; init => field = Keys.Check(value); }

    public override string ToString() => Title;
}

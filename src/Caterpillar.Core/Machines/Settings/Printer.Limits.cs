namespace Caterpillar.Machines;

// How much and how hot it extrudes.
public sealed partial record Printer
{
    /// <summary>Maximum volumetric flow of the hot end or pump; 0 = unknown.</summary> <value>mm³/s.</value>
    public double MaxFlow { get; init => field = LimitKeys.MaxFlow.Check(value); } = 12;

    /// <summary>Minimum nozzle temperature for extrusion; 0 = material is not heated.</summary> <value>°C.</value>
    public double MinExtrusionTemperature { get; init => field = LimitKeys.MinExtrusionTemperature.Check(value); } = 170;

    /// <summary>Maximum nozzle temperature; 0 = nozzle is not heated.</summary> <value>°C.</value>
    public double MaxNozzleTemperature { get; init => field = LimitKeys.MaxNozzleTemperature.Check(value); } = 300;

    /// <summary>Maximum bed temperature; 0 = bed is not heated.</summary> <value>°C.</value>
    public double MaxBedTemperature { get; init => field = LimitKeys.MaxBedTemperature.Check(value); } = 120;

    /// <summary>Maximum chamber temperature; 0 = chamber is not heated.</summary> <value>°C.</value>
    public double MaxChamberTemperature { get; init => field = LimitKeys.MaxChamberTemperature.Check(value); }

    /// <summary>Maximum volume to extrude or retract while the head does not move.</summary> <value>mm³.</value>
    public double MaxStationaryVolume { get; init => field = LimitKeys.MaxStationaryVolume.Check(value); } = 500;
}

/// <summary>Keys of printers: flow and temperatures.</summary>
internal static class LimitKeys
{
    public static readonly KeyTable<Printer> All = new();

    public static readonly PrinterNumberKey MaxFlow = All.Number("max_flow_mm3_s", 0, 1_000_000, p => p.MaxFlow, (p, v) => p with { MaxFlow = v });
    public static readonly PrinterNumberKey MinExtrusionTemperature
        = All.Number("min_extrusion_temperature_c", 0, 2000, p => p.MinExtrusionTemperature, (p, v) => p with { MinExtrusionTemperature = v });
    public static readonly PrinterNumberKey MaxNozzleTemperature
        = All.Number("max_nozzle_temperature_c", 0, 2000, p => p.MaxNozzleTemperature, (p, v) => p with { MaxNozzleTemperature = v });
    public static readonly PrinterNumberKey MaxBedTemperature
        = All.Number("max_bed_temperature_c", 0, 500, p => p.MaxBedTemperature, (p, v) => p with { MaxBedTemperature = v });
    public static readonly PrinterNumberKey MaxChamberTemperature
        = All.Number("max_chamber_temperature_c", 0, 500, p => p.MaxChamberTemperature, (p, v) => p with { MaxChamberTemperature = v });
    public static readonly PrinterNumberKey MaxStationaryVolume
        = All.Number("max_stationary_volume_mm3", 0, 1e9, p => p.MaxStationaryVolume, (p, v) => p with { MaxStationaryVolume = v });
}

namespace Caterpillar.Machines;

// How much and how hot it extrudes.
public sealed partial record Printer
{
    /// <summary>Maximum volumetric flow of the hot end or pump; 0 = unknown.</summary> <value>mm³/s.</value>
    public double MaxFlow { get; init => field = Keys.Check(value); } = 12;

    /// <summary>Minimum nozzle temperature for extrusion; 0 = material is not heated.</summary> <value>°C.</value>
    public double MinExtrusionTemperature { get; init => field = Keys.Check(value); } = 170;

    /// <summary>Maximum nozzle temperature; 0 = nozzle is not heated.</summary> <value>°C.</value>
    public double MaxNozzleTemperature { get; init => field = Keys.Check(value); } = 300;

    /// <summary>Maximum bed temperature; 0 = bed is not heated.</summary> <value>°C.</value>
    public double MaxBedTemperature { get; init => field = Keys.Check(value); } = 120;

    /// <summary>Maximum chamber temperature; 0 = chamber is not heated.</summary> <value>°C.</value>
    public double MaxChamberTemperature { get; init => field = Keys.Check(value); }

    /// <summary>Maximum volume to extrude or retract while the head does not move.</summary> <value>mm³.</value>
    public double MaxStationaryVolume { get; init => field = Keys.Check(value); } = 500;
}

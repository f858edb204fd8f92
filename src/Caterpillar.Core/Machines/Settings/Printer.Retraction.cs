namespace Caterpillar.Machines;

// Retraction and lifts.
public sealed partial record Printer
{
    /// <summary>Retraction length; 0 = off.</summary> <value>mm.</value>
    public double RetractionLength { get; init => field = Keys.Check(value); } = 0.8;

    /// <summary>Retraction speed.</summary> <value>mm/s.</value>
    public double RetractionSpeed { get; init => field = Keys.Check(value); } = 35;

    /// <summary>Deretraction speed; 0 = retraction speed.</summary> <value>mm/s.</value>
    public double DeretractionSpeed { get; init => field = Keys.Check(value); }

    /// <summary>Extra filament extruded after each deretraction.</summary> <value>mm.</value>
    public double DeretractionExtra { get; init => field = Keys.Check(value); }

    /// <summary>Retract with G10 and G11. Length and speed are set in the firmware.</summary>
    public bool FirmwareRetraction { get; init; }

    /// <summary>Z-hop: height of travel moves above what has been printed.</summary> <value>mm.</value>
    public double ZHop { get; init => field = Keys.Check(value); } = 0.4;

    /// <summary>Speed of vertical travel moves.</summary> <value>mm/s.</value>
    public double ZHopSpeed { get; init => field = Keys.Check(value); } = 10;
}

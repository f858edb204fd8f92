namespace Caterpillar.Machines;

// What a pause does that is put into a print.
public sealed partial record Printer
{
    /// <summary>Height of the nozzle above the print during a pause.</summary> <value>mm.</value> <remarks>0 = no lift.</remarks>
    public double PauseLift { get; init => field = Keys.Check(value); } = 10;

    /// <summary>Position of the head during a pause; empty = corner of the print with minimum X and Y.</summary>
    /// <value>mm.</value> <remarks>One point, or none.</remarks>
    public ValueList<Vec3> PausePark { get; init => field = Keys.Check(value); } = new();

    /// <summary>Retraction length for a pause.</summary> <value>mm.</value>
    public double PauseRetraction { get; init => field = Keys.Check(value); } = 2;

    /// <summary>Extra filament extruded after a pause.</summary> <value>mm.</value>
    public double PausePrime { get; init => field = Keys.Check(value); }

    /// <summary>G-code for a pause; empty = command of the flavor.</summary>
    public ValueList<string> PauseGCode { get; init => field = Keys.Check(value); } = new();
}

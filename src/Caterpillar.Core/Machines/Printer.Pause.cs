using Caterpillar.Geometry;

namespace Caterpillar.Machines;

/// <summary>What a pause does that is put into a print.</summary>
public sealed partial record Printer
{
    /// <summary>How far the nozzle rises above everything printed so far, mm; 0 for a pause on the spot.</summary>
    public double PauseLift { get; init => field = PauseKeys.Lift.Check(value); } = 10;

    /// <summary>Where the head waits, one point in mm; empty for the corner nearest to the origin of all places where the print goes.</summary>
    public ValueList<Vec3> PausePark { get; init => field = PauseKeys.Park.Check(value); } = new();

    /// <summary>Filament retracted for the pause, mm.</summary>
    public double PauseRetraction { get; init => field = PauseKeys.Retraction.Check(value); } = 2;

    /// <summary>Extra filament after the pause, beyond what was retracted, mm.</summary>
    public double PausePrime { get; init => field = PauseKeys.Prime.Check(value); }

    /// <summary>The lines that pause, or none for the command of the dialect.</summary>
    public ValueList<string> PauseCommand { get; init => field = PauseKeys.Command.Check(value); } = new();
}

namespace Caterpillar.Machines;

/// <summary>
/// Accelerations and jerk that the settings of a print ask for, as far as the flavor has commands for them, and at most those of the printer. Accelerations
/// are whole numbers, as they are written.
/// </summary>
internal sealed class CommandedMotion
{
    private readonly PrintSettings _settings;
    private readonly double _usual;

    public CommandedMotion(PrintSetup setup)
    {
        var (printer, flavor) = (setup.Printer, setup.Printer.Flavor);
        (_settings, _usual) = (setup.Settings, printer.PrintAcceleration);
        Accelerations = Given("_acceleration_mm_s2");
        Jerks = Given("_jerk_mm_s");
        var knows = flavor.Limits == LimitCommands.Repetier
            || FlavorCommands.Of(flavor).Find("M204 S1") is { IsKnown: true, Class: CommandClass.Limits };
        if (knows && Accelerations.Count > 0) MostAcceleration = Math.Min(printer.MaxAcceleration.X, printer.MaxAcceleration.Y);
        if (Jerks.Count == 0) return;
        // Junction deviation is a length, to which a jerk says nothing.
        if (printer.Cornering == Cornering.SquareCornerVelocity && flavor.Limits == LimitCommands.Klipper)
            (JerkLimit, MostJerk) = (MotionLimit.SquareCornerVelocity, printer.SquareCornerVelocity);
        else if (printer.Cornering == Cornering.Jerk && flavor.Limits is not (LimitCommands.None or LimitCommands.Klipper))
            (JerkLimit, MostJerk) = (MotionLimit.HeadJerk, Math.Min(printer.Jerk.X, printer.Jerk.Y));
    }

    /// <summary>The keys that are given.</summary>
    public IReadOnlyList<ProfileKey<PrintSettings>> Accelerations { get; }

    /// <inheritdoc cref="Accelerations"/>
    public IReadOnlyList<ProfileKey<PrintSettings>> Jerks { get; }

    /// <summary>Maximum acceleration, mm/s²; null = none is commanded.</summary>
    public double? MostAcceleration { get; }

    /// <summary>Maximum jerk, mm/s, and the limit that it is; null = none is commanded.</summary>
    public double? MostJerk { get; }

    /// <inheritdoc cref="MostJerk"/>
    public MotionLimit? JerkLimit { get; }

    /// <summary>Acceleration of travel moves, mm/s²; null = no command.</summary>
    public double? TravelAcceleration => _settings.TravelMoveAcceleration > 0 ? Whole(_settings.TravelMoveAcceleration) : null;

    /// <summary>Jerk of travel moves, mm/s; null = no command.</summary>
    public double? TravelJerk => _settings.TravelMoveJerk > 0 && MostJerk is { } most ? Math.Min(_settings.TravelMoveJerk, most) : null;

    /// <summary>Acceleration of extrusions of a role, mm/s²; null = no command.</summary>
    public double? Acceleration(Role role, bool firstLayer) => Whole(_settings.AccelerationOf(role, firstLayer, _usual));

    /// <summary>Jerk of extrusions of a role, mm/s; null = no command.</summary>
    public double? Jerk(Role role, bool firstLayer) => MostJerk is { } most ? Math.Min(_settings.JerkOf(role, firstLayer, most), most) : null;

    private double? Whole(double acceleration) => MostAcceleration is { } most ? Math.Max(1, Math.Floor(Math.Min(acceleration, most))) : null;

    private ProfileKey<PrintSettings>[] Given(string ending)
        => [.. ProfileKinds.Settings.Keys.Where(k => k.Name.EndsWith(ending, StringComparison.Ordinal) && k.Get(_settings) is > 0.0)];
}

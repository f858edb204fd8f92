using Caterpillar.Flavors;

namespace Caterpillar.Machines;

/// <summary>
/// Accelerations and jerk that the settings of a print ask for, as far as the flavor has commands for them, and at most those of the printer. Accelerations
/// are whole numbers, as they are written.
/// </summary>
internal sealed class CommandedMotion
{
    public static readonly IReadOnlyList<ProfileKey<PrintSettings>> Accelerations = [.. RoleMotionKeys.All.Where(k => k.Unit == "mm/s²")];
    public static readonly IReadOnlyList<ProfileKey<PrintSettings>> Jerks = [.. RoleMotionKeys.All.Where(k => k.Unit == "mm/s")];

    private readonly Printer _printer;
    private readonly PrintSettings _settings;

    public CommandedMotion(PrintSetup setup)
    {
        (_printer, _settings) = (setup.Printer, setup.Settings);
        HasAcceleration = Asked(Accelerations).Length > 0 && KnowsAccelerations;
        JerkLimit = Asked(Jerks).Length > 0 ? JerkCommand : null;
        if (HasAcceleration && _settings.TravelMoveAcceleration > 0) TravelAcceleration = Whole(_settings.TravelMoveAcceleration);
        if (JerkLimit is not null && _settings.TravelMoveJerk > 0) TravelJerk = Math.Min(_settings.TravelMoveJerk, MostJerk);
    }

    /// <summary>True if the flavor has a command for accelerations.</summary>
    public bool KnowsAccelerations => _printer.Flavor.Limits == LimitCommands.Repetier
        || FlavorCommands.Of(_printer.Flavor).Find("M204 S1") is { IsKnown: true, Class: CommandClass.Limits };

    /// <summary>The limit that the flavor has a command for and that the printer uses as its jerk, or null. Junction deviation is a length.</summary>
    public MotionLimit? JerkCommand => (_printer.Cornering, _printer.Flavor.Limits) switch
    {
        (Cornering.Jerk, LimitCommands.Marlin or LimitCommands.RepRapFirmware or LimitCommands.Repetier) => MotionLimit.HeadJerk,
        (Cornering.SquareCornerVelocity, LimitCommands.Klipper) => MotionLimit.SquareCornerVelocity,
        _ => null,
    };

    /// <summary>True if accelerations are commanded.</summary>
    public bool HasAcceleration { get; }

    /// <summary>The limit by which jerk is commanded, or null.</summary>
    public MotionLimit? JerkLimit { get; }

    /// <summary>Acceleration of travel moves, mm/s²; null = no command.</summary>
    public double? TravelAcceleration { get; }

    /// <summary>Jerk of travel moves, mm/s; null = no command.</summary>
    public double? TravelJerk { get; }

    private double MostAcceleration => Math.Min(_printer.MaxAcceleration.X, _printer.MaxAcceleration.Y);

    private double MostJerk => JerkCommand == MotionLimit.HeadJerk ? Math.Min(_printer.Jerk.X, _printer.Jerk.Y) : _printer.SquareCornerVelocity;

    /// <summary>Acceleration of extrusions of a role, mm/s².</summary>
    public double Acceleration(Role role, bool firstLayer) => Whole(_settings.AccelerationOf(role, firstLayer, _printer.PrintAcceleration));

    /// <summary>Jerk of extrusions of a role, mm/s.</summary>
    public double Jerk(Role role, bool firstLayer) => Math.Min(_settings.JerkOf(role, firstLayer, MostJerk), MostJerk);

    /// <summary>Those of some keys that are given.</summary>
    public ProfileKey<PrintSettings>[] Asked(IReadOnlyList<ProfileKey<PrintSettings>> keys) => [.. keys.Where(k => k.Get(_settings) is > 0.0)];

    /// <summary>Keys with values above those of the printer, which are used instead.</summary>
    public IEnumerable<(ProfileKey Key, double Most)> Above()
        => Asked(Accelerations).Select(k => (Key: k, Most: KnowsAccelerations ? MostAcceleration : double.MaxValue))
            .Concat(Asked(Jerks).Select(k => (Key: k, Most: JerkCommand is not null ? MostJerk : double.MaxValue)))
            .Where(k => k.Key.Get(_settings) is double value && value > k.Most).Select(k => ((ProfileKey)k.Key, k.Most));

    private double Whole(double acceleration) => Math.Max(1, Math.Floor(Math.Min(acceleration, MostAcceleration)));
}

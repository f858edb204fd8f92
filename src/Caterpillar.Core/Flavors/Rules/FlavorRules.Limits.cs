namespace Caterpillar.Flavors;

/// <summary>Motion limits and the display of progress.</summary>
public sealed partial record FlavorRules
{
    /// <summary>Commands that set limits of speed and acceleration.</summary>
    internal LimitCommands Limits { get; init; }

    /// <summary>What M73 shows.</summary>
    internal ProgressCommand Progress { get; init; }
}

/// <summary>Commands that set motion limits.</summary>
internal enum LimitCommands
{
    /// <summary>M204 S or P is the acceleration. Other commands are unknown.</summary>
    None,

    /// <summary>M201 X Y Z E in mm/s², M203 X Y Z E in mm/s, M204 S P T R, M205 X Y Z E (jerk in mm/s) and J (junction deviation in mm).</summary>
    Marlin,

    /// <summary>M201 in mm/s², M203 in mm/min, M204 P T, M566 (jerk in mm/min).</summary>
    RepRapFirmware,

    /// <summary>M204 S, or the lesser of P and T; SET_VELOCITY_LIMIT.</summary>
    Klipper,
}

/// <summary>What M73 shows on the display of the printer.</summary>
internal enum ProgressCommand
{
    /// <summary>Unknown command.</summary>
    None,

    /// <summary>P is the progress in percent.</summary>
    Percent,

    /// <summary>P is the progress in percent, R the remaining minutes.</summary>
    PercentAndMinutes,
}

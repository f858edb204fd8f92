namespace Caterpillar.Flavors;

/// <summary>Motion limits and the display of progress.</summary>
public sealed partial record FlavorRules
{
    /// <summary>Commands that set limits of speed and acceleration.</summary>
    internal LimitCommands Limits { get; init; }

    /// <summary>Printing and travel moves have commands for their accelerations (M204 P and T, M201 and M202). Otherwise M204 S is for both.</summary>
    internal bool SeparateAccelerations { get; init; }

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

    /// <summary>M201 X Y of printing and M202 X Y of travel moves in mm/s², M207 X (jerk of X and Y in mm/s).</summary>
    Repetier,
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

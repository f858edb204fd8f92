namespace Caterpillar.Flavors;

/// <summary>Limits of the motion, and the display of progress.</summary>
public sealed partial record FlavorRules
{
    /// <summary>Which commands set limits of speed and acceleration.</summary>
    internal LimitCommands Limits { get; init; }

    /// <summary>What M73 shows.</summary>
    internal ProgressCommand Progress { get; init; }
}

/// <summary>Which commands set limits of the motion.</summary>
internal enum LimitCommands
{
    /// <summary>M204 S, or else P, is the acceleration; others are not known.</summary>
    None,

    /// <summary>M201 X Y Z E in mm/s², M203 X Y Z E in mm/s, M204 S P T R, M205 X Y Z E (jerk in mm/s) and J (junction deviation in mm).</summary>
    Marlin,

    /// <summary>M201 in mm/s², M203 in mm/min, M204 P T, M566 (jerk in mm/min).</summary>
    RepRapFirmware,

    /// <summary>M204 S, or the lesser of P and T; SET_VELOCITY_LIMIT.</summary>
    Klipper,
}

/// <summary>What M73 shows on the display of a machine.</summary>
internal enum ProgressCommand
{
    /// <summary>It is not known.</summary>
    None,

    /// <summary>P is the percent that is done.</summary>
    Percent,

    /// <summary>P is the percent that is done, R the minutes that are left.</summary>
    PercentAndMinutes,
}

namespace Caterpillar.GCode;

/// <summary>Motion limits as lines of G-code.</summary>
internal static class LimitText
{
    /// <summary>The line, or null if the firmware has no command for this limit.</summary>
    public static string? Line(LimitEvent what, LimitCommands commands) => commands switch
    {
        LimitCommands.Marlin => Words(what, 1, "M205") ?? (what.Limit == MotionLimit.RetractionAcceleration ? "M204 R" + Number(what.Value, 3)
            : what.Limit == MotionLimit.JunctionDeviation ? "M205 J" + Number(what.Value, 5) : null),
        LimitCommands.RepRapFirmware => Words(what, 60, "M566"),
        LimitCommands.Klipper => Named(what),
        LimitCommands.Repetier => Repetier(what),
        _ => null,
    };

    private static string? Words(LimitEvent what, double speedUnit, string jerk) => what.Limit switch
    {
        MotionLimit.PrintAcceleration => "M204 P" + Number(what.Value, 3),
        MotionLimit.TravelAcceleration => "M204 T" + Number(what.Value, 3),
        MotionLimit.HeadJerk => jerk + Both(what.Value * speedUnit),
        >= MotionLimit.AccelerationX and <= MotionLimit.AccelerationE => "M201 " + Axis(what.Limit - MotionLimit.AccelerationX) + Number(what.Value, 3),
        >= MotionLimit.SpeedX and <= MotionLimit.SpeedE => "M203 " + Axis(what.Limit - MotionLimit.SpeedX) + Number(what.Value * speedUnit, 3),
        >= MotionLimit.JerkX and <= MotionLimit.JerkE => jerk + " " + Axis(what.Limit - MotionLimit.JerkX) + Number(what.Value * speedUnit, 3),
        _ => null,
    };

    // Klipper has one acceleration for all moves: that of printing counts.
    private static string? Named(LimitEvent what) => what.Limit switch
    {
        MotionLimit.PrintAcceleration => "M204 S" + Number(what.Value, 3),
        MotionLimit.Speed => "SET_VELOCITY_LIMIT VELOCITY=" + Number(what.Value, 3),
        MotionLimit.SquareCornerVelocity => "SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY=" + Number(what.Value, 3),
        MotionLimit.MinimumCruiseRatio => "SET_VELOCITY_LIMIT MINIMUM_CRUISE_RATIO=" + Number(what.Value, 4),
        _ => null,
    };

    private static string? Repetier(LimitEvent what) => what.Limit switch
    {
        MotionLimit.PrintAcceleration => "M201" + Both(what.Value),
        MotionLimit.TravelAcceleration => "M202" + Both(what.Value),
        MotionLimit.HeadJerk => "M207 X" + Number(what.Value, 3),
        _ => null,
    };

    private static string Both(double value) => " X" + Number(value, 3) + " Y" + Number(value, 3);

    private static char Axis(int number) => "XYZE"[number];

    private static string Number(double value, int decimals) => NumberFormatter.Format(value, decimals);
}

namespace Caterpillar.Toolpaths;

/// <summary>Motion limits of a machine. The four axes of a limit follow each other: X, Y, Z, E.</summary>
internal enum MotionLimit
{
    /// <summary>Acceleration of moves of the head with E, mm/s².</summary>
    PrintAcceleration,

    /// <summary>Acceleration of moves of the head without E, mm/s².</summary>
    TravelAcceleration,

    /// <summary>Acceleration of the extruder alone, mm/s².</summary>
    RetractionAcceleration,

    /// <summary>Maximum acceleration of an axis, mm/s².</summary>
    AccelerationX,
    AccelerationY,
    AccelerationZ,
    AccelerationE,

    /// <summary>Maximum speed of an axis, mm/s.</summary>
    SpeedX,
    SpeedY,
    SpeedZ,
    SpeedE,

    /// <summary>Maximum instantaneous speed change of an axis (jerk), mm/s.</summary>
    JerkX,
    JerkY,
    JerkZ,
    JerkE,

    /// <summary>Junction deviation, mm.</summary>
    JunctionDeviation,

    /// <summary>Square corner velocity (speed through a corner of 90°), mm/s.</summary>
    SquareCornerVelocity,

    /// <summary>Minimum cruise ratio (part of a move at constant speed), 0 to 1.</summary>
    MinimumCruiseRatio,

    /// <summary>Maximum speed of the head, mm/s (Klipper).</summary>
    Speed,

    /// <summary>Jerk of X and Y, mm/s.</summary>
    HeadJerk,
}

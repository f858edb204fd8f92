namespace Caterpillar.Toolpaths;

/// <summary>What limits the motion of a machine. The four axes of a limit follow each other: X, Y, Z, E.</summary>
internal enum MotionLimit
{
    /// <summary>Acceleration of moves of the head with E, mm/s².</summary>
    PrintAcceleration,

    /// <summary>Acceleration of moves of the head without E, mm/s².</summary>
    TravelAcceleration,

    /// <summary>Acceleration of the extruder alone, mm/s².</summary>
    RetractionAcceleration,

    /// <summary>Highest acceleration of an axis, mm/s².</summary>
    AccelerationX,
    AccelerationY,
    AccelerationZ,
    AccelerationE,

    /// <summary>Highest speed of an axis, mm/s.</summary>
    SpeedX,
    SpeedY,
    SpeedZ,
    SpeedE,

    /// <summary>Highest jump of the speed of an axis, mm/s.</summary>
    JerkX,
    JerkY,
    JerkZ,
    JerkE,

    /// <summary>Distance from a corner within which its path stays, mm.</summary>
    JunctionDeviation,

    /// <summary>Speed through a corner of 90°, mm/s.</summary>
    SquareCornerVelocity,

    /// <summary>Part of a move that must be at constant speed, 0 to 1.</summary>
    MinimumCruiseRatio,

    /// <summary>Highest speed of the head, mm/s (Klipper).</summary>
    Speed,
}

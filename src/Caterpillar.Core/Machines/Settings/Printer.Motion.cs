namespace Caterpillar.Machines;

// Speeds, accelerations, and what takes time.
public sealed partial record Printer
{
    /// <summary>Maximum speed of each axis.</summary> <value>mm/s.</value>
    public AxisValues MaxSpeed { get; init => field = MotionKeys.MaxSpeed.Check(value); } = new(300, 300, 12, 60);

    /// <summary>Maximum acceleration of each axis.</summary> <value>mm/s².</value>
    public AxisValues MaxAcceleration { get; init => field = MotionKeys.MaxAcceleration.Check(value); } = new(1000, 1000, 100, 5000);

    /// <summary>Acceleration of printing moves.</summary> <value>mm/s².</value>
    public double PrintAcceleration { get; init => field = MotionKeys.PrintAcceleration.Check(value); } = 800;

    /// <summary>Acceleration of travel moves.</summary> <value>mm/s².</value>
    public double TravelAcceleration { get; init => field = MotionKeys.TravelAcceleration.Check(value); } = 1000;

    /// <summary>Acceleration of retraction and deretraction.</summary> <value>mm/s².</value>
    public double RetractionAcceleration { get; init => field = MotionKeys.RetractionAcceleration.Check(value); } = 1000;

    /// <summary>How the firmware limits speed in corners.</summary>
    public Cornering Cornering { get; init; } = Cornering.JunctionDeviation;

    /// <summary>Jerk of each axis, with cornering=jerk.</summary> <value>mm/s.</value>
    public AxisValues Jerk { get; init => field = MotionKeys.Jerk.Check(value); } = new(8, 8, 0.4, 5);

    /// <summary>Junction deviation, with cornering=junction_deviation.</summary> <value>mm.</value>
    public double JunctionDeviation { get; init => field = MotionKeys.JunctionDeviation.Check(value); } = 0.013;

    /// <summary>Square corner velocity, with cornering=square_corner_velocity.</summary> <value>mm/s.</value>
    public double SquareCornerVelocity { get; init => field = MotionKeys.SquareCornerVelocity.Check(value); } = 5;

    /// <summary>Klipper's minimum cruise ratio.</summary>
    public double MinimumCruiseRatio { get; init => field = MotionKeys.MinimumCruiseRatio.Check(value); }

    /// <summary>Klipper's instantaneous corner velocity of the extruder, with cornering=square_corner_velocity.</summary> <value>mm/s.</value>
    public double InstantaneousCornerVelocity { get; init => field = MotionKeys.InstantaneousCornerVelocity.Check(value); } = 1;

    /// <summary>Number of moves that the firmware plans ahead; 0 = all.</summary>
    public int LookaheadMoves { get; init => field = MotionKeys.LookaheadMoves.Check(value); } = 16;

    /// <summary>Length of the segments that the firmware divides arcs into.</summary> <value>mm.</value>
    public double ArcSegment { get; init => field = MotionKeys.ArcSegment.Check(value); } = 1;

    /// <summary>Heating rate of the nozzle, in °C per second; 0 = do not count heating in print times.</summary> <value>°C/s.</value>
    public double NozzleHeating { get; init => field = MotionKeys.NozzleHeating.Check(value); } = 2;

    /// <summary>Heating rate of the bed, in °C per second; 0 = do not count heating in print times.</summary> <value>°C/s.</value>
    public double BedHeating { get; init => field = MotionKeys.BedHeating.Check(value); } = 0.5;

    /// <summary>Time of a tool change, not counting its moves.</summary> <value>s.</value>
    public double ToolChangeTime { get; init => field = MotionKeys.ToolChangeTime.Check(value); }

    /// <summary>Time of homing.</summary> <value>s.</value>
    public double HomingTime { get; init => field = MotionKeys.HomingTime.Check(value); }
}

/// <summary>Keys of printers: speeds, accelerations, times.</summary>
internal static class MotionKeys
{
    public static readonly KeyTable<Printer> All = new();

    public static readonly ProfileKey<Printer, AxisValues> MaxSpeed
        = All.Axes("max_speed_mm_s", 0.01, 100_000, p => p.MaxSpeed, (p, v) => p with { MaxSpeed = v });
    public static readonly ProfileKey<Printer, AxisValues> MaxAcceleration
        = All.Axes("max_acceleration_mm_s2", 0.01, 1_000_000, p => p.MaxAcceleration, (p, v) => p with { MaxAcceleration = v });
    public static readonly PrinterNumberKey PrintAcceleration
        = All.Number("print_acceleration_mm_s2", 0.01, 1_000_000, p => p.PrintAcceleration, (p, v) => p with { PrintAcceleration = v });
    public static readonly PrinterNumberKey TravelAcceleration
        = All.Number("travel_acceleration_mm_s2", 0.01, 1_000_000, p => p.TravelAcceleration, (p, v) => p with { TravelAcceleration = v });
    public static readonly PrinterNumberKey RetractionAcceleration
        = All.Number("retraction_acceleration_mm_s2", 0.01, 1_000_000, p => p.RetractionAcceleration, (p, v) => p with { RetractionAcceleration = v });
    public static readonly ProfileKey<Printer, Cornering> Cornering = All.Choice("cornering", p => p.Cornering, (p, v) => p with { Cornering = v });
    public static readonly ProfileKey<Printer, AxisValues> Jerk = All.Axes("jerk_mm_s", 0, 10_000, p => p.Jerk, (p, v) => p with { Jerk = v });
    public static readonly PrinterNumberKey JunctionDeviation
        = All.Number("junction_deviation_mm", 0.0001, 10, p => p.JunctionDeviation, (p, v) => p with { JunctionDeviation = v });
    public static readonly PrinterNumberKey SquareCornerVelocity
        = All.Number("square_corner_velocity_mm_s", 0, 10_000, p => p.SquareCornerVelocity, (p, v) => p with { SquareCornerVelocity = v });
    public static readonly PrinterNumberKey MinimumCruiseRatio
        = All.Number("minimum_cruise_ratio", 0, 0.99, p => p.MinimumCruiseRatio, (p, v) => p with { MinimumCruiseRatio = v });
    public static readonly PrinterNumberKey InstantaneousCornerVelocity = All.Number(
        "instantaneous_corner_velocity_mm_s", 0.001, 10_000, p => p.InstantaneousCornerVelocity, (p, v) => p with { InstantaneousCornerVelocity = v });
    public static readonly PrinterIntegerKey LookaheadMoves
        = All.Integer("lookahead_moves", 0, 1_000_000, p => p.LookaheadMoves, (p, v) => p with { LookaheadMoves = v });
    public static readonly PrinterNumberKey ArcSegment = All.Number("arc_segment_mm", 0.01, 1000, p => p.ArcSegment, (p, v) => p with { ArcSegment = v });
    public static readonly PrinterNumberKey NozzleHeating
        = All.Number("nozzle_heating_c_s", 0, 1000, p => p.NozzleHeating, (p, v) => p with { NozzleHeating = v });
    public static readonly PrinterNumberKey BedHeating = All.Number("bed_heating_c_s", 0, 1000, p => p.BedHeating, (p, v) => p with { BedHeating = v });
    public static readonly PrinterNumberKey ToolChangeTime
        = All.Number("tool_change_time_s", 0, 10_000, p => p.ToolChangeTime, (p, v) => p with { ToolChangeTime = v });
    public static readonly PrinterNumberKey HomingTime = All.Number("homing_time_s", 0, 10_000, p => p.HomingTime, (p, v) => p with { HomingTime = v });
}

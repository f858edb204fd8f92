namespace Caterpillar.Machines;

// Speeds, accelerations, and what takes time.
public sealed partial record Printer
{
    /// <summary>Maximum speed of each axis.</summary> <value>mm/s.</value>
    public AxisValues MaxSpeed { get; init => field = Keys.Check(value); } = new(300, 300, 12, 60);

    /// <summary>Maximum acceleration of each axis.</summary> <value>mm/s².</value>
    public AxisValues MaxAcceleration { get; init => field = Keys.Check(value); } = new(1000, 1000, 100, 5000);

    /// <summary>Acceleration of printing moves.</summary> <value>mm/s².</value>
    public double PrintAcceleration { get; init => field = Keys.Check(value); } = 800;

    /// <summary>Acceleration of travel moves.</summary> <value>mm/s².</value>
    public double TravelAcceleration { get; init => field = Keys.Check(value); } = 1000;

    /// <summary>Acceleration of retraction and deretraction.</summary> <value>mm/s².</value>
    public double RetractionAcceleration { get; init => field = Keys.Check(value); } = 1000;

    /// <summary>How the firmware limits speed in corners.</summary>
    public Cornering Cornering { get; init; } = Cornering.JunctionDeviation;

    /// <summary>Jerk of each axis, with cornering=jerk.</summary> <value>mm/s.</value>
    public AxisValues Jerk { get; init => field = Keys.Check(value); } = new(8, 8, 0.4, 5);

    /// <summary>Junction deviation, with cornering=junction_deviation.</summary> <value>mm.</value>
    public double JunctionDeviation { get; init => field = Keys.Check(value); } = 0.013;

    /// <summary>Square corner velocity, with cornering=square_corner_velocity.</summary> <value>mm/s.</value>
    public double SquareCornerVelocity { get; init => field = Keys.Check(value); } = 5;

    /// <summary>Klipper's minimum cruise ratio.</summary>
    public double MinimumCruiseRatio { get; init => field = Keys.Check(value); }

    /// <summary>Klipper's instantaneous corner velocity of the extruder, with cornering=square_corner_velocity.</summary> <value>mm/s.</value>
    public double InstantaneousCornerVelocity { get; init => field = Keys.Check(value); } = 1;

    /// <summary>Number of moves that the firmware plans ahead; 0 = all.</summary>
    public int LookaheadMoves { get; init => field = Keys.Check(value); } = 16;

    /// <summary>Length of the segments that the firmware divides arcs into.</summary> <value>mm.</value>
    public double ArcSegment { get; init => field = Keys.Check(value); } = 1;

    /// <summary>Heating rate of the nozzle, in °C per second; 0 = do not count heating in print times.</summary> <value>°C/s.</value>
    public double NozzleHeating { get; init => field = Keys.Check(value); } = 2;

    /// <summary>Heating rate of the bed, in °C per second; 0 = do not count heating in print times.</summary> <value>°C/s.</value>
    public double BedHeating { get; init => field = Keys.Check(value); } = 0.5;

    /// <summary>Time of a tool change, not counting its moves.</summary> <value>s.</value>
    public double ToolChangeTime { get; init => field = Keys.Check(value); }

    /// <summary>Time of homing.</summary> <value>s.</value>
    public double HomingTime { get; init => field = Keys.Check(value); }
}

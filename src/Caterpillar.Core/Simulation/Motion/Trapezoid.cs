namespace Caterpillar.Simulation;

/// <summary>
/// Speed along a straight move: constant acceleration to a peak, constant speed, constant deceleration. Speeds in mm/s, acceleration in mm/s², time in seconds;
/// for moves in place the distance is that of the filament.
/// </summary>
/// <param name="Start">Speed at the start.</param>
/// <param name="Peak">Highest speed.</param>
/// <param name="End">Speed at the end.</param>
/// <param name="Acceleration">Acceleration at both ends; 0 where the machine waits.</param>
/// <param name="Duration">Time in all.</param>
internal readonly record struct Trapezoid(double Start, double Peak, double End, double Acceleration, double Duration)
{
    /// <summary>Seconds of acceleration.</summary>
    public double Accelerating => Acceleration > 0 ? (Peak - Start) / Acceleration : 0;

    /// <summary>Seconds of deceleration.</summary>
    public double Decelerating => Acceleration > 0 ? (Peak - End) / Acceleration : 0;

    /// <summary>Distance in all, mm.</summary>
    public double Length => DistanceAt(Duration);

    /// <summary>Speed after some seconds from the start.</summary>
    public double SpeedAt(double time)
    {
        time = Math.Min(Math.Max(time, 0), Duration);
        return Math.Min(Math.Min(Peak, Start + Acceleration * time), End + Acceleration * (Duration - time));
    }

    /// <summary>Distance in mm after some seconds from the start.</summary>
    public double DistanceAt(double time)
    {
        time = Math.Min(Math.Max(time, 0), Duration);
        var up = Math.Min(time, Accelerating);
        var down = Math.Max(time - (Duration - Decelerating), 0);
        return (Start + Acceleration / 2 * up) * up + Peak * Math.Max(time - up - down, 0) + (Peak - Acceleration / 2 * down) * down;
    }

    /// <summary>Seconds from the start until a distance in mm is covered.</summary>
    public double TimeAt(double distance)
    {
        if (!(Acceleration > 0) || distance <= 0) return 0;
        var up = (Start + Peak) / 2 * Accelerating;
        if (distance < up) return 2 * distance / (Start + Math.Sqrt(Start * Start + 2 * Acceleration * distance));
        var left = Length - distance;
        if (left <= 0) return Duration;
        var down = (End + Peak) / 2 * Decelerating;
        if (left < down) return Duration - 2 * left / (End + Math.Sqrt(End * End + 2 * Acceleration * left));
        return Accelerating + (distance - up) / Peak;
    }

    /// <summary>
    /// The trapezoid over a length in mm between two speeds, up to a peak that must be reachable; speeds are given as squares, as all planning is.
    /// </summary>
    internal static Trapezoid Over(double length, double start2, double peak2, double end2, double acceleration)
    {
        var start = Math.Sqrt(start2);
        var peak = Math.Sqrt(peak2);
        var end = Math.Sqrt(end2);
        var cruise = Math.Max(length - (2 * peak2 - start2 - end2) / (2 * acceleration), 0);
        return new Trapezoid(start, peak, end, acceleration, (2 * peak - start - end) / acceleration + (peak > 0 ? cruise / peak : 0));
    }
}

namespace Caterpillar.Simulation;

/// <summary>How one family of firmware limits single moves and the corners between them.</summary>
internal abstract class CornerRules(MachineLimits limits)
{
    protected MachineLimits Limits { get; } = limits;

    /// <summary>
    /// Limits speed and acceleration of a move whose direction, length and wanted speed are known, and sets the speed from which it may stop at once.
    /// </summary>
    public abstract void Limit(ref StraightMove move);

    /// <summary>Square of the highest speed in the corner between two moves; at most the square of the speed of both.</summary>
    public abstract double Corner2(in StraightMove before, in StraightMove move);

    /// <summary>Most that the slower profile may change the square of the speed; NaN where there is no such profile.</summary>
    public virtual double SlowGain(in StraightMove move) => double.NaN;

    protected static double Square(double value) => value * value;
}

/// <summary>Marlin, RepRapFirmware and their like: limits for each axis, one acceleration for each kind of move.</summary>
internal abstract class AxisRules(MachineLimits limits) : CornerRules(limits)
{
    public override void Limit(ref StraightMove move)
    {
        move.Acceleration = Limits[move.InPlace ? MotionLimit.RetractionAcceleration
            : move.E != 0 ? MotionLimit.PrintAcceleration : MotionLimit.TravelAcceleration];
        move.Speed = Within(move.Speed, move, MotionLimit.SpeedX);
        move.Acceleration = Within(move.Acceleration, move, MotionLimit.AccelerationX);
    }

    /// <summary>The value, reduced so that no axis has more of it along the move than its limit.</summary>
    protected double Within(double value, in StraightMove move, MotionLimit first)
    {
        value = Axis(value, move.X, first);
        value = Axis(value, move.Y, first + 1);
        value = Axis(value, move.Z, first + 2);
        return Axis(value, move.E, first + 3);
    }

    private double Axis(double value, double part, MotionLimit limit)
    {
        part = Math.Abs(part);
        var most = Limits[limit];
        return value * part > most ? most / part : value;
    }
}

/// <summary>
/// Marlin's classic jerk (planner.cpp, <c>HAS_CLASSIC_JERK</c>), which PrusaSlicer's estimate follows: in a corner the speed of no axis may jump by more than
/// its jerk. From rest and to rest each axis may jump by as much.
/// </summary>
internal sealed class JerkRules(MachineLimits limits) : AxisRules(limits)
{
    // Below this part of the safe speeds it is faster to stop and start again.
    private const double Coasting = 0.99;

    public override void Limit(ref StraightMove move)
    {
        base.Limit(ref move);
        move.Rest = Within(move.Speed, move, MotionLimit.JerkX);
    }

    public override double Corner2(in StraightMove before, in StraightMove move)
    {
        // The speed of both sides at the corner is the lower of the two; the firmware scales the side before alone.
        var slower = Math.Min(before.Speed, move.Speed);
        var scale = slower / before.Speed;
        var factor = 1.0;
        Axis(before.X * before.Speed * scale, move.X * move.Speed, Limits[MotionLimit.JerkX], ref factor);
        Axis(before.Y * before.Speed * scale, move.Y * move.Speed, Limits[MotionLimit.JerkY], ref factor);
        Axis(before.Z * before.Speed * scale, move.Z * move.Speed, Limits[MotionLimit.JerkZ], ref factor);
        Axis(before.E * before.Speed * scale, move.E * move.Speed, Limits[MotionLimit.JerkE], ref factor);
        var corner = slower * factor;
        return Square(move.Rest > corner * Coasting && before.Rest > corner * Coasting ? Math.Min(move.Rest, slower) : corner);
    }

    // An axis that turns round may jump by its jerk on each side of rest.
    private static void Axis(double before, double after, double most, ref double factor)
    {
        before *= factor;
        after *= factor;
        var jump = before * after < 0 ? Math.Max(Math.Abs(before), Math.Abs(after)) : Math.Abs(after - before);
        if (jump > most) factor *= most / jump;
    }
}

/// <summary>
/// Junction deviation (Grbl; Marlin 2 in planner.cpp): the speed at which an arc that touches both moves and passes the corner at this distance needs no
/// more than the acceleration along the
/// bisector. E counts as an axis. Short pieces of a curve (below 1 mm, turning by less than 45°) are limited as the arc that they stand for.
/// </summary>
internal sealed class DeviationRules(MachineLimits limits) : AxisRules(limits)
{
    private const double Reversal = 0.999999;
    private const double ShortLength = 1;

    // Cosine of 135°.
    private const double GentleTurn = -0.7071067812;

    public override void Limit(ref StraightMove move)
    {
        base.Limit(ref move);
        move.PerNorm = PerNorm(move);
    }

    public override double Corner2(in StraightMove before, in StraightMove move)
    {
        var (a, b) = (before.PerNorm, move.PerNorm);
        // Cosine of the angle between the moves as lines from the corner: 1 straight back, −1 straight on.
        var cosine = -(before.X * move.X + before.Y * move.Y + before.Z * move.Z + before.E * move.E) * a * b;
        if (cosine > Reversal) return 0;
        var speed2 = Square(Math.Min(before.Speed, move.Speed));
        var bisector = new StraightMove
        {
            X = move.X * b - before.X * a, Y = move.Y * b - before.Y * a, Z = move.Z * b - before.Z * a, E = move.E * b - before.E * a,
        };
        var half = Math.Sqrt(0.5 * (1 - cosine));
        var c = PerNorm(bisector);
        (bisector.X, bisector.Y, bisector.Z, bisector.E) = (bisector.X * c, bisector.Y * c, bisector.Z * c, bisector.E * c);
        var acceleration = Within(move.Acceleration, bisector, MotionLimit.AccelerationX);
        var limit = half < 1 ? acceleration * Limits[MotionLimit.JunctionDeviation] * half / (1 - half) : double.PositiveInfinity;
        limit = Math.Min(limit, speed2);
        if (!(move.Length < ShortLength && cosine < GentleTurn)) return limit;
        // The turn is at most its tangent, which is enough to know for most curves.
        var tangent = Math.Sqrt(Math.Max(1 - cosine * cosine, 0)) / -cosine;
        return move.Length * acceleration >= limit * tangent ? limit : Math.Min(limit, move.Length * acceleration / Math.Atan(tangent));
    }

    // 1 over the length in X, Y, Z and E; 1 for none.
    private static double PerNorm(in StraightMove move)
    {
        var square = move.X * move.X + move.Y * move.Y + move.Z * move.Z + move.E * move.E;
        return square > 0 ? 1 / Math.Sqrt(square) : 1;
    }
}

/// <summary>
/// Klipper (toolhead.py, kinematics/extruder.py, kinematics/cartesian.py): one limit of speed and acceleration for the head, others for moves with Z and for
/// the extruder alone. In corners the square corner velocity, a circle that touches both moves at most in their middle, and a limit for the jump of the
/// extruder. Moves of the extruder alone begin and end at rest.
/// </summary>
internal sealed class SquareCornerRules(MachineLimits limits, double extruderJump) : CornerRules(limits)
{
    private static readonly double Sqrt2Minus1 = Math.Sqrt(2) - 1;

    public override void Limit(ref StraightMove move)
    {
        move.Acceleration = move.InPlace ? double.MaxValue : Limits.HeadAcceleration;
        // Kept with the move: a later change of the acceleration does not touch it.
        move.Deviation = Square(Limits[MotionLimit.SquareCornerVelocity]) * Sqrt2Minus1 / Limits.HeadAcceleration;
        if (!move.InPlace) move.Speed = Math.Min(move.Speed, Limits[MotionLimit.Speed]);
        if (move.Z != 0) Limit(ref move, Math.Abs(move.Z), Limits[MotionLimit.SpeedZ], Limits[MotionLimit.AccelerationZ]);
        if (move.E < 0 || (move.X == 0 && move.Y == 0))
        {
            var acceleration = Math.Min(Limits[MotionLimit.AccelerationE], Limits[MotionLimit.RetractionAcceleration]);
            Limit(ref move, Math.Abs(move.E), Limits[MotionLimit.SpeedE], acceleration);
        }
    }

    public override double Corner2(in StraightMove before, in StraightMove move)
    {
        if (before.InPlace || move.InPlace) return 0;
        var limit = Square(Math.Min(before.Speed, move.Speed));
        var change = move.E - before.E;
        if (change != 0) limit = Math.Min(limit, Square(extruderJump / change));
        var cosine = -(before.X * move.X + before.Y * move.Y + before.Z * move.Z);
        var sine = Math.Sqrt(Math.Max(0.5 * (1 - cosine), 0));
        var half = Math.Sqrt(Math.Max(0.5 * (1 + cosine), 0));
        if (!(sine < 1)) return limit;
        limit = Math.Min(limit, sine / (1 - sine) * Math.Min(before.Deviation * before.Acceleration, move.Deviation * move.Acceleration));
        var touch = 0.5 * sine / half;
        return Math.Min(limit, touch * Math.Min(move.Acceleration * move.Length, before.Acceleration * before.Length));
    }

    public override double SlowGain(in StraightMove move)
        => 2 * move.Length * Math.Min(move.Acceleration, Limits.HeadAcceleration * (1 - Limits[MotionLimit.MinimumCruiseRatio]));

    private static void Limit(ref StraightMove move, double part, double speed, double acceleration)
    {
        move.Speed = Math.Min(move.Speed, speed / part);
        move.Acceleration = Math.Min(move.Acceleration, acceleration / part);
    }
}

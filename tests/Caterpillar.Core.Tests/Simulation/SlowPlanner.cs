using System;
using System.Collections.Generic;
using System.Linq;

namespace Caterpillar.Tests.Simulation;

/// <summary>
/// A planner by brute force: starts with the highest speeds that corners allow and lowers them, again and again, until every one can be reached and
/// braked. Shares no code with the planner
/// that it judges. Whole queue only.
/// </summary>
internal static class SlowPlanner
{
    /// <summary>A straight piece: X, Y, Z and E in mm, wanted speed in mm/s.</summary>
    public readonly record struct Piece(double X, double Y, double Z, double E, double Speed)
    {
        public double Length => X == 0 && Y == 0 && Z == 0 ? Math.Abs(E) : Math.Sqrt(X * X + Y * Y + Z * Z);

        public bool InPlace => X == 0 && Y == 0 && Z == 0;

        public double[] Direction => [X / Length, Y / Length, Z / Length, E / Length];
    }

    /// <summary>Limits of four axes: X, Y, Z, E.</summary>
    public sealed record Machine(double[] Speed, double[] Acceleration, double[] Jerk, double Print, double Travel, double Retract);

    /// <summary>Seconds of each piece by classic jerk.</summary>
    public static double[] TimesByJerk(IReadOnlyList<Piece> pieces, Machine m)
    {
        var speed = pieces.Select(p => Math.Min(p.Speed, Least(p, m.Speed))).ToArray();
        var acceleration = pieces.Select(p => Math.Min(p.InPlace ? m.Retract : p.E != 0 ? m.Print : m.Travel, Least(p, m.Acceleration))).ToArray();
        var rest = pieces.Select((p, i) => Math.Min(speed[i], Least(p, m.Jerk))).ToArray();
        // Speed at the beginning of each piece, and at the end of the last.
        var v = new double[pieces.Count + 1];
        v[0] = rest[0];
        v[pieces.Count] = rest[pieces.Count - 1];
        for (var i = 1; i < pieces.Count; i++) v[i] = Corner(pieces[i - 1], pieces[i], speed[i - 1], speed[i], rest[i - 1], rest[i], m.Jerk);
        return Settle(pieces, speed, acceleration, v);
    }

    private static double Corner(Piece a, Piece b, double speedA, double speedB, double restA, double restB, double[] jerk)
    {
        var slower = Math.Min(speedA, speedB);
        var corner = slower;
        for (var axis = 0; axis < 4; axis++)
        {
            // The share of the slower speed that is still allowed scales both sides.
            var before = a.Direction[axis] * slower * (corner / slower);
            var after = b.Direction[axis] * speedB * (corner / slower);
            var jump = Math.Sign(before) * Math.Sign(after) < 0 ? Math.Max(Math.Abs(before), Math.Abs(after)) : Math.Abs(before - after);
            if (jump > jerk[axis]) corner *= jerk[axis] / jump;
        }
        return restA > 0.99 * corner && restB > 0.99 * corner ? Math.Min(restB, slower) : corner;
    }

    private static double[] Settle(IReadOnlyList<Piece> pieces, double[] speed, double[] acceleration, double[] v)
    {
        for (var changed = true; changed;)
        {
            changed = false;
            for (var i = 0; i < pieces.Count; i++)
            {
                var gain = 2 * acceleration[i] * pieces[i].Length;
                if (v[i + 1] * v[i + 1] > v[i] * v[i] + gain * (1 + 1e-13))
                {
                    v[i + 1] = Math.Sqrt(v[i] * v[i] + gain);
                    changed = true;
                }
                if (v[i] * v[i] > v[i + 1] * v[i + 1] + gain * (1 + 1e-13))
                {
                    v[i] = Math.Sqrt(v[i + 1] * v[i + 1] + gain);
                    changed = true;
                }
            }
        }
        return pieces.Select((p, i) => Time(p.Length, v[i], v[i + 1], speed[i], acceleration[i])).ToArray();
    }

    /// <summary>Time over a length between two speeds by small steps in mind: up, along, down.</summary>
    public static double Time(double length, double from, double to, double speed, double acceleration)
    {
        var up = (speed * speed - from * from) / (2 * acceleration);
        var down = (speed * speed - to * to) / (2 * acceleration);
        if (up + down <= length) return (speed - from) / acceleration + (length - up - down) / speed + (speed - to) / acceleration;
        var peak = Math.Sqrt((from * from + to * to) / 2 + acceleration * length);
        return (peak - from) / acceleration + (peak - to) / acceleration;
    }

    private static double Least(Piece p, double[] limits)
    {
        var least = double.PositiveInfinity;
        for (var axis = 0; axis < 4; axis++)
        {
            if (p.Direction[axis] != 0) least = Math.Min(least, limits[axis] / Math.Abs(p.Direction[axis]));
        }
        return least;
    }
}

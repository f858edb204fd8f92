namespace Caterpillar.Turtles;

// Arcs, circles and polygons: their vertices are computed from the pose at the start, so that they close exactly.
public sealed partial class Turtle
{
    // Deviation of the chords of arcs without a number of segments, mm.
    private const double ArcTolerance = 0.01;

    /// <summary>
    /// Draws an arc. Positive angles turn left, negative angles turn right. The heading stays tangent. With <paramref name="climb"/> the arc rises evenly along
    /// the up axis (a helix). Full turns without climb end exactly in the pose where they started.
    /// </summary>
    /// <param name="radius">mm, 0 or more.</param>
    /// <param name="angle">Angle of the arc.</param>
    /// <param name="climb">Rise along the up axis over the whole arc, mm.</param>
    /// <param name="segments">Number of chords; 0 = as many as the tolerance of the options needs.</param>
    public Turtle Arc(double radius, double angle, double climb = 0, int segments = 0)
    {
        if (!(radius >= 0) || double.IsInfinity(radius)) throw new ArgumentOutOfRangeException(nameof(radius), "The radius must be 0 mm or more.");
        if (segments is < 0 or > 1_000_000)
        {
            throw new ArgumentOutOfRangeException(nameof(segments),
                $"The number of segments must be 1 to 1000000, or 0 (automatic), not {NumberFormatter.Format(segments)}.");
        }
        var sweep = Degrees(angle);
        if (!(Math.Abs(sweep) <= 3.6e6)) throw new ArgumentOutOfRangeException(nameof(angle), "The angle must be at most 10000 turns.");
        var start = Pose;
        var count = segments > 0 ? segments : new Arc(Vec3.Zero, sweep).ChordCount(new Vec3(radius, 0), ArcTolerance);
        var side = sweep < 0 ? -1.0 : 1.0;
        for (var i = 1; i <= count; i++)
        {
            var (sin, cos) = Angle.SinCos(Math.Abs(sweep) * i / count);
            var t = i == count ? 1 : (double)i / count;
            MoveTo(start.Origin + start.X * (radius * sin) + start.Y * (side * radius * (1 - cos)) + start.Z * (climb * t), deposit: true);
        }
        return sweep % 360 == 0 ? Turn(start.WithOrigin(Position)) : Turn(start.WithOrigin(Position).Yaw(sweep));
    }

    /// <summary>Draws an exactly closed circle with its center on the left.</summary>
    /// <param name="radius">mm.</param>
    /// <param name="segments">Number of chords; 0 = as many as the tolerance of the options needs.</param>
    public Turtle Circle(double radius, int segments = 0) => Arc(radius, AngleUnit == AngleUnit.Radians ? 2 * Math.PI : 360, 0, segments);

    /// <summary>Draws an exactly closed regular polygon that starts forward and turns left. A negative side turns right. The pose stays the same.</summary>
    /// <param name="sides">3 or more.</param>
    /// <param name="side">mm.</param>
    public Turtle Polygon(int sides, double side)
    {
        if (sides is < 3 or > 1_000_000) throw new ArgumentOutOfRangeException(nameof(sides), "The number of sides must be 3 to 1000000.");
        var start = Pose;
        var hand = side < 0 ? -1.0 : 1.0;
        var length = Math.Abs(side);
        for (var i = 0; i < sides; i++)
        {
            var (sin, cos) = Angle.SinCos(360.0 * i / sides);
            MoveTo(i == sides - 1 ? start.Origin : Position + start.X * (length * cos) + start.Y * (hand * length * sin), deposit: true);
        }
        return this;
    }

    /// <summary>Draws a circle around the turtle and returns. The moves to and from the circle do not print. Heading and position stay the same.</summary>
    public Turtle CircleAround(double radius, int segments = 0)
    {
        var start = Pose;
        MoveTo(start.Origin + start.X * radius, deposit: false);
        Turn(Pose.Yaw(90));
        Circle(radius, segments);
        Turn(start.WithOrigin(Position));
        return MoveTo(start.Origin, deposit: false);
    }
}

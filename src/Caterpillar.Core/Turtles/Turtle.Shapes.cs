using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Turtles;

// Arcs, circles and polygons: their vertices are computed from the pose at the start, so that they close exactly.
public sealed partial class Turtle
{
    /// <summary>
    /// Walks along an arc of a radius while turning by an angle: positive to the left, negative to the right. The heading stays tangent; with
    /// <paramref name="climb"/> the arc rises evenly along up (a helix). Full turns without climb end exactly in the pose where they started.
    /// </summary>
    /// <param name="radius">mm, 0 or more.</param>
    /// <param name="angle">Angle of the turn.</param>
    /// <param name="climb">mm along up over the whole arc.</param>
    /// <param name="segments">Number of chords; 0 for as many as the options' tolerance needs.</param>
    public Turtle Arc(double radius, double angle, double climb = 0, int segments = 0)
    {
        if (!(radius >= 0) || double.IsInfinity(radius)) throw new ArgumentOutOfRangeException(nameof(radius), "A radius must be 0 mm or more.");
        if (segments is < 0 or > 1_000_000)
        {
            throw new ArgumentOutOfRangeException(nameof(segments),
                $"The number of segments must be 1 to a million, or 0 for as many as it takes, not {NumberFormatter.Format(segments)}.");
        }
        var sweep = Degrees(angle);
        if (double.IsNaN(sweep) || Math.Abs(sweep) > 3.6e6) throw new ArgumentOutOfRangeException(nameof(angle), "An arc can turn up to ten thousand times.");
        var start = Pose;
        var count = segments > 0 ? segments : new Arc(Vec3.Zero, sweep).ChordCount(new Vec3(radius, 0), _options.ArcTolerance);
        var side = sweep < 0 ? -1.0 : 1.0;
        for (var i = 1; i <= count; i++)
        {
            var (sin, cos) = Angle.SinCos(Math.Abs(sweep) * i / count);
            var t = i == count ? 1 : (double)i / count;
            MoveTo(start.Origin + start.X * (radius * sin) + start.Y * (side * radius * (1 - cos)) + start.Z * (climb * t), deposit: true);
        }
        return sweep % 360 == 0 ? Turn(start.WithOrigin(Position)) : Turn(start.WithOrigin(Position).Yaw(sweep));
    }

    /// <summary>A circle with its center on the left, closed exactly.</summary>
    /// <param name="radius">mm.</param>
    /// <param name="segments">Number of chords; 0 for as many as the options' tolerance needs.</param>
    public Turtle Circle(double radius, int segments = 0) => Arc(radius, AngleUnit == AngleUnit.Radians ? 2 * Math.PI : 360, 0, segments);

    /// <summary>A regular polygon that starts along forward and turns left, or right with a negative side; it closes exactly and the pose stays.</summary>
    /// <param name="sides">3 or more.</param>
    /// <param name="side">mm.</param>
    public Turtle Polygon(int sides, double side)
    {
        if (sides is < 3 or > 1_000_000) throw new ArgumentOutOfRangeException(nameof(sides), "A polygon has three sides or more, and at max a million.");
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

    /// <summary>A circle around the turtle: moves to it without printing, goes around once by chords and returns. Heading and position stay.</summary>
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

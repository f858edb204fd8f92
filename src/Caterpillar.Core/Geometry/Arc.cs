namespace Caterpillar.Geometry;

/// <summary>Plane of an arc, as in G17, G18 and G19. Counterclockwise is from the first axis to the second.</summary>
public enum ArcPlane : byte
{
    /// <summary>G17: X to Y, helix along Z.</summary>
    XY,

    /// <summary>G18: Z to X, helix along Y.</summary>
    ZX,

    /// <summary>G19: Y to Z, helix along X.</summary>
    YZ,
}

/// <summary>
/// Center, plane and sweep of an arc or helix. Its start and end are stored elsewhere and passed to the methods. The coordinate normal to the plane changes
/// linearly. The radius is measured at the start. If the end is slightly off the circle, the radius changes linearly.
/// </summary>
/// <param name="Center">Center, mm. The coordinate normal to the plane has no meaning.</param>
/// <param name="Sweep">Angle in degrees, positive counterclockwise. ±360 is a full turn; larger values are allowed.</param>
/// <param name="Plane">Plane of the arc.</param>
public readonly record struct Arc(Vec3 Center, double Sweep, ArcPlane Plane = ArcPlane.XY)
{
    /// <summary>Number of turns, rounded up: 1 up to a full circle, 2 beyond. At most 10⁶.</summary>
    public int Turns => (int)Math.Min(Math.Max(Math.Ceiling(Math.Abs(Sweep) / 360 - 1e-6), 1), 1e6);

    /// <summary>Radius in mm at the start.</summary>
    public double Radius(Vec3 start)
    {
        var (u, v, _) = Local(start);
        return Math.Sqrt(u * u + v * v);
    }

    /// <summary>Length in mm of the helix from start to end, with the radius of the start.</summary>
    public double Length(Vec3 start, Vec3 end)
    {
        var turn = Radius(start) * Math.Abs(Angle.ToRadians(Sweep));
        var rise = Across(end) - Across(start);
        return Math.Sqrt(turn * turn + rise * rise);
    }

    /// <summary>The point at parameter <paramref name="t"/> from start (0) to end (1).</summary>
    public Vec3 PointAt(Vec3 start, Vec3 end, double t)
    {
        if (t <= 0) return start;
        if (t >= 1) return end;
        var (u, v, w) = Local(start);
        var (eu, ev, ew) = Local(end);
        var radius = Math.Sqrt(u * u + v * v);
        var scale = radius > 0 ? 1 + (Math.Sqrt(eu * eu + ev * ev) / radius - 1) * t : 1;
        var (sin, cos) = Angle.SinCos(Sweep * t);
        return World((u * cos - v * sin) * scale, (v * cos + u * sin) * scale, w + (ew - w) * t);
    }

    /// <summary>The point at parameter <paramref name="t"/> of a segment, which is straight without an arc.</summary>
    internal static Vec3 PointAt(Arc? arc, Vec3 start, Vec3 end, double t) => arc is { } turn ? turn.PointAt(start, end, t) : Vec3.Lerp(start, end, t);

    /// <summary>The bounding box of the arc from start to end, mm, with the radius of the start.</summary>
    public Bounds Bounds(Vec3 start, Vec3 end)
    {
        var box = new GrowingBox();
        box.Include(start);
        box.Include(end);
        box.Include(this, start, end);
        return box.ToBounds();
    }

    /// <summary>Number of equal chords that deviate from the arc by at most <paramref name="tolerance"/> mm, at least 1.</summary>
    public int ChordCount(Vec3 start, double tolerance)
    {
        if (!(tolerance > 0)) throw new ArgumentOutOfRangeException(nameof(tolerance), "The tolerance must be positive.");
        var radius = Radius(start);
        // Half the angle of a chord whose sagitta is the tolerance: r(1 - cos a) = tolerance.
        var half = tolerance >= radius ? 90 : Angle.ToDegrees(Math.Acos(1 - tolerance / radius));
        var count = Math.Ceiling(Math.Abs(Sweep) / (2 * half) - 1e-9);
        return (int)Math.Min(Math.Max(count, 1), 1_000_000);
    }

    /// <summary>The same for an end that may be on a larger circle.</summary>
    public int ChordCount(Vec3 start, Vec3 end, double tolerance) => Math.Max(ChordCount(start, tolerance), ChordCount(end, tolerance));

    /// <summary>The arc from end to start.</summary>
    public Arc Reversed() => this with { Sweep = -Sweep };

    /// <summary>The coordinate normal to the plane.</summary>
    internal double Across(Vec3 p) => Plane switch { ArcPlane.XY => p.Z, ArcPlane.ZX => p.Y, _ => p.X };

    /// <summary>Coordinates in the plane from the center, and normal to it, so that positive angles turn counterclockwise.</summary>
    internal (double U, double V, double W) Local(Vec3 p)
    {
        var d = p - Center;
        return Plane switch { ArcPlane.XY => (d.X, d.Y, p.Z), ArcPlane.ZX => (d.Z, d.X, p.Y), _ => (d.Y, d.Z, p.X) };
    }

    /// <summary>The inverse of <see cref="Local"/>.</summary>
    internal Vec3 World(double u, double v, double w) => Plane switch
    {
        ArcPlane.XY => new Vec3(Center.X + u, Center.Y + v, w),
        ArcPlane.ZX => new Vec3(Center.X + v, w, Center.Z + u),
        _ => new Vec3(w, Center.Y + u, Center.Z + v),
    };
}

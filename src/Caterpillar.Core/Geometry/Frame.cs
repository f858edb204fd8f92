namespace Caterpillar.Geometry;

/// <summary>
/// A right-handed coordinate system: an origin and three perpendicular unit axes. For a turtle, X is forward, Y left and Z up. Rotations are about the
/// frame's own axes and keep them orthonormal, so that a million turns do not drift.
/// </summary>
public readonly record struct Frame
{
    /// <summary>Origin, mm.</summary>
    public Vec3 Origin { get; }

    /// <summary>X axis, a unit vector.</summary>
    public Vec3 X { get; }

    /// <summary>Y axis, a unit vector perpendicular to X.</summary>
    public Vec3 Y { get; }

    /// <summary>Z axis, the unit vector X × Y.</summary>
    public Vec3 Z { get; }

    private Frame(Vec3 origin, Vec3 x, Vec3 y, Vec3 z) => (Origin, X, Y, Z) = (origin, x, y, z);

    /// <summary>The world axes at the origin.</summary>
    public static Frame World => new(Vec3.Zero, Vec3.UnitX, Vec3.UnitY, Vec3.UnitZ);

    /// <summary>The world axes at a point (mm).</summary>
    public static Frame At(Vec3 origin) => new(origin, Vec3.UnitX, Vec3.UnitY, Vec3.UnitZ);

    /// <summary>A frame whose X axis points along <paramref name="x"/> and whose XY plane contains <paramref name="y"/>.</summary>
    /// <exception cref="ArgumentException">The directions are zero, not finite, or parallel.</exception>
    public static Frame FromAxes(Vec3 origin, Vec3 x, Vec3 y)
    {
        var ux = x.Unit();
        var uz = Vec3.Cross(ux, y.Unit()).Unit();
        if (!(ux.LengthSquared > 0.5) || !(uz.LengthSquared > 0.5))
            throw new ArgumentException("The axes of a frame must not be parallel or zero.", nameof(y));
        return new Frame(origin, ux, Vec3.Cross(uz, ux), uz);
    }

    /// <summary>The same axes at another origin, mm.</summary>
    public Frame WithOrigin(Vec3 origin) => new(origin, X, Y, Z);

    /// <summary>Converts a point from frame coordinates to world coordinates.</summary>
    public Vec3 ToWorld(Vec3 local) => Origin + X * local.X + Y * local.Y + Z * local.Z;

    /// <summary>Converts a point from world coordinates to frame coordinates.</summary>
    public Vec3 ToLocal(Vec3 world)
    {
        var d = world - Origin;
        return new Vec3(Vec3.Dot(d, X), Vec3.Dot(d, Y), Vec3.Dot(d, Z));
    }

    /// <summary>Turns about Z, in degrees: positive from X toward Y (a turtle turns left).</summary>
    public Frame Yaw(double degrees)
    {
        var (sin, cos) = Angle.SinCos(degrees);
        return Orthonormal(X * cos + Y * sin, Y * cos - X * sin);
    }

    /// <summary>Turns about Y, in degrees: positive from X toward Z (nose up). This is left-handed about Y.</summary>
    public Frame Pitch(double degrees)
    {
        var (sin, cos) = Angle.SinCos(degrees);
        return Orthonormal(X * cos + Z * sin, Y);
    }

    /// <summary>Turns about X, in degrees: positive from Y toward Z (the left side rises).</summary>
    public Frame Roll(double degrees)
    {
        var (sin, cos) = Angle.SinCos(degrees);
        return Orthonormal(X, Y * cos + Z * sin);
    }

    public override string ToString() => $"{Origin}, X {X}, Y {Y}";

    // One Gram-Schmidt step; for axes that are unit to rounding it leaves exact right angles exact.
    private Frame Orthonormal(Vec3 x, Vec3 y)
    {
        x = Normalized(x);
        y = Normalized(y - x * Vec3.Dot(x, y));
        return new Frame(Origin, x, y, Vec3.Cross(x, y));
    }

    private static Vec3 Normalized(Vec3 v) => v * (1.5 - 0.5 * v.LengthSquared);
}

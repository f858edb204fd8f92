namespace Caterpillar.Geometry;

/// <summary>
/// An affine transform: the images of the three axes and a translation in mm. Immutable. It maps points by
/// <c>p ↦ XAxis·p.X + YAxis·p.Y + ZAxis·p.Z + Shift</c>.
/// </summary>
/// <param name="XAxis">Image of the X axis.</param>
/// <param name="YAxis">Image of the Y axis.</param>
/// <param name="ZAxis">Image of the Z axis.</param>
/// <param name="Shift">Image of the origin, mm.</param>
public readonly record struct Affine(Vec3 XAxis, Vec3 YAxis, Vec3 ZAxis, Vec3 Shift)
{
    /// <summary>The transform that changes nothing.</summary>
    public static Affine Identity => new(Vec3.UnitX, Vec3.UnitY, Vec3.UnitZ, Vec3.Zero);

    /// <summary>Factor by which volumes change: negative if the transform mirrors, zero if it is singular.</summary>
    public double Determinant => Vec3.Dot(XAxis, Vec3.Cross(YAxis, ZAxis));

    /// <summary>A translation, mm.</summary>
    public static Affine Move(Vec3 shift) => new(Vec3.UnitX, Vec3.UnitY, Vec3.UnitZ, shift);

    /// <summary>A uniform scale about the origin.</summary>
    public static Affine Scale(double factor) => Scale(factor, factor, factor);

    /// <summary>A scale along the world axes, about the origin.</summary>
    public static Affine Scale(double x, double y, double z) => new(new Vec3(x, 0), new Vec3(0, y), new Vec3(0, 0, z), Vec3.Zero);

    /// <summary>
    /// A rotation about an axis through the origin, in degrees, counterclockwise when the axis points at the viewer. Multiples of 90° about a world
    /// axis are exact.
    /// </summary>
    /// <exception cref="ArgumentException">The axis is zero.</exception>
    public static Affine Rotate(Vec3 axis, double degrees)
    {
        var u = axis.Unit();
        if (!(u.LengthSquared > 0.5)) throw new ArgumentException("The axis of a rotation must not be zero.", nameof(axis));
        var (sin, cos) = Angle.SinCos(degrees);
        Vec3 Turn(Vec3 p) => p * cos + Vec3.Cross(u, p) * sin + u * (Vec3.Dot(u, p) * (1 - cos));
        return new Affine(Turn(Vec3.UnitX), Turn(Vec3.UnitY), Turn(Vec3.UnitZ), Vec3.Zero);
    }

    /// <summary>The transform from frame coordinates to world coordinates.</summary>
    public static Affine FromFrame(Frame frame) => new(frame.X, frame.Y, frame.Z, frame.Origin);

    /// <summary>The transform from world coordinates to frame coordinates.</summary>
    public static Affine ToFrame(Frame frame) => new(new Vec3(frame.X.X, frame.Y.X, frame.Z.X), new Vec3(frame.X.Y, frame.Y.Y, frame.Z.Y),
        new Vec3(frame.X.Z, frame.Y.Z, frame.Z.Z), frame.ToLocal(Vec3.Zero));

    /// <summary>The image of a point.</summary>
    public Vec3 Apply(Vec3 p) => XAxis * p.X + YAxis * p.Y + ZAxis * p.Z + Shift;

    /// <summary>The image of a direction, without the translation.</summary>
    public Vec3 ApplyDirection(Vec3 d) => XAxis * d.X + YAxis * d.Y + ZAxis * d.Z;

    /// <summary>The transform back. Not finite if the determinant is 0.</summary>
    public Affine Inverse
    {
        get
        {
            var volume = Determinant;
            Vec3 a = Vec3.Cross(YAxis, ZAxis) / volume, b = Vec3.Cross(ZAxis, XAxis) / volume, c = Vec3.Cross(XAxis, YAxis) / volume;
            var turn = new Affine(new Vec3(a.X, b.X, c.X), new Vec3(a.Y, b.Y, c.Y), new Vec3(a.Z, b.Z, c.Z), Vec3.Zero);
            return turn with { Shift = -turn.Apply(Shift) };
        }
    }

    /// <summary>True if vertical lines stay vertical and level planes level.</summary>
    public bool IsUpright => XAxis.Z == 0 && YAxis.Z == 0 && ZAxis.X == 0 && ZAxis.Y == 0;

    /// <summary>This transform followed by another.</summary>
    public Affine Then(Affine next)
        => new(next.ApplyDirection(XAxis), next.ApplyDirection(YAxis), next.ApplyDirection(ZAxis), next.Apply(Shift));

    public override string ToString() => $"X {XAxis}, Y {YAxis}, Z {ZAxis}, shift {Shift}";
}

namespace Caterpillar.Display;

/// <summary>
/// A parallel projection with the direction of the eye: azimuth, in degrees counterclockwise from +X, and elevation above the bed, −90 to 90 degrees.
/// </summary>
public sealed class View
{
    private readonly Vec3 _right;
    private readonly Vec3 _up;
    private readonly Vec3 _toEye;

    /// <summary>Azimuth in degrees counterclockwise from +X, and elevation in degrees above the bed, limited to −90 to 90.</summary>
    public View(double azimuth, double elevation)
    {
        var (sa, ca) = Angle.SinCos(azimuth);
        var (se, ce) = Angle.SinCos(Math.Max(-90, Math.Min(90, elevation)));
        _toEye = new Vec3(ca * ce, sa * ce, se);
        _right = new Vec3(-sa, ca, 0);
        _up = Vec3.Cross(_toEye, _right);
    }

    /// <summary>Top view, Y up in the image.</summary>
    public static View Top { get; } = new(-90, 90);

    /// <summary>Front view, Z up in the image.</summary>
    public static View Front { get; } = new(-90, 0);

    /// <summary>From the front right and above.</summary>
    public static View ThreeQuarter { get; } = new(-60, 28);

    /// <summary>Coordinates in the image: right, up and toward the eye, mm.</summary>
    public Vec3 Project(Vec3 point) => new(Vec3.Dot(point, _right), Vec3.Dot(point, _up), Vec3.Dot(point, _toEye));
}

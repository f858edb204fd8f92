namespace Caterpillar.Shaping;

/// <summary>A point on a path, as the argument of a <see cref="Field"/>.</summary>
/// <param name="Position">Midpoint of a segment, or a vertex, mm.</param>
/// <param name="Distance">Length of the path up to this point, mm.</param>
/// <param name="Length">Length of the whole path, mm.</param>
/// <param name="Path">Index of the path among all modulated paths, from 0.</param>
/// <param name="Role">Role of the extrusion.</param>
public readonly record struct PathSample(Vec3 Position, double Distance, double Length, int Path, Role Role);

/// <summary>Returns a value for a point on a path, 0 to 1 unless stated otherwise.</summary>
public delegate double Field(PathSample place);

/// <summary>
/// Maps a point on a path to an image: u from the left and v from the bottom, 0 to 1. Outside that range, the image repeats in u and is clamped in v.
/// </summary>
public delegate (double U, double V) ImageMapping(PathSample place);

/// <summary>Fields from images. Any other function of a <see cref="PathSample"/> is a field too.</summary>
public static class Fields
{
    /// <summary>The brightness of an image, 0 (black) to 1 (white), of the nearest pixel or, if <paramref name="smooth"/>, interpolated.</summary>
    public static Field Image(GrayImage image, ImageMapping mapping, bool smooth = false)
    {
        if (image is null) throw new ArgumentNullException(nameof(image));
        if (mapping is null) throw new ArgumentNullException(nameof(mapping));
        return place =>
        {
            var (u, v) = mapping(place);
            return smooth ? image.Between(u, v) : image.Nearest(u, v);
        };
    }
}

/// <summary>Mappings of images onto paths.</summary>
public static class ImageMappings
{
    /// <summary>
    /// Around a vertical axis: u is the angle (0 at <paramref name="from"/> degrees, <paramref name="repeats"/> times per turn), v the height from
    /// <paramref name="bottom"/> to <paramref name="top"/>, mm.
    /// </summary>
    public static ImageMapping Cylinder(double bottom, double top, Vec3 axis = default, double from = 0, int repeats = 1)
        => place =>
        {
            var d = place.Position - axis;
            var turn = (Angle.Atan2(d.Y, d.X) - from) / 360;
            return ((turn - Math.Floor(turn)) * repeats, (place.Position.Z - bottom) / (top - bottom));
        };

    /// <summary>Around a sphere, like a globe: u is the longitude, v the latitude from the south (0) to the north pole (1).</summary>
    public static ImageMapping Globe(Vec3 center, double from = 0)
        => place =>
        {
            var d = place.Position - center;
            var turn = (Angle.Atan2(d.Y, d.X) - from) / 360;
            return (turn - Math.Floor(turn), 0.5 + Angle.Atan2(d.Z, d.LengthXY) / 180);
        };

    /// <summary>From above, on a rectangle of the bed with a front left corner and a size in mm.</summary>
    public static ImageMapping Plan(Vec3 corner, double width, double depth)
        => place => ((place.Position.X - corner.X) / width, (place.Position.Y - corner.Y) / depth);

    /// <summary>Along the paths: u runs once along each path, and each path takes the next of <paramref name="rows"/> rows in v, from the bottom.</summary>
    public static ImageMapping Along(int rows)
        => place => (place.Length > 0 ? place.Distance / place.Length : 0, (place.Path % rows + 0.5) / rows);
}

namespace Caterpillar.Toolpaths;

/// <summary>Shape of a bead, which determines the width of an extrusion.</summary>
public enum BeadShape : byte
{
    /// <summary>Width × height (Caterpillar 2019).</summary>
    Rectangle,

    /// <summary>A rectangle with round sides, as slicers assume.</summary>
    Stadium,

    /// <summary>A round extrusion, printed in the air or through a wide gap (Kanada).</summary>
    Circle,
}

/// <summary>
/// The cross-section of an extrusion along a segment: area in mm², height in mm if known, and speed in mm/s. An area of 0 deposits nothing (a pen, a brush
/// or a bare hot tool).
/// </summary>
public readonly record struct Bead
{
    /// <summary>Cross-section in mm², 0 or more.</summary>
    public double Area { get; init => field = Check(value, nameof(Area)); }

    /// <summary>Layer height, mm. 0 = unknown.</summary>
    public double Height { get; init => field = Check(value, nameof(Height)); }

    /// <summary>Speed of the head, mm/s. 0 = speed of the print settings.</summary>
    public double Speed { get; init => field = Check(value, nameof(Speed)); }

    /// <exception cref="ArgumentOutOfRangeException">A value is negative or not finite.</exception>
    public Bead(double area, double height = 0, double speed = 0)
    {
        Area = area;
        Height = height;
        Speed = speed;
    }

    /// <summary>A bead from its width and height in mm. <paramref name="multiplier"/> scales the area.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A value is negative or not finite, or a stadium is narrower than it is high.</exception>
    public static Bead FromWidth(double width, double height, double multiplier = 1, double speed = 0, BeadShape shape = BeadShape.Rectangle)
    {
        Check(width, nameof(width));
        Check(height, nameof(height));
        var area = shape switch
        {
            BeadShape.Rectangle => width * height,
            BeadShape.Stadium => width >= height
                ? height * (width - height) + Math.PI / 4 * height * height
                : throw new ArgumentOutOfRangeException(nameof(width), "A stadium must be at least as wide as it is high."),
            _ => Math.PI / 4 * width * width,
        };
        return new Bead(area * Check(multiplier, nameof(multiplier)), height, speed);
    }

    /// <summary>
    /// Width of the extrusion, mm, from its shape, area and height. If the height is unknown, or a stadium would be narrower than high, the extrusion is round.
    /// </summary>
    public double Width(BeadShape shape = BeadShape.Rectangle)
    {
        if (Height <= 0 || shape == BeadShape.Circle) return Round();
        if (shape == BeadShape.Rectangle) return Area / Height;
        var width = Area / Height + Height * (1 - Math.PI / 4);
        return width >= Height ? width : Round();
    }

    private double Round() => 2 * Math.Sqrt(Area / Math.PI);

    public override string ToString()
    {
        var text = NumberFormatter.Format(Area, 4) + " mm²";
        if (Height > 0) text += ", " + NumberFormatter.Format(Height, 4) + " mm high";
        if (Speed > 0) text += ", " + NumberFormatter.Format(Speed, 3) + " mm/s";
        return text;
    }

    private static double Check(double value, string name)
        => value >= 0 && !double.IsInfinity(value) ? value : throw new ArgumentOutOfRangeException(name, "The values of a bead must be finite and 0 or more.");
}

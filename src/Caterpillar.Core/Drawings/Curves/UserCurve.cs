namespace Caterpillar.Drawings;

/// <summary>
/// A curve to print as drawn, with its own settings. Null settings come from <see cref="CurveOptions"/>. The area of the extrusion is set directly, or as
/// width × height × flow in the shape of the options. An area of 0 draws without extruding (pen, brush, bare hot tool).
/// </summary>
public sealed record UserCurve
{
    /// <summary>A curve without its own settings.</summary>
    public UserCurve(Curve curve) => Curve = curve ?? throw new ArgumentNullException(nameof(curve));

    /// <summary>A dot: material extruded in place at a point, mm³.</summary>
    public static UserCurve DotAt(Vec3 point, double volume) => new(new PolylineCurve([point, point])) { Dot = volume };

    /// <summary>The curve, mm.</summary>
    public Curve Curve { get; init; }

    /// <summary>Display name, or empty.</summary>
    public string Name { get; init; } = "";

    /// <summary>Area of the extrusion, mm².</summary>
    public double? Area { get; init; }

    /// <summary>Width of the extrusion, mm.</summary>
    public double? Width { get; init; }

    /// <summary>Height of the extrusion, mm.</summary>
    public double? Height { get; init; }

    /// <summary>Flow ratio of width × height.</summary>
    public double? Flow { get; init; }

    /// <summary>Material extruded in place at the start before the curve is drawn, mm³. A curve without length is only a dot.</summary>
    public double Dot { get; init; }

    /// <summary>Print speed, mm/s; 0 = printing speed of the settings.</summary>
    public double? Speed { get; init; }

    /// <summary>Settings that vary along the curve. They override the settings of the whole curve.</summary>
    public PointValues? Along { get; init; }

    /// <summary>Role of the extrusion.</summary>
    public Role Role { get; init; }

    /// <summary>Layer of the curve, or null.</summary>
    public Layer? Layer { get; init; }

    /// <summary>Number of the tool, from 0.</summary>
    public int Tool { get; init; }

    /// <summary>Temperature, fan and acceleration while it is printed.</summary>
    public PathOverrides? Overrides { get; init; }

    /// <summary>Location in the source file, for messages.</summary>
    public SourceLocation? Source { get; init; }
}

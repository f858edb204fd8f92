using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Drawings;

/// <summary>
/// A curve to print as drawn, with its own settings; null settings come from <see cref="CurveOptions"/>. The area of the extrusion is given directly,
/// or as width × height × multiplier in the shape of the options. An area of 0 makes a stroke without extrusion (pen, brush, bare hot tool).
/// </summary>
public sealed record UserCurve
{
    /// <summary>A curve that is printed with the settings of all.</summary>
    public UserCurve(Curve curve) => Curve = curve ?? throw new ArgumentNullException(nameof(curve));

    /// <summary>Material extruded in place at a point, mm³.</summary>
    public static UserCurve DotAt(Vec3 point, double volume) => new(new PolylineCurve([point, point])) { Dot = volume };

    /// <summary>The course, mm.</summary>
    public Curve Curve { get; init; }

    /// <summary>Display name, or empty.</summary>
    public string Name { get; init; } = "";

    /// <summary>Area of the extrusion, mm².</summary>
    public double? Area { get; init; }

    /// <summary>Width of the extrusion, mm.</summary>
    public double? Width { get; init; }

    /// <summary>Height of the extrusion, mm.</summary>
    public double? Height { get; init; }

    /// <summary>Scales the area from width × height.</summary>
    public double? Multiplier { get; init; }

    /// <summary>Material extruded in place at the start, before the curve is drawn, mm³; a curve without length is only a dot.</summary>
    public double Dot { get; init; }

    /// <summary>mm/s; 0 for the speed of the print settings.</summary>
    public double? Speed { get; init; }

    /// <summary>Settings that vary along the curve; they take precedence over those of the whole curve.</summary>
    public PointValues? Along { get; init; }

    /// <summary>What the extrusion is for.</summary>
    public Role Role { get; init; }

    /// <summary>The layer that the curve belongs to, if any.</summary>
    public Layer? Layer { get; init; }

    /// <summary>Number of the tool, from 0.</summary>
    public int Tool { get; init; }

    /// <summary>Temperature, fan and acceleration while it is printed.</summary>
    public PathOverrides? Overrides { get; init; }

    /// <summary>Where it was read from, for messages.</summary>
    public SourceLocation? Source { get; init; }
}

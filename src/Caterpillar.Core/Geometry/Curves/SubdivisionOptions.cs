namespace Caterpillar.Geometry;

/// <summary>
/// Options for <see cref="CurveSubdivider"/>, for the curved parts of a curve. The finest of all limits applies, but no segment becomes shorter than
/// <see cref="MinLength"/>. A curved part between two kinks that is shorter than that becomes one segment.
/// </summary>
public sealed record SubdivisionOptions
{
    /// <summary>Maximum length of a segment along the curve in mm ("subdivision distance" of Caterpillar 2019, section 4.1). 0 = no limit.</summary>
    public double Distance { get; init; }

    /// <summary>Maximum distance between curve and segment in mm. 0 = no limit.</summary>
    public double ChordTolerance { get; init; }

    /// <summary>Maximum turn of the curve along a segment in degrees. 0 = no limit.</summary>
    public double Angle { get; init; }

    /// <summary>Minimum length of a segment of a curved part, mm. Takes precedence over the other limits. 0 = no limit.</summary>
    public double MinLength { get; init; }

    /// <summary>Maximum length of a segment of a curved part, mm. 0 = no limit.</summary>
    public double MaxLength { get; init; }

    /// <summary>True divides every curved part evenly. False uses the full step, with a shorter last segment.</summary>
    public bool EqualDivision { get; init; } = true;

    /// <summary>True keeps arcs in horizontal planes as arcs (full circles as two halves).</summary>
    public bool KeepArcs { get; init; }

    /// <summary>Maximum deviation from the chord of parts that count as straight, mm.</summary>
    public double LinearTolerance { get; init; } = 1e-5;

    /// <summary>Division by distance along the curve, mm.</summary>
    public static SubdivisionOptions ByDistance(double distance) => new() { Distance = distance };

    /// <summary>Division by the distance between curve and chord, mm.</summary>
    public static SubdivisionOptions ByTolerance(double tolerance) => new() { ChordTolerance = tolerance };

    /// <exception cref="ArgumentException">A value is negative or not finite, no limit is set, or the lengths contradict each other.</exception>
    internal void Check()
    {
        foreach (var value in new[] { Distance, ChordTolerance, Angle, MinLength, MaxLength, LinearTolerance })
        {
            if (!(value >= 0) || double.IsInfinity(value)) throw new ArgumentException("The values of a subdivision must be 0 or more and finite.");
        }
        if (Distance == 0 && ChordTolerance == 0 && Angle == 0 && MaxLength == 0)
            throw new ArgumentException("A subdivision needs a distance, a tolerance, an angle or a maximum length.");
        if (MaxLength > 0 && MinLength > MaxLength) throw new ArgumentException("The minimum segment length must not exceed the maximum.");
    }
}

namespace Caterpillar.Geometry;

/// <summary>Options for <see cref="ArcFitter"/>.</summary>
public sealed record ArcFitOptions
{
    /// <summary>Maximum distance in mm between an arc and the vertices and chord midpoints that it replaces, also normal to the plane.</summary>
    public double Tolerance { get; init; } = 0.02;

    /// <summary>Minimum number of segments that an arc replaces.</summary>
    public int MinSegments { get; init; } = 3;

    /// <summary>Maximum radius in mm. Flatter runs stay straight.</summary>
    public double MaxRadius { get; init; } = 2000;

    /// <summary>Maximum sweep of one arc in degrees, at most 350. Firmware may read a nearly full turn as 0.</summary>
    public double MaxSweep { get; init; } = 330;

    /// <exception cref="ArgumentException">A value is out of range.</exception>
    internal void Check()
    {
        if (!(Tolerance > 0) || double.IsInfinity(Tolerance)) throw new ArgumentException("The tolerance of an arc must be positive.");
        if (MinSegments < 2) throw new ArgumentException("An arc must replace at least two segments.");
        if (!(MaxRadius > 0)) throw new ArgumentException("The maximum radius must be positive.");
        if (!(MaxSweep > 0 && MaxSweep <= 350)) throw new ArgumentException("The maximum sweep of an arc must be at most 350 degrees.");
    }
}

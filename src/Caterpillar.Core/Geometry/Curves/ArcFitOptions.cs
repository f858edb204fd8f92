using System;

namespace Caterpillar.Geometry;

/// <summary>What <see cref="ArcFitter"/> may do.</summary>
public sealed record ArcFitOptions
{
    /// <summary>Largest distance in mm between an arc and the vertices and chord middles it replaces; also across the plane.</summary>
    public double Tolerance { get; init; } = 0.02;

    /// <summary>Fewest segments that an arc replaces.</summary>
    public int MinSegments { get; init; } = 3;

    /// <summary>Largest radius in mm; flatter runs stay straight.</summary>
    public double MaxRadius { get; init; } = 2000;

    /// <summary>Largest turn of one arc in degrees, at most 350: firmware reads a nearly full turn as none.</summary>
    public double MaxSweep { get; init; } = 330;

    /// <exception cref="ArgumentException">A value is out of range.</exception>
    internal void Check()
    {
        if (!(Tolerance > 0) || double.IsInfinity(Tolerance)) throw new ArgumentException("The tolerance of an arc must be positive.");
        if (MinSegments < 2) throw new ArgumentException("An arc replaces at least two segments.");
        if (!(MaxRadius > 0)) throw new ArgumentException("The largest radius must be positive.");
        if (!(MaxSweep > 0 && MaxSweep <= 350)) throw new ArgumentException("The largest turn of an arc is at most 350 degrees.");
    }
}

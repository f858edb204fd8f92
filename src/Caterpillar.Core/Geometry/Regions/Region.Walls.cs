using System;

namespace Caterpillar.Geometry;

public sealed partial class Region
{
    /// <summary>
    /// Shrunk by a distance, without parts that are then thinner than a width: where two walls of that width would overlap, nothing remains. Shrinks by half a
    /// width more and grows back, with mitered corners.
    /// </summary>
    /// <param name="distance">mm; not negative.</param>
    /// <param name="thinnest">mm; not negative. With 0 this is a plain offset.</param>
    /// <exception cref="ArgumentException">A parameter is negative, not a number or too large.</exception>
    public Region Inset(double distance, double thinnest) => Inset(distance, thinnest, new RegionEngine());

    /// <summary>
    /// The parts narrower than a width (mm), which walls of that width leave open. Corners sharper than 60° and rounding leave small remnants: drop
    /// them with <see cref="WithoutSmallContours"/>.
    /// </summary>
    /// <exception cref="ArgumentException">The width is negative, not a number or too large.</exception>
    public Region NarrowerThan(double width) => NarrowerThan(width, new RegionEngine());

    internal Region Inset(double distance, double thinnest, RegionEngine engine)
    {
        if (!(distance >= 0)) throw new ArgumentException("The distance must not be negative.", nameof(distance));
        if (!(thinnest >= 0)) throw new ArgumentException("The width must not be negative.", nameof(thinnest));
        var shrunk = Offset(-distance - thinnest / 2, JoinStyle.Miter, 2, 0.005, engine);
        return shrunk.Offset(thinnest / 2, JoinStyle.Miter, 2, 0.005, engine);
    }

    internal Region NarrowerThan(double width, RegionEngine engine)
    {
        if (!(width >= 0)) throw new ArgumentException("The width must not be negative.", nameof(width));
        // Grown back slightly more than it was shrunk, so that rounding leaves no sliver along the boundary.
        var wide = Offset(-width / 2, JoinStyle.Miter, 2, 0.005, engine).Offset(width / 2 + 5e-5, JoinStyle.Miter, 2, 0.005, engine);
        return Subtract(wide, engine);
    }
}

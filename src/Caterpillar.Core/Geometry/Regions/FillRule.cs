namespace Caterpillar.Geometry;

/// <summary>Which points count as inside, by the winding number of the contours around them.</summary>
public enum FillRule
{
    /// <summary>Every winding number but zero: the rule for solids whose bodies may overlap.</summary>
    NonZero,

    /// <summary>Odd winding numbers: overlaps cancel; orientation has no meaning.</summary>
    EvenOdd,

    /// <summary>Winding numbers above zero: areas only inside clockwise contours are outside.</summary>
    Positive,
}

namespace Caterpillar.Geometry;

/// <summary>Points that count as inside, by the winding number of the contours around them.</summary>
public enum FillRule
{
    /// <summary>Every winding number but zero: the rule for solids whose bodies may overlap.</summary>
    NonZero,

    /// <summary>Odd winding numbers: overlaps cancel, and orientation has no meaning.</summary>
    EvenOdd,

    /// <summary>Winding numbers above zero: areas inside clockwise contours only are outside.</summary>
    Positive,
}

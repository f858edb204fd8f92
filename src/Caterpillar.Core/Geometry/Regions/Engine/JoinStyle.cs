namespace Caterpillar.Geometry;

/// <summary>How an offset goes around a convex corner.</summary>
public enum JoinStyle
{
    /// <summary>The edges are extended until they meet; beyond the miter limit the corner is cut as in <see cref="Square"/>.</summary>
    Miter,

    /// <summary>An arc around the corner, as chords within the arc tolerance.</summary>
    Round,

    /// <summary>The corner is cut straight at the offset distance from the corner of the source.</summary>
    Square,
}

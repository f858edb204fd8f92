namespace Caterpillar.Geometry;

/// <summary>Shape of an offset at a convex corner.</summary>
public enum JoinStyle
{
    /// <summary>Edges are extended until they meet. Beyond the miter limit, the corner is cut as in <see cref="Square"/>.</summary>
    Miter,

    /// <summary>An arc around the corner, as chords within the arc tolerance.</summary>
    Round,

    /// <summary>The corner is cut straight at the offset distance from the original corner.</summary>
    Square,
}

namespace Caterpillar.Geometry;

/// <summary>How an offset goes around a corner that turns away from it.</summary>
public enum JoinStyle
{
    /// <summary>The edges are prolonged until they meet; beyond the miter limit the corner is cut as in <see cref="Square"/>.</summary>
    Miter,

    /// <summary>An arc around the corner, by chords within the arc tolerance.</summary>
    Round,

    /// <summary>The corner is cut straight at the offset distance from the corner of the source.</summary>
    Square,
}

namespace Caterpillar.Machines;

/// <summary>Start of outer walls.</summary>
public enum SeamPosition : byte
{
    /// <summary>In a corner if possible, above the seam of the layer below.</summary>
    Aligned,

    /// <summary>Nearest to the end of the previous path.</summary>
    Nearest,

    /// <summary>At the back (+Y).</summary>
    Rear,

    /// <summary>Facing a point.</summary>
    Point,

    /// <summary>At a random point.</summary>
    Random,

    /// <summary>In the sharpest concave corner of each layer.</summary>
    Corner,
}

/// <summary>Order of walls.</summary>
public enum WallOrder : byte
{
    /// <summary>Outer wall last, supported by the inner walls.</summary>
    InsideOut,

    /// <summary>Outer wall first, for accurate dimensions.</summary>
    OutsideIn,

    /// <summary>Alternating from layer to layer.</summary>
    Alternating,
}

/// <summary>Order of walls with overhangs.</summary>
public enum OverhangWallOrder : byte
{
    /// <summary>Same as other walls.</summary>
    Same,

    InsideOut,

    OutsideIn,
}

/// <summary>A seam enforcer: a sphere.</summary>
/// <param name="Place">Center, mm.</param>
/// <param name="Radius">mm.</param>
public readonly record struct SeamMark(Vec3 Place, double Radius)
{
    internal static string? Problem(ValueList<SeamMark> marks) => marks.All(m => m.Radius > 0) ? null : "must have radii above 0";
}

using Caterpillar.Geometry;

namespace Caterpillar.Machines;

/// <summary>Where the outer walls begin and end.</summary>
public enum SeamPosition : byte
{
    /// <summary>In a corner where there is one, above the seam of the layer below.</summary>
    Aligned,

    /// <summary>Where the head comes from.</summary>
    Nearest,

    /// <summary>At the back (+Y).</summary>
    Rear,

    /// <summary>On the side of a point.</summary>
    Point,

    /// <summary>Anywhere.</summary>
    Random,

    /// <summary>In the most concave corner of each layer.</summary>
    Corner,
}

/// <summary>The order of the walls of a contour.</summary>
public enum WallOrder : byte
{
    /// <summary>The outer wall last: it leans on the others.</summary>
    InsideOut,

    /// <summary>The outer wall first: it lies exactly where it should.</summary>
    OutsideIn,

    /// <summary>One layer this way, the next the other.</summary>
    Alternating,
}

/// <summary>The order of the walls of contours that hang over the layer below.</summary>
public enum OverhangWallOrder : byte
{
    /// <summary>That of all walls.</summary>
    Same,

    InsideOut,

    OutsideIn,
}

/// <summary>A painted place for seams: a ball around a point.</summary>
/// <param name="Place">Center, mm.</param>
/// <param name="Radius">mm.</param>
public readonly record struct SeamMark(Vec3 Place, double Radius)
{
    internal static SeamMark? Of(double[] n) => new SeamMark(new Vec3(n[0], n[1], n[2]), n[3]);

    internal static string? Problem(ValueList<SeamMark> marks)
    {
        foreach (var mark in marks)
        {
            if (!(mark.Radius > 0)) return "must have radii above 0";
        }
        return null;
    }
}

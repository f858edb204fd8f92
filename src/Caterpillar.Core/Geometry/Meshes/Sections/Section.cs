namespace Caterpillar.Geometry;

/// <summary>A plane section of a mesh at one height. Immutable.</summary>
internal sealed class Section(double z, IReadOnlyList<Polyline> loops, IReadOnlyList<Polyline> openLines, ClosedGaps gaps = default)
{
    /// <summary>Height of the plane in mm.</summary>
    public double Z { get; } = z;

    /// <summary>
    /// Closed contours with the solid on their left: outer ones counterclockwise seen from above, holes clockwise. They may cross where bodies
    /// intersect. Every contour has at least three points.
    /// </summary>
    public IReadOnlyList<Polyline> Loops { get; } = loops;

    /// <summary>Contours that do not close: sections of open surfaces, with the outside of the surface on their right.</summary>
    public IReadOnlyList<Polyline> OpenLines { get; } = openLines;

    /// <summary>Segments added to close contours of a broken mesh.</summary>
    public ClosedGaps Gaps { get; } = gaps;

    /// <summary>Number of loose ends: two for each open line.</summary>
    public int OpenEnds => 2 * OpenLines.Count;
}

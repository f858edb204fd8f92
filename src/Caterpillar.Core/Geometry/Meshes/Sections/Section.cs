namespace Caterpillar.Geometry;

/// <summary>A plane section of a mesh at one height. Immutable.</summary>
/// <param name="Z">Height of the plane in mm.</param>
/// <param name="Loops">
/// Closed contours with the solid on their left: outer ones counterclockwise seen from above, holes clockwise. They may cross where bodies intersect. Every
/// contour has at least three points.
/// </param>
/// <param name="OpenLines">Contours that do not close: sections of open surfaces, with the outside of the surface on their right.</param>
/// <param name="Gaps">Segments added to close contours of a broken mesh.</param>
internal sealed record Section(double Z, IReadOnlyList<Polyline> Loops, IReadOnlyList<Polyline> OpenLines, ClosedGaps Gaps = default)
{
    /// <summary>Number of loose ends: two for each open line.</summary>
    public int OpenEnds => 2 * OpenLines.Count;
}

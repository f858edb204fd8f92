namespace Caterpillar.Geometry;

/// <summary>Gaps in the contours of a section that were closed by straight segments.</summary>
/// <param name="Count">Number of gaps, with those of no width where the parts of a contour belong to triangles that are not joined.</param>
/// <param name="Length">Sum of their widths, mm.</param>
/// <param name="Widest">mm.</param>
internal readonly record struct ClosedGaps(int Count, double Length, double Widest);

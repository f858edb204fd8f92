namespace Caterpillar.Slicing;

/// <summary>Loops at equal distances from the boundary, from the outside in.</summary>
internal static class ConcentricPattern
{
    private const double ArcTolerance = 0.005;

    public static void Add(InfillRequest request, RegionEngine engine, List<InfillLine> lines)
    {
        // Solid loops begin on the boundary; wider ones half a gap away from the extrusion on it.
        var loop = request.Area.Offset(request.Solid ? 0 : -request.Spacing / 2, JoinStyle.Miter, 2, ArcTolerance, engine);
        while (!loop.IsEmpty)
        {
            foreach (var contour in loop.Contours)
            {
                var points = Array.ConvertAll(contour.Raw, p => p.WithZ(request.Z));
                lines.Add(new InfillLine(points, true));
            }
            loop = loop.Offset(-request.Spacing, JoinStyle.Miter, 2, ArcTolerance, engine).Simplified(0.002, engine);
        }
    }
}

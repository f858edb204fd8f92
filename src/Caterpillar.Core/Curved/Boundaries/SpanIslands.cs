namespace Caterpillar.Curved;

/// <summary>The connected pieces of a layer: each outline with the holes in it.</summary>
internal static class SpanIslands
{
    /// <summary>A span for each piece, with its box.</summary>
    public static List<(MeanValueSpan Span, Bounds Bounds)> Of(List<Vec3[]> curves)
    {
        var outlines = curves.Where(c => Area(c) > 0).OrderBy(Area).ToArray();
        if (outlines.Length == 0) return [(new MeanValueSpan(curves), Bounds.Of(curves.SelectMany(c => c)))];
        var spans = Array.ConvertAll(outlines, o => new MeanValueSpan([o]));
        var members = Array.ConvertAll(outlines, o => new List<Vec3[]> { o });
        foreach (var hole in curves.Where(c => !(Area(c) > 0)))
        {
            // The smallest outline around it.
            var owner = Array.FindIndex(spans, s => s.Winding(hole[0].X, hole[0].Y) != 0);
            if (owner >= 0) members[owner].Add(hole);
        }
        return members.Select(m => (new MeanValueSpan(m), Bounds.Of(m[0]))).ToList();
    }

    /// <summary>The piece that contains a place, or else the nearest.</summary>
    public static MeanValueSpan Nearest(List<(MeanValueSpan Span, Bounds Bounds)> spans, double x, double y)
    {
        if (spans.Count == 1) return spans[0].Span;
        if (spans.Find(s => s.Bounds.Contains(new Vec3(x, y, s.Bounds.Min.Z)) && s.Span.Winding(x, y) != 0).Span is { } around) return around;
        var (best, least) = (spans[0].Span, double.PositiveInfinity);
        foreach (var (span, _) in spans)
        {
            var square = span.SquareTo(x, y);
            if (square < least) (best, least) = (span, square);
        }
        return best;
    }

    private static double Area(Vec3[] curve) => 2 * Polyline.Own(curve, closed: true).SignedAreaXY;
}

namespace Caterpillar.Slicing;

/// <summary>
/// The direction in which an area over air is best spanned: extrusions that lie on something at both ends, and as little length in the air as possible.
/// </summary>
internal static class BridgeFinder
{
    private const int Directions = 24;

    // Extrusions held at both ends must be this share of the length in the air; else nothing spans the area.
    private const double Held = 0.5;

    // Shares as good as equal; of such directions only one with clearly shorter spans is better than one along the sides.
    private const double Same = 0.02;
    private const double Shorter = 0.95;

    /// <summary>The best direction in degrees from +X, or null if no direction holds the area.</summary>
    /// <param name="area">The bridge with the anchors into which it reaches.</param>
    /// <param name="below">What the layer below covers.</param>
    /// <param name="width">Width of an extrusion, mm.</param>
    public static double? Find(Region area, Region below, double width)
    {
        var box = area.Bounds;
        var spacing = Math.Max(width, Math.Max(box.Size.X, box.Size.Y) / 60);
        double bestHeld = 0, bestSpan = double.PositiveInfinity;
        double? angle = null;
        var longest = LongestEdge(area);
        for (var i = 0; i < Directions + 2; i++)
        {
            // Along the longest edge first: the sides of most gaps are parallel to something.
            var direction = i == 0 ? longest : i == 1 ? longest + 90 : 180.0 / Directions * (i - 2);
            var (share, span) = Spans(area, below, direction, spacing);
            if (share <= Held || share < bestHeld - Same || (share < bestHeld + Same && span > Shorter * bestSpan)) continue;
            (bestHeld, bestSpan, angle) = (share, span, direction);
        }
        return angle;
    }

    // The share of the length over air that is held at both ends, and the mean of its spans, long ones counting most.
    private static (double Share, double Span) Spans(Region area, Region below, double angle, double spacing)
    {
        double held = 0, loose = 0, spans = 0;
        foreach (var line in area.HatchLines(angle, spacing, spacing / 2))
        {
            var parts = below.ClipLines([Polyline.Own([line.From, line.To], closed: false)], outside: true);
            foreach (var part in parts)
            {
                var length = part.Length;
                if (length < 1e-3) continue;
                if (part[0].DistanceTo(line.From) > 1e-4 && part[part.Count - 1].DistanceTo(line.To) > 1e-4)
                {
                    held += length;
                    spans += length * length;
                }
                else
                {
                    loose += length;
                }
            }
        }
        return held > 0 ? (held / (held + loose), spans / held) : (0, 0);
    }

    private static double LongestEdge(Region area)
    {
        var longest = 0.0;
        var angle = 0.0;
        foreach (var contour in area.Contours)
        {
            for (var i = 0; i < contour.Count; i++)
            {
                var edge = contour[i + 1 == contour.Count ? 0 : i + 1] - contour[i];
                if (edge.LengthSquared <= longest) continue;
                longest = edge.LengthSquared;
                angle = Angle.Atan2(edge.Y, edge.X);
            }
        }
        return angle;
    }
}

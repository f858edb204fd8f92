namespace Caterpillar.Slicing;

/// <summary>
/// The direction in which an area over air is best spanned: extrusions that lie on something at both ends, and as little length in the air as possible.
/// </summary>
internal static class BridgeFinder
{
    private const int Directions = 24;

    // Share of the length in the air that is held at both ends where a bridge needs no supports: all but ends of lines at corners.
    private const double Whole = 0.95;

    // mm; what is no farther over an edge lies on it.
    private const double OnEdge = 0.02;

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
            var (share, span, _) = Spans(area, below, direction, spacing);
            if (share <= Held || share < bestHeld - Same || (share < bestHeld + Same && span > Shorter * bestSpan)) continue;
            (bestHeld, bestSpan, angle) = (share, span, direction);
        }
        return angle;
    }

    /// <summary>
    /// Whether an overhang is printed as a bridge that needs no supports: its lines and its walls reach from one side to the other, and none is too long.
    /// </summary>
    /// <param name="overhang">One piece over air.</param>
    /// <param name="part">What the layer covers.</param>
    /// <param name="below">What the layer below covers.</param>
    /// <param name="width">Width of an extrusion, mm.</param>
    /// <param name="longest">Longest distance in the air, mm.</param>
    /// <param name="engine">Clips.</param>
    public static bool Holds(Region overhang, Region part, Region below, double width, double longest, RegionEngine engine)
    {
        var near = overhang.Offset(2 * width, JoinStyle.Miter, 2, OnEdge, engine);
        var (area, anchors) = (near.Intersect([part.Cropped(near.Box)], engine), below.Near(near.Box));
        // Walls follow the free edges.
        var free = anchors.Offset(OnEdge, JoinStyle.Miter, 2, OnEdge, engine).ClipLines(overhang.Contours, outside: true);
        if (!free.All(e => e.Length < width || (e.Length <= longest && IsStraight(e, width / 2)))) return false;
        if (Find(area, anchors, width) is not { } angle) return false;
        var (share, _, span) = Spans(area, anchors, angle, width);
        return share >= Whole && span <= longest;
    }

    private static bool IsStraight(Polyline edge, double tolerance)
    {
        var chord = edge[edge.Count - 1] - edge[0];
        return !edge.IsClosed && edge.Points.All(p => Vec3.Cross(chord, p - edge[0]).Length <= tolerance * chord.Length);
    }

    // The share of the length over air that is held at both ends, the mean of its spans, long ones counting most, and the longest.
    private static (double Share, double Span, double Longest) Spans(Region area, Region below, double angle, double spacing)
    {
        double held = 0, loose = 0, spans = 0, longest = 0;
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
                    longest = Math.Max(longest, length);
                }
                else
                {
                    loose += length;
                }
            }
        }
        return held > 0 ? (held / (held + loose), spans / held, longest) : (0, 0, 0);
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

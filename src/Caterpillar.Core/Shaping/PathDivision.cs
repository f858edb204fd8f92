namespace Caterpillar.Shaping;

/// <summary>Divides the segments of a path: before a deformation until its image is smooth, before a modulation until it resolves the field.</summary>
internal static class PathDivision
{
    /// <summary>The most segments of all paths of one call; each takes some hundred bytes until it is written.</summary>
    public const int MaxSegments = 20_000_000;

    // mm; arcs have no straight ends to keep.
    private const double ArcTolerance = 0.01;

    /// <summary>All vertices (the first again at the end of a closed path) and a bead for each segment.</summary>
    public static (Vec3[] Points, Bead[] Beads) Divide(PrintPath path, double tolerance, Deformation deformation, CancellationToken cancel)
    {
        if (!(tolerance > 0))
        {
            var straight = Straight(path, 0, cancel);
            return (straight.Closed ? [.. straight.Points, path.Start] : straight.Points, straight.Beads);
        }
        var points = new List<Vec3> { path.Start };
        var beads = new List<Bead>();
        Func<Vec3[], Vec3[]> map = deformation.Map;
        for (var i = 0; i < path.SegmentCount; i++)
        {
            cancel.ThrowIfCancellationRequested();
            SmoothDivision.Divide(path.Points[i], path.EndOf(i), path.ArcOf(i), tolerance, map, points);
            while (beads.Count < points.Count - 1) beads.Add(path.BeadOf(i));
        }
        return (points.ToArray(), beads.ToArray());
    }

    /// <summary>
    /// Straight segments of at most <paramref name="maximum"/> mm in equal parts (0 leaves straight segments whole); a closed path stays closed.
    /// </summary>
    public static (Vec3[] Points, Bead[] Beads, bool Closed) Straight(PrintPath path, double maximum, CancellationToken cancel)
    {
        var points = new List<Vec3> { path.Start };
        var beads = new List<Bead>();
        for (var i = 0; i < path.SegmentCount; i++)
        {
            Vec3 start = path.Points[i], end = path.EndOf(i);
            var arc = path.ArcOf(i);
            var parts = arc?.ChordCount(start, ArcTolerance) ?? 1.0;
            if (maximum > 0) parts = Math.Max(parts, Math.Ceiling(path.LengthOf(i) / maximum - 1e-9));
            parts = Math.Min(parts, 10_000_000);
            for (var k = 1; k <= parts; k++)
            {
                if ((points.Count & 0x3FFF) == 0) cancel.ThrowIfCancellationRequested();
                points.Add(k == parts ? end : Arc.PointAt(arc, start, end, k / parts));
                beads.Add(path.BeadOf(i));
            }
        }
        if (path.IsClosed) points.RemoveAt(points.Count - 1);
        return (points.ToArray(), beads.ToArray(), path.IsClosed);
    }
}

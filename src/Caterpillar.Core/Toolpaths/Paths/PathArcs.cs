namespace Caterpillar.Toolpaths;

/// <summary>Fits arcs to straight segments of paths, and expands arcs into chords.</summary>
public static class PathArcs
{
    /// <summary>
    /// Replaces runs of straight segments with arcs within a tolerance (see <see cref="ArcFitter"/>). Existing arcs stay. A new arc never crosses a change of
    /// the bead or the seam of a closed path, so that its material per mm is constant.
    /// </summary>
    public static PrintPath Fit(PrintPath path, double tolerance = 0.02)
    {
        if (path is null) throw new ArgumentNullException(nameof(path));
        Vec3[] vertices = path.IsClosed ? [.. path.RawPoints, path.Start] : path.RawPoints;
        var fitter = new ArcFitter(vertices, tolerance);
        var points = new List<Vec3> { vertices[0] };
        var beads = new List<Bead>();
        var arcs = new List<Arc?>();
        var found = false;
        // After the last segment of the run of straight segments with one bead.
        var runEnd = 0;
        for (var i = 0; i < path.SegmentCount;)
        {
            var bead = path.BeadOf(i);
            var end = i + 1;
            var arc = path.ArcOf(i);
            if (arc is null)
            {
                if (runEnd <= i)
                {
                    runEnd = i + 1;
                    while (runEnd < path.SegmentCount && path.ArcOf(runEnd) is null && path.BeadOf(runEnd) == bead) runEnd++;
                }
                if (fitter.From(i, runEnd) is { } fit)
                {
                    (end, arc) = (fit.End, fit.Arc);
                    found = true;
                }
            }
            points.Add(vertices[end]);
            beads.Add(bead);
            arcs.Add(arc);
            i = end;
        }
        return found ? Build(path, points, beads, arcs) : path;
    }

    /// <summary>Replaces every arc with equal chords that deviate at most <paramref name="tolerance"/> mm from it.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The tolerance is not positive.</exception>
    public static PrintPath Expand(PrintPath path, double tolerance = 0.01)
    {
        if (path is null) throw new ArgumentNullException(nameof(path));
        if (!(tolerance > 0)) throw new ArgumentOutOfRangeException(nameof(tolerance), "The tolerance must be positive.");
        if (!path.HasArcs) return path;
        var points = new List<Vec3> { path.Start };
        var beads = new List<Bead>();
        for (var i = 0; i < path.SegmentCount; i++)
        {
            var start = path.Points[i];
            var end = path.EndOf(i);
            var chords = 1;
            if (path.ArcOf(i) is { } arc)
            {
                // A loop of two chords would have no area.
                chords = Math.Max(arc.ChordCount(start, tolerance), Math.Abs(arc.Sweep) > 180 ? 3 : path.IsClosed ? 2 : 1);
                for (var k = 1; k < chords; k++) points.Add(arc.PointAt(start, end, (double)k / chords));
            }
            points.Add(end);
            for (var k = 0; k < chords; k++) beads.Add(path.BeadOf(i));
        }
        return Build(path, points, beads, null);
    }

    private static PrintPath Build(PrintPath path, List<Vec3> points, List<Bead> beads, List<Arc?>? arcs)
    {
        if (path.IsClosed) points.RemoveAt(points.Count - 1);
        return path.WithGeometry(points, beads, path.IsClosed, arcs);
    }
}

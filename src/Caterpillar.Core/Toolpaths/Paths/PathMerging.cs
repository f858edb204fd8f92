namespace Caterpillar.Toolpaths;

/// <summary>Joins paths whose ends touch into one, so that the machine does not stop between them.</summary>
public static class PathMerging
{
    /// <summary>
    /// Joins each open path to the previous one if its start is within <paramref name="tolerance"/> mm of the previous end, and role, layer, tool, name and
    /// overrides are equal. The order does not change. With <paramref name="reverse"/>, paths are also reversed to fit. Segments keep their beads. The joint is
    /// the end of the first path. A chain that returns to its start becomes closed.
    /// </summary>
    /// <exception cref="ArgumentException">The tolerance is negative or not a number, or a path is null.</exception>
    public static IReadOnlyList<PrintPath> Merge(IReadOnlyList<PrintPath> paths, double tolerance = 0.01, bool reverse = false)
    {
        if (paths is null) throw new ArgumentNullException(nameof(paths));
        if (!(tolerance >= 0)) throw new ArgumentException("The tolerance must be 0 or more.", nameof(tolerance));
        var merged = new List<PrintPath>();
        var chain = new List<PrintPath>();
        foreach (var each in paths)
        {
            var path = each ?? throw new ArgumentException("A path is null.", nameof(paths));
            if (chain.Count > 0 && Fits(chain, path, tolerance, reverse) is { } fitting)
            {
                chain.Add(fitting);
                continue;
            }
            if (chain.Count > 0) merged.Add(Join(chain, tolerance));
            chain.Clear();
            chain.Add(path);
        }
        if (chain.Count > 0) merged.Add(Join(chain, tolerance));
        return merged;
    }

    /// <summary>
    /// Joins straight segments shorter than <paramref name="minimum"/> mm with their neighbors, since too many short ones make printers stutter
    /// (Kanada 2016, <c>draw</c>). A joined segment has the mean area and speed of its parts, weighted by length. Arcs and longer segments stay.
    /// </summary>
    /// <exception cref="ArgumentException">The length is negative or not a number.</exception>
    public static PrintPath JoinShort(PrintPath path, double minimum)
    {
        if (path is null) throw new ArgumentNullException(nameof(path));
        if (!(minimum >= 0)) throw new ArgumentException("The length must be 0 or more.", nameof(minimum));
        var points = new List<Vec3> { path.Start };
        var beads = new List<Bead>();
        var arcs = new List<Arc?>();
        for (var i = 0; i < path.SegmentCount; i++)
        {
            var (end, bead, arc) = (path.EndOf(i), path.BeadOf(i), path.ArcOf(i));
            var last = beads.Count - 1;
            var (a, b) = (last < 0 ? 0 : points[last].DistanceTo(points[last + 1]), points[points.Count - 1].DistanceTo(end));
            var joins = last >= 0 && arc is null && arcs[last] is null && Math.Min(a, b) < minimum && points[last].DistanceTo(end) < 2 * minimum;
            if (joins)
            {
                var before = beads[last];
                points[last + 1] = end;
                beads[last] = new Bead((before.Area * a + bead.Area * b) / (a + b), before.Height, (before.Speed * a + bead.Speed * b) / (a + b));
                continue;
            }
            points.Add(end);
            beads.Add(bead);
            arcs.Add(arc);
        }
        if (beads.Count == path.SegmentCount || (path.IsClosed && beads.Count < 3)) return path;
        if (path.IsClosed) points.RemoveAt(points.Count - 1);
        return path.WithGeometry(points, beads, path.IsClosed, arcs);
    }

    private static PrintPath? Fits(List<PrintPath> chain, PrintPath path, double tolerance, bool reverse)
    {
        var last = chain[chain.Count - 1];
        if (last.IsClosed || path.IsClosed || !Alike(last, path)) return null;
        if (last.End.DistanceTo(path.Start) <= tolerance) return path;
        if (!reverse) return null;
        if (last.End.DistanceTo(path.End) <= tolerance) return path.Reversed();
        // Only the first path of a chain can still be reversed.
        if (chain.Count > 1) return null;
        var meets = last.Start.DistanceTo(path.Start) <= tolerance;
        if (!meets && last.Start.DistanceTo(path.End) > tolerance) return null;
        chain[0] = last.Reversed();
        return meets ? path : path.Reversed();
    }

    private static bool Alike(PrintPath a, PrintPath b)
        => a.Role == b.Role && a.Layer == b.Layer && a.Tool == b.Tool && a.Name == b.Name && a.Overrides == b.Overrides;

    private static PrintPath Join(List<PrintPath> chain, double tolerance)
    {
        if (chain.Count == 1) return chain[0];
        var points = new List<Vec3> { chain[0].Start };
        var beads = new List<Bead>();
        var arcs = new List<Arc?>();
        foreach (var path in chain)
        {
            for (var i = 0; i < path.SegmentCount; i++)
            {
                points.Add(path.EndOf(i));
                beads.Add(path.BeadOf(i));
                arcs.Add(path.ArcOf(i));
            }
        }
        var closed = points.Count > 3 && points[0].DistanceTo(points[points.Count - 1]) <= tolerance;
        if (closed) points.RemoveAt(points.Count - 1);
        return chain[0].WithGeometry(points, beads, closed, arcs);
    }
}

namespace Caterpillar.Planning;

/// <summary>The path of a wipe: along what has just been printed.</summary>
internal static class WipePath
{
    /// <summary>Deviation of the chords of an arc, mm.</summary>
    public const double Tolerance = 0.02;

    /// <summary>Points from the end of a path, back along an open one and onward along a closed one, for a length in mm or to the other end.</summary>
    public static List<Vec3> Along(PrintPath path, double length)
    {
        var points = new List<Vec3> { path.End };
        for (var i = 0; i < path.SegmentCount && length > 0; i++)
        {
            var segment = path.IsClosed ? i : path.SegmentCount - 1 - i;
            var from = path.Points[segment];
            var to = path.EndOf(segment);
            var arc = path.ArcOf(segment);
            var chords = arc?.ChordCount(from, Tolerance) ?? 1;
            for (var k = 1; k <= chords && length > 0; k++)
            {
                var t = path.IsClosed ? (double)k / chords : (double)(chords - k) / chords;
                var next = arc is { } a ? a.PointAt(from, to, t) : path.IsClosed ? to : from;
                var step = points[points.Count - 1].DistanceTo(next);
                if (step <= 0) continue;
                points.Add(step > length ? Vec3.Lerp(points[points.Count - 1], next, length / step) : next);
                length -= step;
            }
        }
        return points;
    }
}

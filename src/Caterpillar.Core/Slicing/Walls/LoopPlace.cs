namespace Caterpillar.Slicing;

/// <summary>A place on a closed path.</summary>
/// <param name="Segment">Number of the segment.</param>
/// <param name="T">From its start (0) to its end (1).</param>
/// <param name="Point">mm.</param>
internal readonly record struct LoopPlace(int Segment, double T, Vec3 Point)
{
    // A seam this close to a vertex lies at it, mm: no tiny segments.
    private const double Snap = 0.02;

    /// <summary>The place nearest to a point, seen from above; the first among equals.</summary>
    public static LoopPlace Nearest(Vec3[] loop, Vec3 to)
    {
        var best = new LoopPlace(0, 0, loop[0]);
        var least = double.PositiveInfinity;
        for (var i = 0; i < loop.Length; i++)
        {
            Vec3 a = loop[i], b = loop[i + 1 == loop.Length ? 0 : i + 1];
            var square = FlatSegment.SquareDistance(to, a, b);
            if (square >= least) continue;
            least = square;
            var t = FlatSegment.Parameter(to, a, b);
            best = new LoopPlace(i, t, Vec3.Lerp(a, b, t));
        }
        return best;
    }

    public static LoopPlace AtVertex(Vec3[] loop, int vertex) => new(vertex, 0, loop[vertex]);

    /// <summary>The place at a length along the loop from its first vertex, mm.</summary>
    public static LoopPlace AtLength(Vec3[] loop, double length)
    {
        for (var i = 0; i < loop.Length; i++)
        {
            Vec3 a = loop[i], b = loop[i + 1 == loop.Length ? 0 : i + 1];
            var step = a.DistanceTo(b);
            if (length < step) return new LoopPlace(i, length / step, Vec3.Lerp(a, b, length / step));
            length -= step;
        }
        return AtVertex(loop, 0);
    }

    /// <summary>The nearer vertex of the segment if it is within a distance, mm; otherwise this place.</summary>
    public LoopPlace Snapped(Vec3[] loop, double distance)
    {
        var next = Segment + 1 == loop.Length ? 0 : Segment + 1;
        double before = Point.DistanceTo(loop[Segment]), after = Point.DistanceTo(loop[next]);
        return Math.Min(before, after) > distance ? this : AtVertex(loop, before <= after ? Segment : next);
    }

    /// <summary>The loop starting here, with a new vertex if none is near.</summary>
    public PrintPath Start(PrintPath loop)
    {
        var points = loop.RawPoints;
        if (Snapped(points, Snap) is { T: 0 } vertex) return loop.StartingAt(vertex.Segment);
        var moved = new Vec3[points.Length + 1];
        moved[0] = Point;
        for (var i = 1; i < moved.Length; i++) moved[i] = points[(Segment + i) % points.Length];
        if (loop.OnlyBead is { } only) return loop.WithOwn(moved, [only], closed: true);
        var beads = new Bead[moved.Length];
        for (var i = 0; i < moved.Length; i++) beads[i] = loop.BeadOf((Segment + i) % points.Length);
        return loop.WithOwn(moved, beads, closed: true);
    }
}

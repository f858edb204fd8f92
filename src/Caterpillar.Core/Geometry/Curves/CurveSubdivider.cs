namespace Caterpillar.Geometry;

/// <summary>
/// Turns curves into points. Linear parts (lines, collinear runs of polylines, straight spans of NURBS curves) keep only their end points. Curved parts are
/// divided by the options (Caterpillar 2019, section 4.2). Kinks and the seam of a closed curve are always points.
/// </summary>
public static class CurveSubdivider
{
    /// <summary>Divides a curve.</summary>
    /// <exception cref="ArgumentException">An option is out of range, or no limit is set.</exception>
    /// <exception cref="SubdivisionLimitException">The options would give too many points.</exception>
    /// <exception cref="OperationCanceledException">The call was canceled.</exception>
    public static Subdivision Subdivide(Curve curve, SubdivisionOptions options, CancellationToken cancel = default)
    {
        if (curve is null) throw new ArgumentNullException(nameof(curve));
        if (options is null) throw new ArgumentNullException(nameof(options));
        options.Check();
        // "Straight" never allows more deviation than the chords.
        if (options.ChordTolerance > 0 && options.LinearTolerance > 0.5 * options.ChordTolerance)
            options = options with { LinearTolerance = 0.5 * options.ChordTolerance };
        var work = new Work(options, cancel);
        if (curve is PolylineCurve polyline) return work.Polyline(polyline);
        var spans = curve.Spans();
        if (spans.Count == 0) return new Subdivision([curve.Start, curve.End], false, [true], null);
        work.Begin(spans[0].Start);
        for (var i = 0; i < spans.Count;)
        {
            var end = i + 1;
            if (spans[i].IsStraight(options.LinearTolerance))
            {
                while (end < spans.Count && spans[end].IsStraight(options.LinearTolerance)) end++;
                work.Linear(spans, i, end);
            }
            else if (work.CanStayArc(spans[i]))
            {
                work.Arc(spans[i].Arc!);
            }
            else
            {
                while (end < spans.Count && !spans[end].IsStraight(options.LinearTolerance) && !work.CanStayArc(spans[end])
                    && !work.IsKink(spans[end - 1], spans[end])) end++;
                work.Curved(spans.GetRange(i, end - i));
            }
            i = end;
        }
        return work.Finish(curve.IsClosed);
    }

    private sealed class Work(SubdivisionOptions options, CancellationToken cancel)
    {
        // Minimum change of direction of a kink, degrees.
        private const double KinkAngle = 0.5;

        private readonly List<Vec3> _points = [];
        private readonly List<bool> _linear = [];
        private List<Arc?>? _arcs;

        public void Begin(Vec3 start) => _points.Add(start);

        public bool CanStayArc(CurveSpan span)
            => options.KeepArcs && span.Arc is { } arc && Math.Abs(Vec3.Dot(arc.Frame.Z, Vec3.UnitZ)) >= 1 - 1e-14 && Math.Abs(arc.Start.Z - arc.End.Z) <= 1e-9;

        public bool IsKink(CurveSpan before, CurveSpan after) => CurveSpan.TurnDegrees(before.EndTangent, after.StartTangent) > KinkAngle;

        public Subdivision Polyline(PolylineCurve curve)
        {
            var source = curve.Polyline.Raw;
            var points = Distinct(curve.Polyline.IsClosed ? [.. source, source[0]] : source);
            if (points.Length == 1) return new Subdivision([points[0], points[0]], false, [true], null);
            var kept = new List<int>(points.Length) { 0 };
            LinearRuns.Keep(points, 0, points.Length - 1, options.LinearTolerance, kept);
            var ends = points;
            if (kept.Count < points.Length) ends = new Vec3[kept.Count];
            for (var i = 0; i < ends.Length; i++) ends[i] = points[kept[i]];
            return Joined(ends, curve.IsClosed, [.. Enumerable.Repeat(true, ends.Length - 1)], null);
        }

        // The same array if no point repeats the previous one.
        private static Vec3[] Distinct(Vec3[] points)
        {
            for (var i = 1; i < points.Length; i++)
            {
                if (points[i] == points[i - 1]) return [.. points.Where((p, k) => k == 0 || p != points[k - 1])];
            }
            return points;
        }

        public void Linear(List<CurveSpan> spans, int first, int end)
        {
            Vec3[] corners = [_points[_points.Count - 1], .. spans.GetRange(first, end - first).Select(s => s.End)];
            var kept = new List<int>();
            LinearRuns.Keep(corners, 0, corners.Length - 1, options.LinearTolerance, kept);
            foreach (var i in kept) Add(corners[i], true);
        }

        public void Arc(ArcCurve arc)
        {
            var center = arc.Center;
            var sweep = arc.Frame.Z.Z > 0 ? arc.Sweep : -arc.Sweep;
            var parts = Math.Abs(sweep) > 359 ? 2 : 1;
            for (var i = 1; i <= parts; i++) Add(arc.PointAt((double)i / parts), false, new Arc(center, sweep / parts));
        }

        public void Curved(List<CurveSpan> spans)
        {
            var run = new CurvedRun(spans, options, SubdivisionLimitException.MaxPoints - _points.Count, cancel);
            foreach (var point in run.Divide()) Add(point, false);
        }

        public Subdivision Finish(bool closed) => Joined(_points.ToArray(), closed, _linear.ToArray(), _arcs?.ToArray());

        private static Subdivision Joined(Vec3[] points, bool closed, bool[] linear, Arc?[]? arcs)
        {
            var last = points.Length - 1;
            // A closed curve of two straight segments goes back on itself and stays open.
            closed &= last >= (arcs is null ? 3 : 2) && points[0].DistanceTo(points[last]) <= Curve.JoinTolerance;
            if (closed) Array.Resize(ref points, last);
            return new Subdivision(points, closed, linear, arcs);
        }

        private void Add(Vec3 point, bool linear, Arc? arc = null)
        {
            if (arc is not null) _arcs ??= [.. Enumerable.Repeat<Arc?>(null, _linear.Count)];
            _points.Add(point);
            _linear.Add(linear);
            _arcs?.Add(arc);
        }
    }
}

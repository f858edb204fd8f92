namespace Caterpillar.Slicing;

/// <summary>
/// Extrusions for what rows leave between themselves and edges that run nearly along them, and for arms of an area that lie between two rows. Each is as wide
/// as the gap, and where that changes, its flow follows.
/// </summary>
internal sealed class RowGaps
{
    // Shares of a spacing: shortest edge that counts as one along the rows, thinnest extrusion, largest change of width within a segment.
    private const double Shortest = 3;

    /// <summary>The same where nothing is seen: beside shorter edges go links alone. In spacings.</summary>
    public const double ShortestHidden = 8;

    private const double Thinnest = 0.3;
    private const double Change = 0.2;

    private readonly List<Edge> _edges = [];
    private readonly List<Vec3> _run = [];
    private readonly List<Vec3> _points = [];
    private readonly List<double> _flow = [];

    // Row 0 of the island, and how far apart its rows are.
    private double _first;
    private double _spacing;

    /// <summary>Adds the extrusions; rows are at first + k · spacing, up to k = rows.</summary>
    public void Add(InfillRequest request, Region island, in PatternFrame frame, double first, double spacing, int rows, List<InfillLine> lines)
    {
        (_first, _spacing) = (first, spacing);
        _edges.Clear();
        foreach (var path in island.Paths) Collect(path, frame, rows, request.Spacing * (request.Hidden ? ShortestHidden : Shortest));
        foreach (var edge in _edges)
        {
            // A bottom edge below a top edge is the other side of that one.
            if (edge.IsTop) Above(edge, request, frame, lines);
            else Below(edge, request, frame, lines);
        }
    }

    // Walks around a contour and cuts it at the rows and where it turns back; what goes far enough between two rows is kept.
    private void Collect(GridPoint[] path, in PatternFrame frame, int rows, double shortest)
    {
        _run.Clear();
        var strip = int.MinValue;
        var direction = 0;
        var a = Turned(path[path.Length - 1], frame);
        foreach (var corner in path)
        {
            var b = Turned(corner, frame);
            double from = (a.Y - _first) / _spacing, to = (b.Y - _first) / _spacing;
            int begin = Strip(from), end = Strip(to);
            var sign = Math.Sign(b.X - a.X);
            var p = a;
            for (var k = begin; ; k += end > begin ? 1 : -1)
            {
                // Where the edge leaves this strip.
                var q = k == end ? b : Vec3.Lerp(a, b, ((end > begin ? k + 1 : k) - from) / (to - from));
                if (k != strip || sign != direction)
                {
                    Keep(strip, direction, rows, shortest);
                    _run.Add(p);
                    (strip, direction) = (k, sign);
                }
                _run.Add(q);
                p = q;
                if (k == end) break;
            }
            a = b;
        }
        Keep(strip, direction, rows, shortest);
    }

    private static int Strip(double rows) => (int)Math.Floor(Math.Min(Math.Max(rows, -1e6), 1e8));

    private static Vec3 Turned(GridPoint p, in PatternFrame frame)
    {
        var place = Grid.ToMm(p);
        return new Vec3(frame.U(place), frame.V(place));
    }

    private void Keep(int strip, int direction, int rows, double shortest)
    {
        // The area is to the left: below an edge that goes back.
        if (strip >= 0 && strip < rows && Math.Abs(_run[_run.Count - 1].X - _run[0].X) >= shortest)
        {
            var points = _run.ToArray();
            if (direction < 0) Array.Reverse(points);
            _edges.Add(new Edge(strip, direction < 0, points));
        }
        _run.Clear();
    }

    private void Above(Edge top, InfillRequest request, in PatternFrame frame, List<InfillLine> lines)
    {
        var row = _first + top.Strip * _spacing + _spacing / 2;
        var at = top.Points[0].X;
        foreach (var bottom in _edges)
        {
            if (bottom.IsTop || bottom.Strip != top.Strip || bottom.End <= at || bottom.Start >= top.End) continue;
            double from = Math.Max(at, bottom.Start), to = Math.Min(top.End, bottom.End), middle = (from + to) / 2;
            if (bottom.At(middle) >= top.At(middle)) continue;
            // Down to the row where there is no edge, then between the two.
            Extrusion(at, from, new Gap(top, null, row), request, frame, lines);
            Extrusion(from, to, new Gap(top, bottom, row), request, frame, lines);
            at = to;
        }
        Extrusion(at, top.End, new Gap(top, null, row), request, frame, lines);
    }

    private void Below(Edge bottom, InfillRequest request, in PatternFrame frame, List<InfillLine> lines)
    {
        var row = _first + (bottom.Strip + 1) * _spacing - _spacing / 2;
        var at = bottom.Start;
        foreach (var top in _edges)
        {
            if (!top.IsTop || top.Strip != bottom.Strip || top.End <= at || top.Start >= bottom.End) continue;
            double from = Math.Max(at, top.Start), to = Math.Min(top.End, bottom.End), middle = (from + to) / 2;
            if (bottom.At(middle) >= top.At(middle)) continue;
            Extrusion(at, from, new Gap(null, bottom, row), request, frame, lines);
            at = to;
        }
        Extrusion(at, bottom.End, new Gap(null, bottom, row), request, frame, lines);
    }

    // Along the middle between an edge, with half an extrusion up to the wall, and the other edge or the extrusion of the row.
    private void Extrusion(double from, double to, Gap gap, InfillRequest request, in PatternFrame frame, List<InfillLine> lines)
    {
        var (top, bottom, row) = gap;
        var half = request.Spacing / 2 - request.Overlap;
        _points.Clear();
        _flow.Clear();
        if (to <= from) return;
        var u = from;
        while (true)
        {
            var next = Math.Min(to, Math.Min(top?.Next(u) ?? to, bottom?.Next(u) ?? to));
            if (next <= u) break;
            double low = Low(u), high = High(u), lowEnd = Low(next), highEnd = High(next);
            var pieces = (int)Math.Ceiling(Math.Abs(highEnd - lowEnd - high + low) / (Change * request.Spacing)) + 1;
            for (var i = 0; i < pieces; i++)
            {
                double s = (double)i / pieces, t = (double)(i + 1) / pieces;
                var flow = (high - low + (highEnd - lowEnd - high + low) * (s + t) / 2) / request.Spacing;
                if (flow < Thinnest)
                {
                    Flush(request, frame, lines);
                    continue;
                }
                Vec3 start = new(u, (low + high) / 2), end = new(next, (lowEnd + highEnd) / 2);
                if (_points.Count == 0) _points.Add(Vec3.Lerp(start, end, s));
                _points.Add(Vec3.Lerp(start, end, t));
                _flow.Add(flow);
            }
            u = next;
        }
        Flush(request, frame, lines);

        double Low(double at) => bottom is null ? row : bottom.At(at) - half;

        double High(double at) => top is null ? row : top.At(at) + half;
    }

    private void Flush(InfillRequest request, in PatternFrame frame, List<InfillLine> lines)
    {
        if (_points.Count > 1)
        {
            var points = new Vec3[_points.Count];
            for (var i = 0; i < points.Length; i++) points[i] = frame.At(_points[i].X, _points[i].Y).WithZ(request.Z);
            lines.Add(new InfillLine(points, false, _flow.ToArray()));
        }
        _points.Clear();
        _flow.Clear();
    }

    // What is between an edge and another, or the side of a row's extrusion.
    private readonly record struct Gap(Edge? Top, Edge? Bottom, double Row);

    // A piece of a contour between two rows, by ascending u.
    private sealed record Edge(int Strip, bool IsTop, Vec3[] Points)
    {
        public double Start => Points[0].X;

        public double End => Points[Points.Length - 1].X;

        public double At(double u)
        {
            var i = 1;
            while (i + 1 < Points.Length && Points[i].X < u) i++;
            Vec3 a = Points[i - 1], b = Points[i];
            return b.X > a.X ? a.Y + (b.Y - a.Y) * Math.Min(Math.Max((u - a.X) / (b.X - a.X), 0), 1) : b.Y;
        }

        // The next corner.
        public double Next(double u)
        {
            foreach (var p in Points)
            {
                if (p.X > u) return p.X;
            }
            return double.PositiveInfinity;
        }
    }
}

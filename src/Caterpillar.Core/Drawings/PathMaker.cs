namespace Caterpillar.Drawings;

/// <summary>Makes the path of one user curve.</summary>
internal sealed class PathMaker(CurveOptions options, DiagnosticList diagnostics, CancellationToken cancel)
{
    // Maximum change of area or speed from one segment of a ramp to the next, as a fraction.
    private const double RampStep = 0.1;

    /// <summary>The path, or null with a diagnostic.</summary>
    public PrintPath? Make(UserCurve curve, SourceLocation source)
    {
        try
        {
            return MakePath(curve, source);
        }
        catch (SubdivisionLimitException tooFine)
        {
            diagnostics.Add(Severity.Error, "curves.too_fine", tooFine.Message, source);
            return null;
        }
    }

    private PrintPath? MakePath(UserCurve curve, SourceLocation source)
    {
        var whole = BeadOf(curve.Area, curve.Width, curve.Height, curve.Speed, curve.Flow, source);
        if (whole is null) return null;
        var path = curve.Along is { Count: > 0 } along ? Ramps(curve, along, source) : Uniform(curve.Curve, whole.Value);
        if (path is null)
        {
            diagnostics.Add(Severity.Warning, "curves.too_short", "Curves without length are ignored.", source);
            return null;
        }
        if (Array.Exists(path.RawPoints, p => p.Z < 0))
            diagnostics.Add(Severity.Warning, "curves.below_bed", $"A curve goes below the bed, to Z {NumberFormatter.Format(path.Bounds.Min.Z, 3)} mm.",
                source);
        if (curve.Role == Role.Unspecified && curve.Layer is null && curve.Tool == 0 && curve.Name.Length == 0 && curve.Overrides is null) return path;
        return path with { Role = curve.Role, Layer = curve.Layer, Tool = curve.Tool, Name = curve.Name, Overrides = curve.Overrides };
    }

    private PrintPath? Uniform(Curve curve, Bead bead)
    {
        var divided = CurveSubdivider.Subdivide(curve, options.Subdivision, cancel);
        var points = divided.Raw;
        if (points.Length == 2 && points[0] == points[1]) return null;
        if (divided.RawArcs is not { } arcs) return PrintPath.Own(points, [bead], divided.IsClosed);
        return new PrintPath(points, Enumerable.Repeat(bead, divided.SegmentCount), divided.IsClosed, arcs);
    }

    private PrintPath? Ramps(UserCurve curve, PointValues along, SourceLocation source)
    {
        var (points, positions, closed) = Vertices(curve.Curve, along);
        var beads = new Bead[points.Count];
        for (var i = 0; i < beads.Length; i++)
        {
            if (options.Steps) positions[i] = Math.Floor(positions[i] + 1e-9);
            var bead = BeadOf(
                At(along.Areas, positions[i]) ?? curve.Area, At(along.Widths, positions[i]) ?? curve.Width, At(along.Heights, positions[i]) ?? curve.Height,
                At(along.Speeds, positions[i]) ?? curve.Speed, At(along.Flows, positions[i]) ?? curve.Flow, source);
            if (bead is null) return null;
            beads[i] = bead.Value;
        }
        var vertices = new List<Vec3> { points[0] };
        var extrusions = new List<Bead>();
        for (var i = 1; i < points.Count; i++)
        {
            if (points[i] == points[i - 1]) continue;
            var (a, b) = (beads[i - 1], options.Steps ? beads[i - 1] : beads[i]);
            var parts = Math.Max(Parts(a.Area, b.Area), Parts(a.Speed, b.Speed));
            for (var k = 0; k < parts; k++)
            {
                var t = (k + 0.5) / parts;
                vertices.Add(Vec3.Lerp(points[i - 1], points[i], (k + 1.0) / parts));
                extrusions.Add(new Bead(Mix(a.Area, b.Area, t), Mix(a.Height, b.Height, t), Mix(a.Speed, b.Speed, t)));
            }
        }
        if (extrusions.Count == 0) return null;
        DropInnerPoints(ref vertices, ref extrusions);
        if (closed && vertices.Count > 3) vertices.RemoveAt(vertices.Count - 1);
        else closed = false;
        return new PrintPath(vertices, extrusions, closed);
    }

    // The vertices with the end repeated, and their positions in the columns of values.
    private (List<Vec3> Points, List<double> Positions, bool Closed) Vertices(Curve curve, PointValues along)
    {
        var points = new List<Vec3>();
        var positions = new List<double>();
        if (curve is PolylineCurve { Polyline: var polyline } && along.Count == polyline.Count)
        {
            for (var i = 0; i <= polyline.SegmentCount; i++)
            {
                points.Add(polyline[i == polyline.Count ? 0 : i]);
                positions.Add(i == polyline.Count ? 0 : i);
            }
            return (points, positions, curve.IsClosed);
        }
        var divided = CurveSubdivider.Subdivide(curve, options.Subdivision with { KeepArcs = false }, cancel);
        points.AddRange(divided.Points);
        if (divided.IsClosed) points.Add(points[0]);
        var lengths = Polyline.LengthsAlong(points.ToArray());
        var total = lengths[lengths.Length - 1];
        foreach (var length in lengths) positions.Add(total > 0 ? length / total * (along.Count - 1) : 0);
        return options.Steps ? WithSteps(points, positions, divided.IsClosed) : (points, positions, divided.IsClosed);
    }

    // A point wherever the next value begins.
    private static (List<Vec3> Points, List<double> Positions, bool Closed) WithSteps(List<Vec3> points, List<double> positions, bool closed)
    {
        var stepped = new List<Vec3> { points[0] };
        var places = new List<double> { positions[0] };
        for (var i = 1; i < points.Count; i++)
        {
            for (var next = Math.Floor(positions[i - 1] + 1e-9) + 1; next < positions[i] - 1e-9; next++)
            {
                stepped.Add(Vec3.Lerp(points[i - 1], points[i], (next - positions[i - 1]) / (positions[i] - positions[i - 1])));
                places.Add(next);
            }
            stepped.Add(points[i]);
            places.Add(positions[i]);
        }
        return (stepped, places, closed);
    }

    // Straight runs with one bead keep only their ends.
    private void DropInnerPoints(ref List<Vec3> points, ref List<Bead> extrusions)
    {
        var all = points.ToArray();
        var kept = new List<int>();
        var keptPoints = new List<Vec3> { points[0] };
        var keptExtrusions = new List<Bead>();
        for (int i = 0, end; i < extrusions.Count; i = end)
        {
            for (end = i + 1; end < extrusions.Count && extrusions[end] == extrusions[i];) end++;
            kept.Clear();
            LinearRuns.Keep(all, i, end, options.Subdivision.LinearTolerance, kept);
            foreach (var k in kept)
            {
                keptPoints.Add(points[k]);
                keptExtrusions.Add(extrusions[i]);
            }
        }
        (points, extrusions) = (keptPoints, keptExtrusions);
    }

    private Bead? BeadOf(double? area, double? width, double? height, double? speed, double? ratio, SourceLocation source)
    {
        var w = width ?? options.Width;
        var h = height ?? options.Height;
        var flow = ratio ?? options.Flow;
        var s = speed ?? options.Speed;
        if (!(Good(area ?? 0) && Good(w) && Good(h) && Good(flow) && Good(s)))
        {
            diagnostics.Add(Severity.Error, "curves.bead", "Area, width, height, flow and speed of an extrusion must be 0 or more and finite.", source);
            return null;
        }
        if (options.Strokes) return new Bead(0, h, s);
        if (area is { } given) return new Bead(given, h, s);
        // Too narrow for the shape: a round extrusion of the width.
        return Bead.FromWidth(w, h, flow, s, options.Shape == BeadShape.Stadium && w < h ? BeadShape.Circle : options.Shape);
    }

    private int Parts(double a, double b)
    {
        var largest = Math.Max(a, b);
        var change = Math.Abs(b - a);
        return change == 0 ? 1 : (int)Math.Ceiling(change / (RampStep * largest) - 1e-9);
    }

    private static double? At(IReadOnlyList<double>? column, double place)
    {
        if (column is null) return null;
        var i = Math.Min((int)place, column.Count - 1);
        return i + 1 < column.Count ? Mix(column[i], column[i + 1], place - i) : column[i];
    }

    private static double Mix(double a, double b, double t) => t == 0 ? a : a + (b - a) * t;

    private static bool Good(double value) => value >= 0 && !double.IsInfinity(value);
}

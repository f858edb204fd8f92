namespace Caterpillar.Curved;

/// <summary>
/// Brings paths of flat layers back into the part: divided until chords and gaps are exact enough, each piece with a bead of the volume that lies between its
/// layer and what is below. One thread.
/// </summary>
internal sealed class PathLifter(LayerField field, LiftRules rules, LayerNeighbors? neighbors)
{
    private const int MaxDepth = 12;
    private readonly JoinedExtrusion _extrusion = new(rules.Tolerance / 2, rules.GapShare);
    private readonly List<PathStep> _pieces = [];
    private Layer? _layer;
    private Vec3 _segmentStart;

    /// <summary>Problems found on all paths so far.</summary>
    public LiftReport Report { get; } = new();

    /// <summary>The step in the part: usually one, several where pieces are left out.</summary>
    public IReadOnlyList<PathStep> Lift(PathStep step)
    {
        var path = step.Path;
        _pieces.Clear();
        _extrusion.Clear();
        _layer = path.Layer;
        for (var i = 0; i < path.SegmentCount; i++)
        {
            Vec3 from = path.RawPoints[i], to = path.EndOf(i);
            var bead = path.BeadOf(i);
            var span = field.Span(to - from);
            var arc = path.ArcOf(i);
            var parts = double.IsInfinity(field.Detail) ? 1 : (int)Math.Min(100_000, Math.Max(1, Math.Ceiling(span / field.Detail)));
            if (arc is { } turn)
                parts = Math.Max(turn.ChordCount(from, rules.Tolerance / 2),
                    (int)Math.Min(100_000, Math.Ceiling(path.LengthOf(i) / Math.Min(field.Detail, 1e6))));
            var a = At(from, bead.Height);
            _segmentStart = from;
            for (var k = 1; k <= parts; k++)
            {
                var b = At(Arc.PointAt(arc, from, to, (double)k / parts), bead.Height);
                Divide(a, b, bead, 0, step);
                a = b;
            }
        }
        if (_pieces.Count == 0 && path.IsClosed && _extrusion.Points.Count > 3)
        {
            _extrusion.Points.RemoveAt(_extrusion.Points.Count - 1);
            _pieces.Add(step with { Path = path.WithGeometry(_extrusion.Points, _extrusion.Beads, closed: true) });
        }
        else
        {
            End(step);
            if (path.IsClosed) JoinEnds(step);
        }
        return _pieces.ToArray();
    }

    private Sample At(Vec3 flat, double thickness)
    {
        // Extrusions of unknown height keep their volume.
        var lifted = field.Lift(flat, thickness > 0 ? thickness : 1);
        var gap = lifted.Gap;
        if (rules.Onto is not null)
        {
            var clear = lifted.Part.Z - rules.Onto.Height(lifted.Part.X, lifted.Part.Y);
            // Where the part begins here, the first extrusion fills what is open below it.
            if (clear < gap || (clear <= rules.MaxFill && _layer is not null && neighbors?.IsLowest(_layer, flat) == true)) gap = clear;
        }
        return new Sample(flat, lifted.Part, gap, lifted.Area, !rules.FindsEdge || field.Covers(lifted.Part.X, lifted.Part.Y));
    }

    private void Divide(Sample a, Sample b, Bead bead, int depth, PathStep step)
    {
        var m = At(Vec3.Lerp(a.Flat, b.Flat, 0.5), bead.Height);
        if (depth < MaxDepth && !IsSmooth(a, b, m, bead) && a.Flat.DistanceTo(b.Flat) > 4 * rules.Tolerance)
        {
            Divide(a, m, bead, depth + 1, step);
            Divide(m, b, bead, depth + 1, step);
            return;
        }
        Add(a, b, m, bead, step);
    }

    private bool IsSmooth(Sample a, Sample b, Sample m, Bead bead)
    {
        if (m.Part.DistanceToSegment(a.Part, b.Part) > rules.Tolerance || a.Covered != m.Covered || b.Covered != m.Covered) return false;
        var limit = rules.GapShare * Math.Max(Math.Abs(m.Gap), 1e-6);
        if (Math.Abs(a.Gap - b.Gap) > limit || Math.Abs(m.Gap - (a.Gap + b.Gap) / 2) > limit / 2) return false;
        // A second test off the middle, where waves may hide.
        var n = At(Vec3.Lerp(a.Flat, b.Flat, 0.23), bead.Height);
        return n.Part.DistanceToSegment(a.Part, b.Part) <= rules.Tolerance && Math.Abs(n.Gap - m.Gap) <= limit;
    }

    private void Add(Sample a, Sample b, Sample m, Bead bead, PathStep step)
    {
        var length = a.Part.DistanceTo(b.Part);
        if (!(length > 0)) return;
        var thickness = bead.Height;
        var gap = (a.Gap + 4 * m.Gap + b.Gap) / 6;
        var normal = field.Normal(m.Part);
        var slope = Angle.Atan2(normal.LengthXY, normal.Z);
        // Nothing dips below the bed at an end, either.
        if (!(gap > 0) || a.Gap < 0 || b.Gap < 0 || !a.Part.IsFinite || !b.Part.IsFinite)
        {
            Report.Below.Note(length, -gap, m.Part);
            End(step);
            return;
        }
        var isUncovered = !m.Covered && step.Path.Role is not (Role.Skirt or Role.Brim);
        var isSteep = slope > rules.MaxSlope && !(isUncovered && rules.Partial);
        if (isUncovered) Report.Uncovered.Note(length, 1, m.Part);
        if (isSteep) Report.Steep.Note(length, slope, m.Part);
        if (rules.Partial && (isUncovered || isSteep))
        {
            End(step);
            return;
        }
        if (IsLeft(gap * normal.Z, m.Flat, 0))
        {
            Report.Thin.Note(length, gap, m.Part);
            End(step);
            return;
        }
        // What is left of the layers below is printed with this one.
        var layers = 1;
        while (IsLeft(At(m.Flat.WithZ(m.Flat.Z - layers * thickness), thickness).Gap * normal.Z, m.Flat, layers)) layers++;
        if (layers > 1)
        {
            thickness *= layers;
            gap = (At(a.Flat, thickness).Gap + 4 * At(m.Flat, thickness).Gap + At(b.Flat, thickness).Gap) / 6;
        }
        // The area among flat layers that the extrusion covers, times the gap.
        var area = bead.Area / (bead.Height > 0 ? bead.Height : 1) * gap * m.Area * a.Flat.DistanceTo(b.Flat) / length;
        _extrusion.Add(a.Part, b.Part, new Bead(area, bead.Height > 0 ? gap * normal.Z : 0, bead.Speed), keepsStart: a.Flat == _segmentStart);
    }

    private bool IsLeft(double gap, Vec3 flat, int below) => gap < rules.MinGap && neighbors is not null && _layer is not null
        && neighbors.IsLeft(_layer, below, flat, (int)Math.Min(64, Math.Ceiling(rules.MinGap / gap - 1e-9)));

    private void End(PathStep step)
    {
        if (_extrusion.Points.Count > 1) _pieces.Add(step with { Path = step.Path.WithGeometry(_extrusion.Points, _extrusion.Beads, closed: false) });
        _extrusion.Clear();
    }

    // A closed path that was cut elsewhere goes on through its first vertex.
    private void JoinEnds(PathStep step)
    {
        if (_pieces.Count < 2) return;
        var joined = PathMerging.Merge([_pieces[_pieces.Count - 1].Path, _pieces[0].Path], 1e-9);
        if (joined.Count > 1) return;
        _pieces[0] = step with { Path = joined[0] };
        _pieces.RemoveAt(_pieces.Count - 1);
    }

    private readonly record struct Sample(Vec3 Flat, Vec3 Part, double Gap, double Area, bool Covered);
}

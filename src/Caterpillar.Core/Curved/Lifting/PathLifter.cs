namespace Caterpillar.Curved;

/// <summary>
/// Brings paths of flat layers back into the part: divided into moves as long as chords and gaps allow, each with a bead of the volume that lies between its
/// layer and what is below. One thread.
/// </summary>
internal sealed class PathLifter(LayerField field, LiftRules rules, LayerNeighbors? neighbors)
{
    // Of what the tolerances allow: how long moves are planned.
    private const double Aim = 0.95;

    // Of the tolerance; the rest is left to the bent mesh.
    private const double Share = 0.75;
    private readonly double _tolerance = Share * rules.Tolerance;
    private readonly JoinedExtrusion _extrusion = new(Share * rules.Tolerance, rules.GapShare, rules.GapLength);
    private readonly List<PathStep> _pieces = [];

    // Of a move, at even distances from its start to its end, an odd number.
    private readonly List<Sample> _samples = [];
    private readonly List<Vec3> _between = [];
    private Layer? _layer;

    // What the move uses of the tolerances, for its chord and for its gap: it grows with the square of its length. Infinite where it cannot be kept.
    private double _used;
    private double _usedByGap;

    // As far as moves may reach, from what was found so far, mm.
    private double _reach = double.PositiveInfinity;

    /// <summary>Problems found on all paths so far.</summary>
    public LiftReport Report { get; } = new();

    /// <summary>The step in the part: usually one, several where pieces are left out.</summary>
    public IReadOnlyList<PathStep> Lift(PathStep step)
    {
        var path = step.Path;
        _pieces.Clear();
        _extrusion.Clear();
        _layer = path.Layer;
        for (var i = 0; i < path.SegmentCount; i++) Lift(step, i);
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

    private void Lift(PathStep step, int segment)
    {
        var path = step.Path;
        var length = path.LengthOf(segment);
        var start = At(path, segment, 0);
        for (double done = 0, end; done < 1;)
        {
            var moves = Math.Ceiling((1 - done) * length / _reach - 1e-9);
            end = moves > 1 ? done + (1 - done) / moves : 1;
            TakeSamples(path, segment, start, done, end);
            var share = length * (end - done);
            var best = Math.Min(share * Aim / Math.Sqrt(_used), Math.Max(share * Aim / Math.Sqrt(_usedByGap), rules.GapLength));
            if (best < share * Aim && share > 4 * _tolerance)
            {
                _reach = Math.Max(best, share / 10);
                continue;
            }
            // Far beyond the move, nothing is known.
            _reach = best < 4 * share ? Math.Max(best, 2 * _tolerance) : Math.Max(_reach, 4 * share);
            start = _samples[_samples.Count - 1];
            Add(path.BeadOf(segment), step, done == 0);
            done = end;
        }
    }

    private void TakeSamples(PrintPath path, int segment, Sample start, double from, double to)
    {
        var span = path.ArcOf(segment) is null ? field.Span(path.EndOf(segment) - path.RawPoints[segment]) : path.LengthOf(segment);
        var details = (to - from) * span / field.Detail;
        var end = At(path, segment, to);
        // The middle first, and one more off the middle, where waves may hide.
        var middle = At(path, segment, (from + to) / 2);
        (_used, _usedByGap) = (0, 0);
        Use(start, end, end);
        Use(start, middle, end);
        Use(start, At(path, segment, from + 0.23 * (to - from)), end);
        var last = Math.Max(_used, _usedByGap) > 1 ? 2 : 2 * (int)Math.Min(50_000, Math.Max(1, Math.Ceiling(details / 2)));
        _between.Clear();
        _samples.Clear();
        _samples.Add(start);
        for (var i = 1; i < last; i++)
        {
            _samples.Add(2 * i == last ? middle : At(path, segment, from + (to - from) * i / last));
            _between.Add(_samples[i].Part);
            Use(start, _samples[i], end);
        }
        _samples.Add(end);
        // Where layers are thin, it is decided for each detail whether they are printed several at once.
        if (_samples.Exists(s => s.Gap < 2 * rules.MinGap)) _used = Math.Max(_used, details * details);
    }

    private void Use(in Sample a, in Sample m, in Sample b)
    {
        var used = m.Part.DistanceToSegment(a.Part, b.Part) / _tolerance;
        var off = (2 * m.Gap - a.Gap - b.Gap) / (rules.GapShare * Math.Max(Math.Abs(m.Gap), 1e-6));
        if (double.IsNaN(used + off) || a.Covered != m.Covered || b.Covered != m.Covered) _used = double.PositiveInfinity;
        else (_used, _usedByGap) = (Math.Max(_used, used), Math.Max(_usedByGap, off * off));
    }

    private Sample At(PrintPath path, int segment, double share)
        => At(Arc.PointAt(path.ArcOf(segment), path.RawPoints[segment], path.EndOf(segment), share), path.BeadOf(segment).Height);

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

    // The move of the samples.
    private void Add(Bead bead, PathStep step, bool isFirst)
    {
        Sample a = _samples[0], m = _samples[_samples.Count / 2], b = _samples[_samples.Count - 1];
        var length = a.Part.DistanceTo(b.Part);
        if (!(length > 0)) return;
        var gap = Mean();
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
        var layers = LayersAt(m, bead.Height, normal.Z);
        if (layers == 0)
        {
            Report.Thin.Note(length, gap, m.Part);
            End(step);
            return;
        }
        if (layers > 1)
        {
            for (var i = 0; i < _samples.Count; i++) _samples[i] = At(_samples[i].Flat, layers * bead.Height);
            gap = Mean();
        }
        // The area among flat layers that the extrusion covers, times the gap.
        var width = bead.Area / (bead.Height > 0 ? bead.Height : 1) * m.Area * a.Flat.DistanceTo(b.Flat) / length;
        double least = _samples[0].Gap, most = least;
        foreach (var sample in _samples) (least, most) = (Math.Min(least, sample.Gap), Math.Max(most, sample.Gap));
        var areas = (width * least, width * most);
        _extrusion.Add(a.Part, b.Part, new Bead(width * gap, bead.Height > 0 ? gap * normal.Z : 0, bead.Speed), areas, isFirst, _between);
    }

    // The mean gap of the move, by Simpson's rule.
    private double Mean()
    {
        var (sum, last) = (_samples[0].Gap + _samples[_samples.Count - 1].Gap, _samples.Count - 1);
        for (var i = 1; i < last; i++) sum += (i % 2 == 0 ? 2 : 4) * _samples[i].Gap;
        return sum / (3 * last);
    }

    // How many layers are printed at once at a place: also what is left of those below; 0 if it is left to those above.
    private int LayersAt(Sample place, double thickness, double normalZ)
    {
        if (neighbors is null || _layer is null) return 1;
        if (IsLeft(place.Gap * normalZ, place.Flat, 0)) return 0;
        var layers = 1;
        while (IsLeft(At(place.Flat.WithZ(place.Flat.Z - layers * thickness), thickness).Gap * normalZ, place.Flat, layers)) layers++;
        return layers;
    }

    private bool IsLeft(double gap, Vec3 flat, int below) => gap < rules.MinGap
        && neighbors!.IsLeft(_layer!, below, flat, (int)Math.Min(64, Math.Ceiling(rules.MinGap / gap - 1e-9)));

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

namespace Caterpillar.Slicing;

/// <summary>
/// Divides walls where they begin to hang over the layer below, and gives the pieces speed, flow and fan of their class. A path stays one path: only its
/// segments change.
/// </summary>
/// <param name="rules">Those of the walls of an island.</param>
/// <param name="below">Area below the island.</param>
/// <param name="engine">Offsets it.</param>
internal sealed class OverhangSplitter(SliceRules rules, Region below, RegionEngine engine)
{
    // mm; no printer follows a change of speed over a shorter piece.
    private const double Shortest = 0.05;

    private readonly ValueList<OverhangClass> _classes = rules.Settings.OverhangClasses;
    private readonly PrintSettings _settings = rules.Settings;
    private readonly LineClipper?[] _clippers = new LineClipper?[rules.Settings.OverhangClasses.Count];
    private readonly List<(double From, double To)> _parts = [];
    private readonly List<Vec3> _points = [];
    private readonly List<Bead> _beads = [];
    private List<(double To, int Kind)> _pieces = [];
    private List<(double To, int Kind)> _next = [];

    /// <summary>True if it is known that no part of the middle line of the last path is over air.</summary>
    public bool IsSupported { get; private set; }

    /// <summary>The path, with other segments and beads at overhangs.</summary>
    public PrintPath Split(PrintPath path)
    {
        _points.Clear();
        _beads.Clear();
        IsSupported = _classes[0].Percent <= 50;
        var lengths = new double[_classes.Count + 1];
        for (var kind = 0; kind < _classes.Count; kind++) _clippers[kind]?.Follow(path.RawPoints);
        for (var i = 0; i < path.SegmentCount; i++)
        {
            Vec3 a = path.RawPoints[i], b = path.EndOf(i);
            var from = 0.0;
            foreach (var (to, kind) in Pieces(path.RawPoints, i, a, b))
            {
                _points.Add(Vec3.Lerp(a, b, from));
                _beads.Add(kind < 0 ? path.BeadOf(i) : Changed(path.BeadOf(i), _classes[kind], path));
                lengths[kind + 1] += (to - from) * a.DistanceTo(b);
                from = to;
            }
        }
        double supported = lengths[0], all = 0;
        foreach (var length in lengths) all += length;
        if (supported == all) return path;
        if (!path.IsClosed) _points.Add(path.End);
        var split = path.WithOwn(_points.ToArray(), _beads.ToArray(), path.IsClosed);
        // The usual speed belongs to the role: it is stated before that changes.
        if (supported < all / 2)
        {
            var usual = _settings.SpeedOf(path.Role);
            split = split.WithBeads(i => split.BeadOf(i) is { Speed: 0 } own ? own with { Speed = usual } : split.BeadOf(i)) with { Role = Role.OverhangWall };
        }
        return Fan(lengths, all) is { } fan ? (split with { Overrides = new PathOverrides(Fan: fan) }) : split;
    }

    private Bead Changed(Bead bead, OverhangClass kind, PrintPath path)
        => new(bead.Area * kind.Flow, bead.Height, kind.Speed > 0 ? Math.Min(kind.Speed, _settings.SpeedOf(path.Role)) : bead.Speed);

    // The fan can't follow short pieces: it is set for the whole path where enough of it hangs over.
    private double? Fan(double[] lengths, double all)
    {
        const double Enough = 0.1;
        double fan = 0, over = 0;
        for (var i = lengths.Length - 1; i > 0; i--)
        {
            over += lengths[i];
            if (over >= Enough * all) fan = Math.Max(fan, _classes[i - 1].MinFanSpeedPercent / 100);
        }
        return fan > 0 ? fan : null;
    }

    // The ends of the pieces of a segment, and the class of each; −1 where it is supported.
    private List<(double To, int Kind)> Pieces(Vec3[] path, int segment, Vec3 a, Vec3 b)
    {
        _pieces.Clear();
        _pieces.Add((1, -1));
        if (a.X == b.X && a.Y == b.Y) return _pieces;
        for (var kind = 0; kind < _classes.Count; kind++)
        {
            _parts.Clear();
            Clipper(kind, path).Parts(segment, _parts);
            if (_parts.Count == 0) break;
            IsSupported = false;
            _next.Clear();
            var from = 0.0;
            foreach (var (to, old) in _pieces)
            {
                // What is supported by a smaller region is not looked at again.
                if (old == kind - 1) Cut(from, to, old, kind, Shortest / a.DistanceTo(b));
                else _next.Add((to, old));
                from = to;
            }
            (_pieces, _next) = (_next, _pieces);
        }
        return _pieces;
    }

    private void Cut(double from, double to, int old, int kind, double least)
    {
        foreach (var part in _parts)
        {
            double start = Math.Max(part.From, from), end = Math.Min(part.To, to);
            if (end - start < least) continue;
            if (start - from > least) _next.Add((start, old));
            _next.Add((end, kind));
            from = end;
        }
        if (to - from > least || _next.Count == 0) _next.Add((to, old));
        else _next[_next.Count - 1] = (to, _next[_next.Count - 1].Kind);
    }

    private LineClipper Clipper(int kind, Vec3[] path)
    {
        if (_clippers[kind] is { } made) return made;
        var distance = rules.Walls.OuterWidth * (_classes[kind].Percent / 100 - 0.5);
        var region = distance == 0 ? below : below.Offset(distance, JoinStyle.Miter, 2, 0.005, engine);
        var clipper = _clippers[kind] = new LineClipper(region.Index, outside: true);
        clipper.Follow(path);
        return clipper;
    }
}

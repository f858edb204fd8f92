namespace Caterpillar.Shaping;

/// <summary>Measures the gap below the nozzle: to earlier extrusions, a surface or the bed. The current bead does not count.</summary>
internal sealed class GapProbe(GapBead rules)
{
    private readonly Deposit _deposit = new();
    private readonly MeshHeights? _surface = rules.Surface is { } mesh ? new MeshHeights(mesh) : null;
    private readonly Queue<(Vec3 From, Vec3 To, Bead Bead, Arc? Arc, double At)> _fresh = new();
    private double _length;
    private double _lag;

    public void Begin(PrintPath path)
    {
        _length = 0;
        _lag = 0;
        for (var i = 0; i < path.SegmentCount; i++) _lag = Math.Max(_lag, 2 * path.BeadOf(i).Width(rules.Shape));
    }

    /// <summary>Vertical gap in mm below a position of the tip; positive infinity above nothing.</summary>
    public double Gap(Vec3 tip, double width)
    {
        // What is less than half the minimum gap below is beside the extrusion, not under it.
        var limit = tip.Z - rules.MinGap / 2;
        var below = _deposit.TopUnder(tip, limit);
        // Between two extrusions, the nearer of them.
        if (double.IsInfinity(below)) below = _deposit.TopUnder(tip, limit, width / 2);
        if (_surface is not null) below = Math.Max(below, _surface.TopUnder(tip.X, tip.Y, tip.Z));
        if (rules.Bed is { } bed && bed <= tip.Z) below = Math.Max(below, bed);
        return tip.Z - below;
    }

    public void Print(Vec3 from, Vec3 to, Bead bead, Arc? arc)
    {
        _length += arc is { } turn ? turn.Length(from, to) : from.DistanceTo(to);
        _fresh.Enqueue((from, to, bead, arc, _length));
        while (_fresh.Peek() is var (a, b, old, curve, at) && at < _length - _lag)
        {
            _deposit.Add(a, b, old, curve, rules.Shape);
            _fresh.Dequeue();
        }
    }

    public void End()
    {
        foreach (var (from, to, bead, arc, _) in _fresh) _deposit.Add(from, to, bead, arc, rules.Shape);
        _fresh.Clear();
    }
}

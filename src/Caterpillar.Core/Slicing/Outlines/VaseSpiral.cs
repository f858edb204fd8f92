namespace Caterpillar.Slicing;

/// <summary>
/// One wall that climbs without a seam. Along a turn it rises by the layer's thickness and passes over from the contour of the layer below to its own, so
/// neither its height nor its course jumps. The flow grows along the first turn, over which the wall rises from the bottom, and falls along one more, level
/// turn at the end. Takes the layers in their order.
/// </summary>
/// <param name="isAlone">No other model is printed between its turns.</param>
internal sealed class VaseSpiral(bool isAlone)
{
    private Vec3[]? _below;

    // The length of its wall up to each of its points.
    private double[] _lengths = [];
    private Vec3 _end;
    private SlicedLayer? _last;
    private LayerWork? _lastWork;

    /// <summary>Layers of which only the largest of several contours was printed.</summary>
    public int Divided { get; private set; }

    /// <summary>Path of the wall in a layer: half a width inside its largest outline. Null if it has none.</summary>
    public static Polyline? Loop(LayerWork layer, RegionEngine engine)
    {
        var outlines = Array.FindAll(layer.Region.Paths, path => Grid.DoubleArea(path, 0, path.Length) > 0);
        var line = Region.Own(outlines).Offset(-layer.Rules.Walls.OuterWidth / 2, JoinStyle.Miter, 2, 0.005, engine);
        Polyline? largest = null;
        foreach (var contour in line.Contours)
        {
            if (contour.SignedAreaXY > (largest?.SignedAreaXY ?? 0)) largest = contour;
        }
        return largest;
    }

    /// <summary>The layer with its turn of the wall.</summary>
    public SlicedLayer Next(LayerWork work, SlicedLayer layer)
    {
        if (work.VaseLoop is not { } loop) return layer;
        if (work.Region.Islands.Count > 1) Divided++;
        var settings = work.Rules.Settings;
        var bottom = work.Plan.Top - work.Plan.Thickness;
        var points = Begun(loop.Raw, _below is null ? loop[0] : _end, out var lengths);
        var all = lengths[lengths.Length - 1];
        var turn = new Vec3[points.Length];
        var hint = 0;
        for (var i = 0; i < turn.Length; i++)
        {
            var t = lengths[i] / all;
            var from = _below is null ? points[i] : i == 0 ? _end : Nearest(_below, _lengths, points[i], ref hint);
            turn[i] = Vec3.Lerp(from, points[i], t).WithZ(bottom + t * work.Plan.Thickness);
        }
        var least = settings.SpiralVaseMinFlowPercent / 100;
        var first = _below is null;
        var path = Turn(turn, work, t => first ? Math.Max(least, t) : 1, goesOn: isAlone);
        (_below, _lengths) = (points, lengths);
        _end = points[points.Length - 1];
        _lastWork = work;
        return _last = layer with { Steps = [.. layer.Steps, path] };
    }

    /// <summary>The last layer of the wall with another level turn of decreasing flow. Null if it has no wall.</summary>
    public SlicedLayer? Finish()
    {
        if (_last is null || _lastWork is null || _below is null) return null;
        var least = _lastWork.Rules.Settings.SpiralVaseMinFlowPercent / 100;
        var level = Array.ConvertAll(_below, p => p.WithZ(_lastWork.Plan.Top));
        return _last with { Steps = [.. _last.Steps, Turn(level, _lastWork, t => Math.Max(least, 1 - t), goesOn: false)] };
    }

    private static PathStep Turn(Vec3[] points, LayerWork work, Func<double, double> flow, bool goesOn)
    {
        var bead = work.Rules.Bead(work.Rules.Walls.OuterWidth);
        var all = 0.0;
        for (var i = 1; i < points.Length; i++) all += points[i].DistanceTo(points[i - 1]);
        var beads = new Bead[points.Length - 1];
        var at = 0.0;
        for (var i = 0; i < beads.Length; i++)
        {
            var length = points[i + 1].DistanceTo(points[i]);
            beads[i] = bead with { Area = bead.Area * flow((at + length / 2) / all) };
            at += length;
        }
        var path = work.Rules.Own(PrintPath.Own(points, beads, closed: false) with { Role = Role.OuterWall, Layer = work.Layer });
        return new PathStep(path, new StepGroup(work.Number, 0, StepRank.Walls)) { KeepStart = true, GoesOn = goesOn, Region = work.Region };
    }

    // The loop from its place nearest to a point, round and back to it, with segments short enough for a smooth flow; and the length up to each point.
    private static Vec3[] Begun(Vec3[] loop, Vec3 near, out double[] lengths)
    {
        var (segment, start) = NearestOf(loop, Polyline.LengthsAlong(loop), near, 0, loop.Length);
        var points = new List<Vec3> { start };
        for (var k = 1; k <= loop.Length; k++) AddTo(points, loop[(segment + k) % loop.Length]);
        AddTo(points, start);
        var turn = points.ToArray();
        lengths = Polyline.LengthsAlong(turn);
        return turn;
    }

    private static void AddTo(List<Vec3> points, Vec3 to)
    {
        const double Longest = 2;
        var from = points[points.Count - 1];
        var length = from.DistanceTo(to);
        if (length < 1e-6) return;
        var pieces = Math.Max(1, (int)Math.Ceiling(length / Longest));
        for (var i = 1; i <= pieces; i++) points.Add(Vec3.Lerp(from, to, (double)i / pieces));
    }

    // The point of an open loop nearest to another: looked for near the last one, and everywhere where that is far off.
    private static Vec3 Nearest(Vec3[] line, double[] lengths, Vec3 p, ref int hint)
    {
        const int Window = 24;
        const double Far = 1;
        var n = line.Length - 1;
        int from = Math.Max(0, hint - Window), to = Math.Min(n, hint + Window);
        var (segment, best) = NearestOf(line, lengths, p, from, to - from);
        if (best.DistanceTo(p) > Far) (segment, best) = NearestOf(line, lengths, p, 0, n);
        hint = segment;
        return best;
    }

    private static (int Segment, Vec3 Point) NearestOf(Vec3[] line, double[] lengths, Vec3 p, int first, int count)
    {
        // Any segment tells how far the nearest one is at most. Along the line one comes no faster nearer than one goes: what lies before that is left out.
        var guess = first + count / 2;
        var reach = Reach((NearestOn(line[guess], Next(line, guess), p) - p).LengthSquared);
        var best = double.PositiveInfinity;
        var result = (first, line[first]);
        var end = first + count;
        for (var i = first; i < end;)
        {
            var q = NearestOn(line[i], Next(line, i), p);
            var distance = (q - p).LengthSquared;
            if (distance < best)
            {
                best = distance;
                reach = Math.Min(reach, Reach(distance));
                result = (i, q);
            }
            if (++i == end) break;
            var from = lengths[i] + Math.Sqrt(distance) - reach;
            while (i + 1 < end && lengths[i + 1] < from) i++;
        }
        return result;
    }

    // The distance, and more than rounding makes of it.
    private static double Reach(double square) => Math.Sqrt(square) * (1 + 1e-9) + 1e-9;

    private static Vec3 Next(Vec3[] line, int i) => line[i + 1 == line.Length ? 0 : i + 1];

    private static Vec3 NearestOn(Vec3 a, Vec3 b, Vec3 p)
    {
        var d = b - a;
        var square = d.LengthSquared;
        var t = square > 0 ? Math.Min(1, Math.Max(0, Vec3.Dot(p - a, d) / square)) : 0;
        return a + d * t;
    }
}

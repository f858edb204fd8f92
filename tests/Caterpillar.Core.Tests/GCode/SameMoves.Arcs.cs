using System;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Tests.GCode;

/// <summary>Arcs: point by point, and against chains of chords.</summary>
internal sealed partial class SameMoves
{
    // Points along both, not the numbers of both: a short arc has them all over the place.
    private bool SameCurve(Move a, Move b)
    {
        if (a.Arc is not { } x || b.Arc is not { } y) return true;
        if (Tiny(a)) return true;
        if (x.Plane != y.Plane || x.Sweep > 0 != y.Sweep > 0) return false;
        for (var k = 1; k < 8; k++)
        {
            if (x.PointAt(a.Start, a.End, k / 8.0).DistanceTo(y.PointAt(b.Start, b.End, k / 8.0)) > 4 * _t.Xyz) return false;
        }
        return Math.Abs(a.Length - b.Length) <= 1e-5 * a.Length + 10 * _t.Xyz;
    }

    // An arc that became chords: each vertex on the arc, in its order, with its share of E; the end points and sums equal.
    private string? Chain()
    {
        TakeEvents();
        if (Events() is { } events) return events;
        var a = _a[_i];
        var arc = a.Arc!.Value;
        double sum = 0, deposited = 0, at = 0, rest = a.Length;
        var from = a.Start;
        while (true)
        {
            if (_j == _b.Length) return Said("a chain of chords ends before its arc");
            var b = _b[_j];
            // An extrusion that first restores does so in its first chords.
            var restores = b.Kind == MoveKind.MovingDeretract && (a.E > a.Deposited || _t.RetractionLength > 0);
            if (b.Kind != a.Kind && !restores && Math.Abs(b.E) > 1.02 * _t.E) return Said("kind of a chord");
            if (b.Speed > 0 && Math.Abs(a.Speed - b.Speed) > _t.Speed) return Said("speed of a chord");
            if ((_t.Tools && b.Tool != a.Tool)
                || (a.Kind == MoveKind.Print && b.Kind == MoveKind.Print && b.Role != a.Role)) return Said("tool or role of a chord");
            var done = Closest(a, arc, b.End, at);
            var off = arc.PointAt(a.Start, a.End, done).DistanceTo(b.End);
            if (off > 2 * _t.Xyz) return Said("a vertex of a chain lies off the arc");
            var middle = (from + b.End) / 2;
            if (arc.PointAt(a.Start, a.End, Closest(a, arc, middle, at)).DistanceTo(middle) > _t.Chords + 3 * _t.Xyz) return Said("a chord cuts its arc short");
            sum += b.E;
            deposited += b.Deposited;
            if (_t.Amounts && Math.Abs(a.E * _t.Factor(a.Tool) * done - sum) > 3 * _t.E
                + Math.Abs(a.E * _t.Factor(a.Tool)) * 4 * _t.Xyz / Math.Max(rest, 1e-6)) return Said("share of a chord in E");
            at = done;
            from = b.End;
            _j++;
            if (_nextB < _actual.Events.Count && _actual.Events[_nextB].Move < _j) return Said("event within a chain");
            if (done >= 1 - 1e-9 || (b.End.DistanceTo(a.End) <= _t.Xyz && done > 0.6)) break;
        }
        _sums.Expect(a.Tool, a.E * _t.Factor(a.Tool), a.Deposited * _t.Factor(a.Tool));
        _sums.Find(a.Tool, sum, deposited);
        _i++;
        return Drift(a.Tool) is { } drift ? Said(drift + " after an arc") : null;
    }

    // Where on the arc, from 0 to 1, a vertex is, not before the last one.
    private double Closest(Move a, Arc arc, Vec3 point, double after)
    {
        if (point.DistanceTo(a.End) <= _t.Xyz && (after > 0.4 || Math.Abs(arc.Sweep) < 300)) return 1;
        var count = Math.Max(arc.ChordCount(a.Start, _t.Chords), 1) * 2;
        double best = 1, least = double.MaxValue;
        var span = Math.Min(1 - after, Math.Max(16.0 / count, 0.02));
        for (var step = 0; step <= 64; step++)
        {
            var t = after + span * step / 64;
            var d = arc.PointAt(a.Start, a.End, t).DistanceTo(point);
            if (d < least) (least, best) = (d, t);
        }
        var width = span / 64;
        for (var k = 0; k < 40; k++)
        {
            width /= 2;
            foreach (var t in new[] { best - width, best + width })
            {
                if (t < after || t > 1) continue;
                var d = arc.PointAt(a.Start, a.End, t).DistanceTo(point);
                if (d < least) (least, best) = (d, t);
            }
        }
        return best;
    }
}

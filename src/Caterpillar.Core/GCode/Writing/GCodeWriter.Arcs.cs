using System;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Arcs: as G2 and G3, or as chords.</summary>
public sealed partial class GCodeWriter
{
    private ArcPlane _plane;

    private void ArcMove(ToolpathColumns c, int block, int i, Arc arc)
    {
        var start = i > 0 ? new Vec3(c.X[i - 1], c.Y[i - 1], c.Z[i - 1]) : _toolpath.StartOf(block);
        var end = new Vec3(c.X[i], c.Y[i], c.Z[i]);
        var allowed = _format.Arcs && _rules.Arcs && (arc.Plane == ArcPlane.XY || _rules.Planes)
            && (_rules.ArcsInRelativeMode || !_format.RelativeXyz);
        if (allowed && _positionKnown && Native(start, end, c.E[i], c.Speed[i], arc)) return;
        Chords(start, end, c.E[i], c.Speed[i], arc, c.Kind[i] == MoveKind.Travel ? 0 : 1);
    }

    private bool Native(Vec3 start, Vec3 end, double e, double speed, Arc arc)
    {
        var turns = Math.Ceiling(Math.Abs(arc.Sweep) / 360 - 1e-9);
        var word = turns > 1e6 ? 0 : _rules.TurnsWord((int)turns);
        if (turns > 1 && word == 0) return SplitTurns(start, end, e, speed, arc, turns);
        var xyz = _format.DecimalsXyz;
        var ux = NumberFormatter.ToUnits(end.X, xyz);
        var uy = NumberFormatter.ToUnits(end.Y, xyz);
        var uz = NumberFormatter.ToUnits(end.Z, xyz);
        var closed = arc.Plane switch
        {
            ArcPlane.XY => ux == _x && uy == _y,
            ArcPlane.ZX => ux == _x && uz == _z,
            _ => uy == _y && uz == _z,
        };
        var rest = Math.Abs(arc.Sweep) - 360 * (turns - 1);
        // Rounded to the same point, a short arc would become a full circle, and a circle that does not close a short arc.
        if (closed ? rest < 180 : rest > 359.999) return false;
        var code = _rules.ArcCode(arc.Plane, arc.Sweep < 0);
        if (closed && code == 3 && !_rules.CounterclockwiseCircles) return false;
        if (_rules.HelixRisesFirst && uz != _z) return false;
        var cu = NumberFormatter.ToUnits(arc.Center.X, xyz) - _x;
        var cv = NumberFormatter.ToUnits(arc.Center.Y, xyz) - _y;
        var cw = NumberFormatter.ToUnits(arc.Center.Z, xyz) - _z;
        var (first, second) = arc.Plane switch { ArcPlane.XY => (cu, cv), ArcPlane.ZX => (cu, cw), _ => (cv, cw) };
        if (first == 0 && second == 0) return false;
        Plane(arc.Plane);
        if (_format.RelativeXyz) SetRelative(true);
        var ue = StepE(e, out var changed);
        _out.Command((byte)'G', code);
        if (ux != _x || (closed && arc.Plane != ArcPlane.YZ)) _out.Word((byte)'X', _g91 ? ux - _x : ux, xyz);
        if (uy != _y || (closed && arc.Plane != ArcPlane.ZX)) _out.Word((byte)'Y', _g91 ? uy - _y : uy, xyz);
        if (uz != _z || (closed && arc.Plane != ArcPlane.XY)) _out.Word((byte)'Z', _g91 ? uz - _z : uz, xyz);
        _out.Word(arc.Plane == ArcPlane.YZ ? (byte)'J' : (byte)'I', first, xyz);
        _out.Word(arc.Plane == ArcPlane.XY ? (byte)'J' : (byte)'K', second, xyz);
        if (word > 0) _out.Word((byte)'P', word, 0);
        Turns();
        if (changed) _out.Word(_e, ue, _format.DecimalsE);
        Feed(speed);
        _out.EndLine();
        _x = ux;
        _y = uy;
        _z = uz;
        return true;
    }

    // Firmware that has no word for turns gets full circles and a rest.
    private bool SplitTurns(Vec3 start, Vec3 end, double e, double speed, Arc arc, double turns)
    {
        if (turns > 1000) return false;
        var from = start;
        var full = 360 / Math.Abs(arc.Sweep);
        for (var k = 0; k < (int)turns - 1; k++)
        {
            var to = arc.PointAt(start, end, full * (k + 1));
            var part = arc with { Sweep = Math.Sign(arc.Sweep) * 360 };
            // The circle closes exactly; only its rise continues.
            to = arc.Plane switch { ArcPlane.XY => new Vec3(from.X, from.Y, to.Z), ArcPlane.ZX => new Vec3(from.X, to.Y, from.Z),
                _ => new Vec3(to.X, from.Y, from.Z) };
            if (!Native(from, to, e * full, speed, part)) Chords(from, to, e * full, speed, part, 1);
            from = to;
        }
        var rest = arc with { Sweep = arc.Sweep - Math.Sign(arc.Sweep) * 360 * (turns - 1) };
        var last = e - e * full * (turns - 1);
        if (!Native(from, end, last, speed, rest)) Chords(from, end, last, speed, rest, 1);
        return true;
    }

    private void Chords(Vec3 start, Vec3 end, double e, double speed, Arc arc, int code)
    {
        var count = Math.Min(arc.ChordCount(start, end, _format.ChordTolerance), 100_000);
        var done = 0.0;
        var turned = BeginTurns();
        for (var k = 1; k <= count; k++)
        {
            if (turned is not null) ShareTurns(turned, (double)k / count);
            var p = arc.PointAt(start, end, (double)k / count);
            var sum = k == count ? e : e * k / count;
            Straight(p.X, p.Y, p.Z, sum - done, speed, code);
            done = sum;
        }
    }

    private void Plane(ArcPlane plane)
    {
        if (plane == _plane) return;
        _plane = plane;
        _out.Command((byte)'G', 17 + (int)plane);
        _out.EndLine();
    }
}

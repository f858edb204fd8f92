namespace Caterpillar.GCode;

/// <summary>
/// Writes motion lines: straight lines, and arcs as G2 and G3 or as chords. It keeps the written position and modes. Unchanged words and moves without words
/// are left out, compared by the written digits.
/// </summary>
internal sealed class MotionLines
{
    // Of arcs that the firmware does not know, mm.
    private const double ChordTolerance = 0.01;

    private readonly GCodeFormat _format;
    private readonly FlavorRules _rules;
    private readonly LineBuffer _out;
    private readonly int _decimals;
    private long _x;
    private long _y;
    private long _z;
    private long _f = long.MinValue;
    private bool _g91;
    private ArcPlane _plane;

    public MotionLines(GCodeFormat format, LineBuffer output)
    {
        (_format, _rules, _out, _decimals) = (format, format.Flavor, output, format.Printer.DecimalsXyz);
        Extruder = new ExtruderSums(format, output);
        Rotary = new RotaryWords(output, _decimals, Extruder.Letter);
    }

    public ExtruderSums Extruder { get; }

    public RotaryWords Rotary { get; }

    /// <summary>False if the next line must state the whole position.</summary>
    public bool KnowsPosition { get; private set; }

    /// <summary>A straight line by G0 or G1.</summary>
    public void Straight(double x, double y, double z, double e, double speed, int code)
    {
        var xyz = _decimals;
        var ux = NumberFormatter.ToUnits(x, xyz);
        var uy = NumberFormatter.ToUnits(y, xyz);
        var uz = NumberFormatter.ToUnits(z, xyz);
        var ue = Extruder.Step(e, out var changed);
        bool hasX = !KnowsPosition || ux != _x, hasY = !KnowsPosition || uy != _y, hasZ = !KnowsPosition || uz != _z;
        if (!hasX && !hasY && !hasZ && !changed && !Rotary.Turns) return;
        if (_format.RelativeXyz) SetRelative(KnowsPosition);
        _out.Command((byte)'G', code);
        if (hasX) _out.Word((byte)'X', _g91 ? ux - _x : ux, xyz);
        if (hasY) _out.Word((byte)'Y', _g91 ? uy - _y : uy, xyz);
        if (hasZ) _out.Word((byte)'Z', _g91 ? uz - _z : uz, xyz);
        End(ux, uy, uz, ue, changed, speed);
        KnowsPosition = true;
    }

    /// <summary>Writes an arc. Its chords, if any, are lines with <paramref name="code"/>.</summary>
    public void Arc(Vec3 start, Vec3 end, double e, double speed, Arc arc, int code)
    {
        var allowed = _rules.Arcs && (arc.Plane == ArcPlane.XY || _rules.Planes)
            && (_rules.ArcsInRelativeMode || !_format.RelativeXyz);
        if (allowed && KnowsPosition && Native(start, end, e, speed, arc)) return;
        Chords(start, end, e, speed, arc, code);
    }

    /// <summary>Writes G91 or G90, and the mode of E again if the firmware lets the last of them decide about E.</summary>
    public void SetRelative(bool relative)
    {
        if (relative == _g91) return;
        _g91 = relative;
        Modal(relative ? 91 : 90);
        Extruder.StateMode();
    }

    /// <summary>Absolute positions, and the mode of E.</summary>
    public void StateModes()
    {
        _g91 = false;
        Modal(90);
        Extruder.StateMode();
        Extruder.Reset();
    }

    /// <summary>Writes millimeters and the XY plane again if raw lines changed them.</summary>
    public void StateUnits(RawEffects raw)
    {
        if (raw.Unit && _rules.Inches) Modal(21);
        if (!raw.Plane || !_rules.Planes) return;
        _plane = ArcPlane.XY;
        Modal(17);
    }

    /// <summary>Called after homing: the next line states the whole position.</summary>
    public void ForgetPosition() => KnowsPosition = false;

    /// <summary>The next line states the speed.</summary>
    public void ForgetSpeed() => _f = long.MinValue;

    private bool Native(Vec3 start, Vec3 end, double e, double speed, Arc arc)
    {
        var turns = Math.Ceiling(Math.Abs(arc.Sweep) / 360 - 1e-9);
        var word = turns > 1e6 ? 0 : _rules.TurnsWord((int)turns);
        if (turns > 1 && word == 0) return SplitTurns(start, end, e, speed, arc, turns);
        var xyz = _decimals;
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
        if (arc.Plane != _plane) Modal(17 + (int)arc.Plane);
        _plane = arc.Plane;
        if (_format.RelativeXyz) SetRelative(true);
        var ue = Extruder.Step(e, out var changed);
        _out.Command((byte)'G', code);
        if (ux != _x || (closed && arc.Plane != ArcPlane.YZ)) _out.Word((byte)'X', _g91 ? ux - _x : ux, xyz);
        if (uy != _y || (closed && arc.Plane != ArcPlane.ZX)) _out.Word((byte)'Y', _g91 ? uy - _y : uy, xyz);
        if (uz != _z || (closed && arc.Plane != ArcPlane.XY)) _out.Word((byte)'Z', _g91 ? uz - _z : uz, xyz);
        _out.Word(arc.Plane == ArcPlane.YZ ? (byte)'J' : (byte)'I', first, xyz);
        _out.Word(arc.Plane == ArcPlane.XY ? (byte)'J' : (byte)'K', second, xyz);
        if (word > 0) _out.Word((byte)'P', word, 0);
        End(ux, uy, uz, ue, changed, speed);
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
        var count = Math.Min(arc.ChordCount(start, end, ChordTolerance), 100_000);
        var done = 0.0;
        var turned = Rotary.Begin();
        for (var k = 1; k <= count; k++)
        {
            if (turned is { } turns) Rotary.Share(turns, (double)k / count);
            var p = arc.PointAt(start, end, (double)k / count);
            var sum = k == count ? e : e * k / count;
            Straight(p.X, p.Y, p.Z, sum - done, speed, code);
            done = sum;
        }
    }

    // The words that lines and arcs have at their end.
    private void End(long x, long y, long z, long e, bool hasE, double speed)
    {
        Rotary.Write(_g91);
        if (hasE) Extruder.Word(e);
        Feed(speed);
        _out.EndLine();
        (_x, _y, _z) = (x, y, z);
    }

    private void Feed(double speed)
    {
        if (!(speed > 0)) return;
        var units = NumberFormatter.ToUnits(speed * 60, _format.Printer.DecimalsF);
        if (units == _f || units == 0) return;
        _f = units;
        _out.Word((byte)'F', units, _format.Printer.DecimalsF);
    }

    private void Modal(int code)
    {
        _out.Command((byte)'G', code);
        _out.EndLine();
    }
}

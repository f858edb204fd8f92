namespace Caterpillar.GCode;

/// <summary>G0 to G3 with their words, and the rotary axes A, B and C in degrees, if they do not extrude.</summary>
internal sealed class MotionCommands(Machine machine, ExtruderWords extruder, ModeCommands modes)
{
    // A spline becomes chords this near to it, mm.
    private const double SplineTolerance = 0.01;
    private const int MaxChords = 1000;

    // Firmware takes no more in one command.
    private const int MaxCircles = 100;
    private readonly FlavorRules _rules = machine.Rules;
    private readonly InterpreterState _state = machine.State;
    private readonly MoveRecorder _moves = machine.Moves;
    private readonly ArcReader _arcs = new(machine.Rules, machine.State);
    private readonly bool _readsTurns = machine.Axis == ExtrusionAxis.E || machine.Axis == ExtrusionAxis.None || machine.Axis == ExtrusionAxis.Switched;

    /// <summary>A motion line, with its rotary axes.</summary>
    public void Move(ParsedLine line)
    {
        if (!_readsTurns || !HasTurnWord(line))
        {
            MoveHead(line);
            return;
        }
        var before = _moves.Count;
        MoveHead(line);
        ref var rotary = ref _state.Rotary;
        var target = TurnsOf(line, rotary.Written, _state.Modes.Relative);
        if (target == rotary.Written) return;
        rotary = rotary with { Written = target };
        // Turning alone is a move as well.
        if (_moves.Count == before) _moves.Stay(MoveKind.Travel);
        _moves.Turn(rotary.Machine);
    }

    /// <summary>A straight move with the words in a mask of <see cref="ChunkParser"/>.</summary>
    public void Line(int mask, double x, double y, double z, double e, int code)
    {
        var de = (mask & ChunkParser.HasE) != 0 ? extruder.Change(e) : 0;
        ref var head = ref _state.Head;
        if (head.Lost != 0) Restate(mask, de > 0);
        _moves.Line(
            (mask & ChunkParser.HasX) != 0 ? machine.Target(head.X, x, head.ShiftX) : head.X,
            (mask & ChunkParser.HasY) != 0 ? machine.Target(head.Y, y, head.ShiftY) : head.Y,
            (mask & ChunkParser.HasZ) != 0 ? machine.Target(head.Z, z, head.ShiftZ) : head.Z,
            de,
            code);
    }

    /// <summary>G5: a cubic Bézier curve in X and Y, with I J from its start and P Q from its end. Z and E change evenly with its parameter.</summary>
    public void Spline(ParsedLine line)
    {
        if (line.TryGet('F', out var feed)) machine.SetFeed(feed);
        if (_state.Modes.Plane != ArcPlane.XY)
        {
            machine.Diagnostics.Warn("gcode.arc_refused", _rules.Title + " rejects G5 in other planes than XY.");
            return;
        }
        var (start, end, unit) = (_state.Head.Written, machine.Target(line), _state.Modes.Unit);
        var first = start + new Vec3(line.Get('I', 0) * unit, line.Get('J', 0) * unit, (end.Z - start.Z) / 3);
        var second = end + new Vec3(line.Get('P', 0) * unit, line.Get('Q', 0) * unit, (start.Z - end.Z) / 3);
        var bend = Math.Max((start - first * 2 + second).Length, (first - second * 2 + end).Length);
        var chords = (int)Math.Min(Math.Max(Math.Ceiling(Math.Sqrt(bend * 0.75 / SplineTolerance)), 1), MaxChords);
        var e = extruder.Change(line) / chords;
        for (var i = 1; i <= chords; i++)
        {
            var (t, s) = ((double)i / chords, 1 - (double)i / chords);
            var p = i == chords ? end : start * (s * s * s) + first * (3 * s * s * t) + second * (3 * s * t * t) + end * (t * t * t);
            _moves.Line(p.X, p.Y, p.Z, e, 1);
        }
    }

    /// <summary>G92 of the rotary axes: renames their position.</summary>
    public void RenameTurns(ParsedLine line)
    {
        if (!_readsTurns || !HasTurnWord(line)) return;
        var before = _state.Rotary.Machine;
        var written = TurnsOf(line, _state.Rotary.Written, false);
        _state.Rotary = new RotaryPosition(written, before - written);
    }

    /// <summary>True if a word of the line names a position, so that it may repeat the last motion.</summary>
    public bool HasAxisWord(ParsedLine line)
    {
        for (var i = 0; i < line.Count; i++)
        {
            if (line.HasValue[i] && (line.Letters[i] is (byte)'X' or (byte)'Y' or (byte)'Z' || machine.Axis.Is(line.Letters[i])
                || (_readsTurns && line.Letters[i] is (byte)'A' or (byte)'B' or (byte)'C')
                || (_state.Modes.Motion > 1 && line.Letters[i] is (byte)'I' or (byte)'J' or (byte)'K' or (byte)'R')))
            {
                return true;
            }
        }
        return false;
    }

    private void MoveHead(ParsedLine line)
    {
        if (line.TryGet('F', out var feed)) machine.SetFeed(feed);
        if (_state.Modes.Motion > 1)
        {
            Arc(line);
            return;
        }
        var mask = (line.TryGet('X', out var x) ? ChunkParser.HasX : 0) | (line.TryGet('Y', out var y) ? ChunkParser.HasY : 0)
            | (line.TryGet('Z', out var z) ? ChunkParser.HasZ : 0) | (extruder.TryGet(line, out var e) ? ChunkParser.HasE : 0);
        if (_rules.RestorePoints && line.TryGet('R', out var number))
        {
            if (!_state.Modes.Relative && modes.StoredPosition(number) is { } stored)
                (x, y, z) = (x + stored.X / _state.Modes.Unit, y + stored.Y / _state.Modes.Unit, z + stored.Z / _state.Modes.Unit);
            else machine.Log.NotFollowed("R of a motion");
        }
        Line(mask, x, y, z, e, _state.Modes.Motion);
    }

    private void Arc(ParsedLine line)
    {
        var code = _state.Modes.Motion;
        var end = machine.Target(line);
        var start = _state.Head.Written;
        if (_arcs.Read(line, start, end, out var arc) is { } refusal)
        {
            if (_rules.ArcWithoutCenterIsLine) _moves.Line(end.X, end.Y, end.Z, extruder.Change(line), code);
            else machine.Diagnostics.Warn("gcode.arc_refused", refusal);
            return;
        }
        var turns = ArcReader.Turns(line);
        if (_rules.ArcTurns == ArcTurnsRule.CirclesFirst) Circles(start, arc, turns, code);
        else if (_rules.ArcTurns == ArcTurnsRule.Added) arc = Longer(arc, turns);
        else if (_rules.ArcTurns == ArcTurnsRule.Count) arc = Longer(arc, turns - 1);
        var e = extruder.Change(line);
        if (_rules.HelixRisesFirst && end.Z != _state.Head.Z)
        {
            _moves.Line(_state.Head.X, _state.Head.Y, end.Z, 0, code);
            start = _state.Head.Written;
            arc = arc with { Center = arc.Center + new Vec3(0, 0, end.Z - arc.Center.Z) };
        }
        _moves.Arc(start, end, e, arc, code);
    }

    // An extrusion begins where the head is, which it should know.
    private void Restate(int mask, bool extrudes)
    {
        var prints = extrudes && (mask & ~ChunkParser.HasE) != 0;
        if (prints) machine.Log.PrintsLost(_state.Head.Lost);
        machine.Restate(prints ? _state.Head.Lost : _state.Modes.Relative ? 0 : mask);
    }

    private static Arc Longer(Arc arc, int turns) => turns > 0 ? arc with { Sweep = arc.Sweep + (arc.Sweep < 0 ? -360.0 : 360.0) * turns } : arc;

    // Full circles in the plane, one move each.
    private void Circles(Vec3 start, Arc arc, int turns, int code)
    {
        for (var k = 0; k < Math.Min(turns, MaxCircles); k++) _moves.Arc(start, start, 0, arc with { Sweep = arc.Sweep < 0 ? -360 : 360 }, code);
    }

    private static bool HasTurnWord(ParsedLine line) => line.Find('A') >= 0 || line.Find('B') >= 0 || line.Find('C') >= 0;

    private static Vec3 TurnsOf(ParsedLine line, Vec3 from, bool relative)
        => new(Turn(line, 'A', from.X, relative), Turn(line, 'B', from.Y, relative), Turn(line, 'C', from.Z, relative));

    private static double Turn(ParsedLine line, char letter, double from, bool relative)
        => !line.TryGet(letter, out var word) || !IsAngle(word) ? from
            : !relative ? word
            : IsAngle(from + word) ? from + word : from;

    private static bool IsAngle(double degrees) => degrees is > -MoveRecorder.LargestLength and < MoveRecorder.LargestLength;
}

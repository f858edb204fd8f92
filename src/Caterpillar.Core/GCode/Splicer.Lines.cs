using System;
using System.Collections.Generic;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Lines that are put in, and the moves and events that ask for them.</summary>
internal sealed partial class Splicer
{
    private readonly List<CommentLine> _comments = [];
    private readonly CutComments _cut = new();
    private MoveCursor _cursor = null!;
    private List<MoveEvent> _events = [];
    private int _nextEvent;
    private readonly List<Wanted> _inserted = [];

    // Collects what the line has to do, and in front of it what is put in.
    private void Take(int moves)
    {
        _wanted.Clear();
        if (_target is not null)
        {
            for (var i = 0; i < moves; i++) _wanted.Add(new Wanted(_in.LastMoves, i) with { Arc = moves == 1 ? _in.LastArc : null });
            return;
        }
        // Moves whose line made none here would hold up all others.
        while (_cursor.Valid && _cursor.Source >= 0 && _cursor.Source < _number) _cursor.Next();
        while (_cursor.Valid && (_cursor.Source == _number || (_cursor.Source < 0 && _wanted.Count == 0 && LeadsTo(_number))))
        {
            if (_cursor.Source < 0) _inserted.Add(_cursor.Wanted());
            else _wanted.Add(_cursor.Wanted());
            NewEvents(_cursor.Number);
            _cursor.Next();
        }
    }

    // True when the moves put in here stand in front of a move of this line.
    private bool LeadsTo(int line)
    {
        var ahead = _cursor.Clone();
        while (ahead.Valid && ahead.Source < 0) ahead.Next();
        return ahead.Valid && ahead.Source == line;
    }

    private void NewEvents(int move)
    {
        for (; _nextEvent < _events.Count && _events[_nextEvent].Move <= move; _nextEvent++) _pendingEvents.Add(_events[_nextEvent].Event);
    }

    private readonly List<PrinterEvent> _pendingEvents = [];

    private void Inserted()
    {
        foreach (var what in _pendingEvents) Event(what);
        _pendingEvents.Clear();
        foreach (var wanted in _inserted) Fresh(wanted);
        _inserted.Clear();
    }

    // What is put in behind the last move of the file.
    private void End()
    {
        for (; _target is null && _cursor.Valid; _cursor.Next())
        {
            if (_cursor.Source < 0) _inserted.Add(_cursor.Wanted());
        }
        NewEvents(int.MaxValue);
        if (_pendingEvents.Count > 0 || _inserted.Count > 0) _text.CloseLine();
        Inserted();
    }

    private void Event(PrinterEvent what)
    {
        foreach (var line in EventText.Lines(what, _rules)) Command(line);
    }

    private void FlushComments(bool keep)
    {
        foreach (var line in _comments)
        {
            if (!keep)
            {
                _cut.Cut(line);
                continue;
            }
            if (!_cut.IsEmpty) _cut.Keep(line);
            if (!Unit(line)) _text.Line(line.Text, line.Start, line.End, line.Next);
        }
        _comments.Clear();
    }

    // Comments of moves that were cut out which those behind them need.
    private void RestoreComments()
    {
        if (_cut.IsEmpty) return;
        foreach (var line in _comments) _cut.Keep(line);
        foreach (var line in _cut.Take())
        {
            var bytes = new byte[line.End - line.Start];
            Buffer.BlockCopy(line.Text, line.Start, bytes, 0, bytes.Length);
            _text.Own(bytes, bytes.Length);
        }
    }

    // A setting that says in which unit E is goes with the unit.
    private bool Unit(CommentLine line)
    {
        if (_target is not { ChangesUnit: true } || line.End - line.Start > 100) return false;
        var text = TextEncoding.Decode(line.Text, line.Start, line.End);
        if (text.IndexOf("use_volumetric_e = ", StringComparison.Ordinal) < 0) return false;
        var own = TextEncoding.Encode("; use_volumetric_e = " + (_target.IsVolumetric ? "1" : "0"));
        _text.Own(own, own.Length);
        return true;
    }

    // A line of our own, read by the machine that follows what is written.
    private void Command(string line)
    {
        var bytes = TextEncoding.Encode(_style.LowerCase ? line.ToLowerInvariant() : line);
        _now.ReadLine(bytes, 0, bytes.Length, out _);
        _text.Own(bytes, bytes.Length);
    }

    private void State(string command, char letter, double value, int decimals) => Command(command + " " + letter + NumberFormatter.Format(value, decimals));

    // A move as a line of its own.
    private void Fresh(Wanted wanted)
    {
        if (wanted.Kind == MoveKind.Dwell || IsLost(wanted)) return;
        Prepare(wanted);
        if (wanted.E == 0 && wanted.Kind is MoveKind.Retract or MoveKind.Restore && wanted.E == 0 && _rules.FirmwareRetraction)
        {
            Command(wanted.Kind == MoveKind.Retract ? "G10" : "G11");
            return;
        }
        var before = _now.Save();
        if (wanted.Arc is { } arc && !CanArc(wanted, before))
        {
            Chords(wanted, arc, before);
            return;
        }
        var code = wanted.Arc is { } turn ? (turn.Sweep < 0 ? "G2" : "G3") : wanted.Kind == MoveKind.Travel && _style.TravelsByG0 ? "G0" : "G1";
        var bytes = Encoding.ASCII.GetBytes(_style.LowerCase ? code.ToLowerInvariant() : code);
        _rewriter.Rewrite(bytes, 0, bytes.Length, wanted, before, Code(wanted), _now.IsRelativeE, _owed, false);
        // Nothing but the command: no printed change.
        if (_rewriter.Count <= bytes.Length) return;
        _now.ReadLine(_rewriter.Bytes, 0, _rewriter.Count, out _);
        if (!IsDone(wanted))
        {
            _now.Restore(before);
            Chords(wanted, wanted.Arc!.Value, before);
            return;
        }
        Owe(wanted);
        _text.Own(_rewriter.Bytes, _rewriter.Count);
    }

    private void Chords(Wanted wanted, Arc arc, MachineSnapshot before)
    {
        var start = new Vec3(before.X + before.ShiftX, before.Y + before.ShiftY, before.Z + before.ShiftZ);
        var end = new Vec3(wanted.X, wanted.Y, wanted.Z);
        var count = Math.Min(arc.ChordCount(start, end, ChordTolerance), 100_000);
        for (var k = 1; k <= count; k++)
        {
            var p = arc.PointAt(start, end, (double)k / count);
            Fresh(wanted with { X = p.X, Y = p.Y, Z = p.Z, E = wanted.E / count, Arc = null });
        }
    }

    private bool CanArc(Wanted wanted, MachineSnapshot state)
    {
        if (ExpandArcs || !_rules.Arcs || (state.Relative && !_rules.ArcsInRelativeMode)) return false;
        var arc = wanted.Arc!.Value;
        if (arc.Plane != state.Plane || (Math.Abs(arc.Sweep) > 360.0001 && !_rules.ArcTurns)) return false;
        // With neither E nor switch every arc prints.
        return !_now.Strokes || _axis == ExtrusionAxis.Switched || wanted.Kind == MoveKind.Print;
    }
}

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
    private readonly List<(byte[] Text, int Start, int End, int Next)> _comments = [];
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
        foreach (var (text, start, end, next) in _comments)
        {
            if (keep) _text.Line(text, start, end, next);
        }
        _comments.Clear();
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
        var before = _now.Save();
        if (wanted.Tool != before.Tool && wanted.Tool >= 0)
        {
            Command("T" + NumberFormatter.Format(wanted.Tool));
            before = _now.Save();
        }
        if (wanted.Kind == MoveKind.Dwell) return;
        if (wanted.E == 0 && wanted.Kind is MoveKind.Retract or MoveKind.Restore && _rules.FirmwareRetraction && wanted.E == 0)
        {
            Command(wanted.Kind == MoveKind.Retract ? "G10" : "G11");
            return;
        }
        if (wanted.Arc is { } arc && !CanArc(wanted, before))
        {
            Chords(wanted, arc, before);
            return;
        }
        StateE(wanted, ref before);
        var code = wanted.Arc is { } turn ? (turn.Sweep < 0 ? "G2" : "G3") : wanted.Kind == MoveKind.Travel && _style.TravelsByG0 ? "G0" : "G1";
        var bytes = Encoding.ASCII.GetBytes(_style.LowerCase ? code.ToLowerInvariant() : code);
        _rewriter.Rewrite(bytes, 0, bytes.Length, wanted, before, _now.IsRelativeE, _owed);
        // Nothing but the command: no printed change.
        if (_rewriter.Count <= bytes.Length) return;
        _now.ReadLine(_rewriter.Bytes, 0, _rewriter.Count, out _);
        Owe(wanted);
        _text.Own(_rewriter.Bytes, _rewriter.Count);
    }

    private void Chords(Wanted wanted, Arc arc, MachineSnapshot before)
    {
        var start = new Vec3(before.X + before.ShiftX, before.Y + before.ShiftY, before.Z + before.ShiftZ);
        var end = new Vec3(wanted.X, wanted.Y, wanted.Z);
        var count = Math.Min(arc.ChordCount(start, ChordTolerance), 100_000);
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
        // Printed alike, a short arc would become a circle.
        var start = new Vec3(state.X + state.ShiftX, state.Y + state.ShiftY, state.Z + state.ShiftZ);
        var end = new Vec3(wanted.X, wanted.Y, wanted.Z);
        var closed = start.DistanceTo(end) < 2 * _tolerance;
        return !closed || Math.Abs(arc.Sweep) > 180;
    }
}

using System;
using System.Collections.Generic;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Dialects;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Lines that are put in, and the moves and events that ask for them.</summary>
internal sealed partial class Splicer
{
    private readonly List<CommentLine> _comments = [];
    private readonly CutComments _cut = new();
    private MoveCursor _cursor = null!;
    private SplicePlan _plan = null!;
    private int _read;
    private int _nextEvent;
    // What the line has to do: moves of its own, and moves and events that are put in front of them.
    private readonly List<SpliceTask> _tasks = [];

    private int _own;

    private void Take(int moves)
    {
        _tasks.Clear();
        _own = 0;
        if (_target is not null)
        {
            for (var i = 0; i < moves; i++) Own(new Wanted(_in.LastMoves, i) with { Arc = moves == 1 ? _in.LastArc : null, Turns = _in.Turns });
            return;
        }
        // Moves whose line made none here would hold up all others.
        while (_cursor.Valid && _cursor.Source < _number && _cursor.LeadsTo() < _number) _cursor.Next();
        while (_cursor.Valid && _cursor.LeadsTo() == _number)
        {
            NewEvents(_cursor.Number);
            if (_cursor.Source < 0) _tasks.Add(new SpliceTask(null, _cursor.Wanted()));
            else Own(_cursor.Wanted());
            _cursor.Next();
        }
    }

    private void Own(Wanted wanted)
    {
        _own++;
        _tasks.Add(new SpliceTask(null, wanted));
    }

    private void NewEvents(int move)
    {
        while (_nextEvent < _plan.Events.Count && _plan.Events[_nextEvent].Move <= move) NextEvent();
    }

    private void NextEvent()
    {
        if (_plan.IsNew[_nextEvent]) _tasks.Add(new SpliceTask(_plan.Events[_nextEvent].Event, default));
        _nextEvent++;
    }

    // What is put in before the events of this line.
    private void TakeBeforeEvents(int count)
    {
        _tasks.Clear();
        if (_target is not null) return;
        for (var i = 0; i < count; i++)
        {
            var place = _plan.PlaceOf(_decoding.Toolpath.Events[_read + i].Event);
            if (place < 0) continue;
            for (; _cursor.Valid && _cursor.Source < 0 && _cursor.Number < _plan.Events[place].Move; _cursor.Next())
            {
                NewEvents(_cursor.Number);
                _tasks.Add(new SpliceTask(null, _cursor.Wanted()));
            }
            while (_nextEvent < place) NextEvent();
        }
        Put(_tasks.Count);
        _tasks.Clear();
    }

    // Lines of their own for the tasks up to the one for which the line itself may do.
    private void Put(int count)
    {
        for (var i = 0; i < count; i++)
        {
            if (_tasks[i].Event is { } what) Event(what);
            else Fresh(_tasks[i].Wanted);
        }
    }

    // What is put in behind the last move of the file.
    private void End()
    {
        _tasks.Clear();
        for (; _target is null && _cursor.Valid; _cursor.Next())
        {
            NewEvents(_cursor.Number);
            if (_cursor.Source < 0) _tasks.Add(new SpliceTask(null, _cursor.Wanted()));
        }
        NewEvents(int.MaxValue);
        if (_tasks.Count > 0) _text.CloseLine();
        Put(_tasks.Count);
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
        var code = wanted.Arc is { } turn ? "G" + NumberFormatter.Format(_rules.ArcCode(turn.Plane, turn.Sweep < 0)) : wanted.Kind == MoveKind.Travel
            && _style.TravelsByG0 ? "G0" : "G1";
        var bytes = Encoding.ASCII.GetBytes(_style.LowerCase ? code.ToLowerInvariant() : code);
        _made.Scan(bytes, 0, bytes.Length);
        _rewriter.Rewrite(_made, bytes, 0, bytes.Length, wanted, before, Code(wanted), _now.IsRelativeE, Owed, false);
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
        if (arc.Plane != state.Plane || (arc.Turns > 1 && _rules.TurnsWord(arc.Turns) == 0)) return false;
        if (_rules.HelixRisesFirst && Math.Abs(wanted.Z - state.Z - state.ShiftZ) > NoChange) return false;
        if (!_rules.CounterclockwiseCircles && arc.Sweep > 359.999) return false;
        if (_rules.ArcTolerance is { } tolerance
            && tolerance.Refuses(arc.Radius(new Vec3(state.X + state.ShiftX, state.Y + state.ShiftY, state.Z + state.ShiftZ)),
            arc.Radius(new Vec3(wanted.X, wanted.Y, wanted.Z)))) return false;
        // With neither E nor switch every arc prints.
        return !_now.Strokes || _axis == ExtrusionAxis.Switched || wanted.Kind == MoveKind.Print;
    }
}

/// <summary>Something that a line has to do: an event, or a move.</summary>
internal readonly record struct SpliceTask(PrinterEvent? Event, Wanted Wanted);

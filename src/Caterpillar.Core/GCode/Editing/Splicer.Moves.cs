using System;
using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Lines of motion: as they are, behind a line of state, with other words, or replaced.</summary>
internal sealed partial class Splicer
{
    private readonly Dictionary<int, double> _owedByTool = [];

    // One move: the line as it is, the line behind a line of state, or the line with other words.
    private void One(byte[] text, int start, int end, int next, Wanted wanted)
    {
        if (IsLost(wanted))
        {
            _text.Dropped(_line);
            return;
        }
        wanted = Scaled(wanted);
        Prepare(wanted);
        var before = _now.Save();
        if (!Anew && Does(text, end, wanted) && !MustRewrite(text))
        {
            Owe(wanted);
            _text.Line(text, start, end, next);
            return;
        }
        if (!Anew && _target is null && _now.LastMoves.Count == 1 && EndsRight(wanted))
        {
            _now.Restore(before);
            if (Bridge(wanted, ref before) && Does(text, end, wanted))
            {
                _text.Line(text, start, end, next);
                return;
            }
        }
        _now.Restore(before);
        if (ModesFirst()) before = _now.Save();
        if ((wanted.Arc is not null && !CanArc(wanted, before)) || SaysInches)
        {
            Instead(wanted);
            return;
        }
        _rewriter.Rewrite(_line, text, start, end, wanted, before, Code(wanted), _now.IsRelativeE, Owed, Anew);
        _now.ReadLine(_rewriter.Bytes, 0, _rewriter.Count, out _);
        if (!IsDone(wanted))
        {
            _now.Restore(before);
            _text.Dropped(_line);
            Chords(wanted, wanted.Arc!.Value, before);
            return;
        }
        Owe(wanted);
        _text.Line(_rewriter.Bytes, 0, _rewriter.Count, text, end, next);
    }

    // The move in lines of its own.
    private void Instead(Wanted wanted)
    {
        _text.Dropped(_line);
        Fresh(wanted);
    }

    // What has to be in force before a move: its tool, the switch of the extruder, the mode of E.
    private void Prepare(Wanted wanted)
    {
        if (wanted.Tool != _now.ToolNumber && wanted.Tool >= 0)
        {
            if (wanted.Tool < _rules.ToolLimit) Event(new ToolEvent(wanted.Tool));
            else if (wanted.Tool > 0) Diagnostics.Add(Severity.Warning, "gcode.tools_lost", _rules.Title + " knows no change of tools: they are left out.");
        }
        if (_axis == ExtrusionAxis.Switched && wanted.Kind == MoveKind.Print != _now.IsSwitchedOn) Command(_now.IsSwitchedOn ? "M103" : "M101");
        StateE(wanted);
    }

    // The motion command that a move needs: where nothing says E, G0 travels and G1 prints. -1 for any.
    private int Code(Wanted wanted) => !_now.Strokes ? -1 : wanted.Kind == MoveKind.Print ? 1 : _axis == ExtrusionAxis.Switched ? -1 : 0;

    // True when the line that was read last makes the wanted move within print precision.
    private bool IsDone(Wanted wanted)
    {
        var c = _now.LastMoves;
        if (c.Count != 1 || wanted.Arc is null) return wanted.Arc is null;
        return Alike(_now.LastArc, wanted.Arc);
    }

    private bool IsHome()
    {
        foreach (var what in _in.LastEvents)
        {
            if (what.Event is HomeEvent) return true;
        }
        return false;
    }

    // Lines of state that let the rest of the file stay as it is: G92 E where E is absolute, F where it is inherited.
    private bool Bridge(Wanted wanted, ref MachineSnapshot before)
    {
        var done = false;
        var original = _in.LastMoves;
        var unchanged = original.Count == 1 && Math.Abs(original.E[0] - wanted.E) <= NoChange;
        var extruder = _decoding.Axis.Letter;
        if (!_now.IsRelativeE && unchanged && extruder != 0 && _line.Find((char)extruder) >= 0)
        {
            var unit = before.UnitOfE;
            var e = _line.Get((char)extruder, 0) * unit - wanted.E;
            if (Math.Abs(e - before.E) > NoChange)
            {
                State("G92", (char)extruder, e / unit, Math.Max(_style.DecimalsE, 5));
                done = true;
            }
        }
        var sameSpeed = original.Count == 1 && Math.Abs(original.Speed[0] - wanted.Speed) <= 1e-9 * wanted.Speed;
        if (sameSpeed && wanted.Speed > 0 && _line.Find('F') < 0 && Math.Abs(wanted.Speed - before.Speed) > 1e-9 * wanted.Speed)
        {
            State(before.Motion == 0 ? "G0"
                : "G1", 'F', wanted.Speed * 60 / before.FeedFactor / (before.Inches ? 25.4 : 1), _style.DecimalsF + (before.Inches ? 2 : 0));
            done = true;
        }
        if (done) before = _now.Save();
        return done;
    }

    private bool Does(byte[] text, int end, Wanted wanted)
    {
        if (_now.ReadLine(_line, text, end, out _) != 1) return false;
        var c = _now.LastMoves;
        var owed = _target is null ? 0 : Owed;
        return EndsRight(wanted) && (wanted.Turns == _now.Turns || wanted.Turns.IsNear(_now.Turns)) && Math.Abs(c.E[0] - wanted.E - owed) <= _toleranceE
            && (!(wanted.Speed > 0) || Math.Abs(c.Speed[0] - wanted.Speed) <= 1e-9 * wanted.Speed)
            && (!_now.Strokes || c.Kind[0] == MoveKind.Print == (wanted.Kind == MoveKind.Print));
    }

    private bool EndsRight(Wanted wanted)
    {
        var c = _now.LastMoves;
        return Math.Abs(c.X[0] - wanted.X) <= NoChange && Math.Abs(c.Y[0] - wanted.Y) <= NoChange && Math.Abs(c.Z[0] - wanted.Z) <= NoChange
            && Alike(_now.LastArc, wanted.Arc);
    }

    // Modes in the line of a motion hold for its words: they are stated in front, so that the words can be worked out.
    private bool ModesFirst()
    {
        var any = false;
        for (var i = 0; i < _line.Count; i++)
        {
            if (_line.Letters[i] != 'G' || !_line.HasValue[i] || !IsMode(_line.Values[i])) continue;
            if (_line.Values[i] == 20 && _target is { Millimeters: true }) continue;
            Command("G" + NumberFormatter.Format(_line.Values[i], 1));
            any = true;
        }
        return any;
    }

    private static bool IsMode(double code) => code is 17 or 18 or 19 or 20 or 21 or 90 or 91 or 90.1 or 91.1;

    private bool Alike(Geometry.Arc? a, Geometry.Arc? b)
    {
        if (a is not { } x || b is not { } y) return a is null && b is null;
        var d = x.Center - y.Center;
        var off = x.Plane switch { Geometry.ArcPlane.XY => d.WithZ(0), Geometry.ArcPlane.ZX => new Geometry.Vec3(d.X, 0, d.Z),
            _ => new Geometry.Vec3(0, d.Y, d.Z) };
        return x.Plane == y.Plane && off.Length <= 2 * _tolerance && Math.Abs(x.Sweep - y.Sweep) < 1;
    }

    private double Owed => _owedByTool.TryGetValue(_now.ToolNumber, out var owed) ? owed : 0;

    // What rounding left of the tool's E; carried on to the next line that is written anew.
    private void Owe(Wanted wanted)
    {
        var c = _now.LastMoves;
        if (_extruder == 0) return;
        var made = c.Count == 1 ? c.E[0] : 0;
        var owed = Owed + wanted.E - made;
        _owedByTool[_now.ToolNumber] = Math.Abs(owed) > 1 ? 0 : owed;
    }

    // A motion command that moves nothing: it may set F; where it would move now, only that stays.
    private void NoMove(byte[] text, int start, int end, int next)
    {
        var before = _now.Save();
        if (_now.ReadLine(_line, text, end, out _) == 0 && !SaysInches && !MustRewrite(text))
        {
            _text.Line(text, start, end, next);
            return;
        }
        _now.Restore(before);
        _text.Dropped(_line);
        ModesFirst();
        if (_line.TryGet('F', out var feed)) State("G1", 'F', feed * (_in.Save().Inches ? 25.4 : 1) / (_now.Save().Inches ? 25.4 : 1), _style.DecimalsF);
    }

    // The line scanned last brings inches that are to go.
    private bool SaysInches => _target is { Millimeters: true } && _line.HasCode(20);

    // Modes that stand in a line whose move is cut out stay.
    private void Removed()
    {
        _text.Dropped(_line);
        if (_line.Shape == LineShape.Code) ModesFirst();
    }
}

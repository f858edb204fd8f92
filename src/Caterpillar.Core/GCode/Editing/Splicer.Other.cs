using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Lines without motion of their own: modes, names of places, machine commands, homing, firmware retraction, dwells.</summary>
internal sealed partial class Splicer
{
    // A line stays where the target takes it as the file's firmware does; otherwise what it did is said in the target's words.
    private void Other(byte[] text, int start, int end, int next)
    {
        if (_target is not null && _line.Shape == LineShape.Code && Replacement(text, end) is { } lines)
        {
            _text.Dropped(_line);
            foreach (var line in lines) Command(line);
            return;
        }
        var before = _now.Save();
        var moves = _now.ReadLine(_line, text, end, out var commands);
        // A tool that worked already here, and no longer does behind one that was put in, is not to be taken.
        if (_target is null && _in.LastEvents.Count == 0 && _now.LastEvents.Count > 0)
        {
            _now.Restore(before);
            _text.Dropped(_line);
            return;
        }
        if (_target is not null && !MeansTheSame(moves, commands))
        {
            _now.Restore(before);
            Say(text, end);
            return;
        }
        if (IsNaming() && !SameNames())
        {
            _now.Restore(before);
            _text.Dropped(_line);
            var extruder = _decoding.Axis.FirstLetter;
            Command(Names(true, true, true, extruder != 0 && _line.Find((char)extruder) >= 0) + Comment(text, end));
            return;
        }
        _text.Line(text, start, end, next);
        // Some firmware forgets at home what G92 has said.
        if (_target is not null && IsHome() && !SameNames()) Command(Names(true, true, true, false));
    }

    // What came of the line that both machines have read last.
    private bool MeansTheSame(int moves, int commands)
    {
        var here = _in.LastEvents;
        var there = _now.LastEvents;
        // A motion that the file's firmware refuses goes, also where the target would refuse it.
        if (commands > 0 || (_line.Shape == LineShape.Code && (_line.HasCode(0) || _line.HasCode(1) || _line.HasCode(2) || _line.HasCode(3)))) return false;
        if ((moves > 0 && _in.LastMoves.Count == 0 && !IsHome()) || here.Count != there.Count) return false;
        for (var i = 0; i < here.Count; i++)
        {
            if (!here[i].Event.Equals(there[i].Event)) return false;
        }
        return true;
    }

    // The events of a line in the words of the target; a line without any means nothing to the file's own firmware and goes.
    private void Say(byte[] text, int end)
    {
        var comment = Comment(text, end);
        _text.Dropped(_line);
        if (_line.Shape == LineShape.Code && _line.Letters[0] != 'M') ModesFirst();
        foreach (var what in _in.LastEvents.ToArray())
        {
            foreach (var line in EventText.Lines(what.Event, _rules))
            {
                Command(line + comment);
                comment = "";
            }
        }
        if (IsHome() && !SameNames()) Command(Names(true, true, true, false));
    }

    private bool IsNaming() => _line.Shape == LineShape.Code && _line.Letters[0] == 'G' && _line.HasValue[0] && Math.Floor(_line.Values[0]) == 92;

    private bool SameNames()
    {
        var a = _in.Save();
        var b = _now.Save();
        return Near(a.ShiftX, b.ShiftX) && Near(a.ShiftY, b.ShiftY) && Near(a.ShiftZ, b.ShiftZ);
    }

    private static bool Near(double a, double b) => Math.Abs(a - b) <= NoChange;

    // The place where the head stands by the name that lets coordinates mean what they mean in the file.
    private string Names(bool x, bool y, bool z, bool e)
    {
        var file = _in.Save();
        var now = _now.Save();
        var unit = now.Inches ? 25.4 : 1;
        var line = "G92";
        // Where nothing is known of an axis yet, its name is its place.
        if (x) line += " X" + Text(now.X + now.ShiftX - (now.KnownX ? file.ShiftX : 0), unit);
        if (y) line += " Y" + Text(now.Y + now.ShiftY - (now.KnownY ? file.ShiftY : 0), unit);
        if (z) line += " Z" + Text(now.Z + now.ShiftZ - (now.KnownZ ? file.ShiftZ : 0), unit);
        if (e && _extruder != 0) line += " " + (char)_extruder + Text(file.E * (_target?.Factor(now.Tool) ?? 1), now.UnitOfE);
        return line;
    }

    // An inch is coarser.
    private static string Text(double value, double unit = 1) => NumberFormatter.Format(value / unit, unit > 1000 ? 11 : unit > 1 ? 8 : 6);
}

using System;
using Caterpillar.Basics;
using Caterpillar.Machines;

namespace Caterpillar.GCode;

/// <summary>Conversion: the same print in other words.</summary>
internal sealed partial class Splicer
{
    private readonly ConvertTarget? _target;

    private double ChordTolerance => _target?.ChordTolerance ?? 0.01;

    private bool ExpandArcs => _target is { ExpandArcs: true };

    private Wanted Scaled(Wanted wanted) => _target is { EFactor: not 1 } ? wanted with { E = wanted.E * _target.EFactor } : wanted;

    // Words that the target reads otherwise, or not at all, although the move would be the same here.
    private bool MustRewrite(byte[] text, int start, int end)
    {
        if (_target is null) return false;
        if (ExpandArcs && _in.LastArc is not null) return true;
        _line.Scan(text, start, end);
        if (_target.Millimetres && _in.Save().Inches) return true;
        return _extruder != _decoding.Axis.Letter && _line.Find((char)_decoding.Axis.Letter) >= 0;
    }

    // States the mode of E that is asked for, where the file has left another one.
    private void StateE(Wanted wanted, ref MachineSnapshot before)
    {
        if (_target?.RelativeE is not { } relative || wanted.E == 0 || _now.IsRelativeE == relative) return;
        if (_rules.RelativeE == RelativeERule.OnlyG90G91) return;
        // In G91 most firmwares count E relative whatever is said.
        if (before.Relative && !relative && _rules.RelativeE == RelativeERule.EitherG91OrM83) return;
        Command(relative ? "M83" : "M82");
        before = _now.Save();
    }

    // Lines without motion.
    private void Other(byte[] text, int start, int end, int next)
    {
        if (_target is null)
        {
            _now.ReadLine(text, start, end, out _);
            _text.Line(text, start, end, next);
            return;
        }
        _line.Scan(text, start, end);
        var replacement = _line.Shape == LineShape.Code ? Replacement(text, start, end) : null;
        if (replacement is null)
        {
            _now.ReadLine(text, start, end, out _);
            _text.Line(text, start, end, next);
            return;
        }
        _text.Dropped(_line);
        foreach (var line in replacement) Command(line);
    }

    // Null where the line stays; otherwise the lines in its place, perhaps none.
    private string[]? Replacement(byte[] text, int start, int end)
    {
        var letter = _line.Letters[0];
        var code = _line.HasValue[0] ? _line.Values[0] : -1;
        var target = _target!;
        var comment = _line.CommentStart >= 0 ? " " + TextEncoding.Decode(text, _line.CommentStart, end) : "";
        if (letter == 'M' && code is 82 or 83 && target.RelativeE is not null) return [];
        if (letter == 'M' && code == 200 && target.EFactor != 1) return [];
        if (letter == 'T' && _rules.ToolByM6 && !_decoding.Dialect.ToolByM6) return ["M6 T" + NumberFormatter.Format(code, 0) + comment];
        if (letter == 'M' && code == 6 && !_rules.ToolByM6 && _decoding.Dialect.ToolByM6) return ["T" + NumberFormatter.Format(_line.Get('T', 0), 0) + comment];
        if (letter == 'M' && IsForeignPause(code)) return [_rules.Pauses[0] + comment];
        if (letter != 'G') return null;
        return code switch
        {
            20 or 21 when target.Millimetres && _line.Count == 1 => code == 20 ? [] : null,
            92 => Rename(comment),
            4 => Dwell(comment),
            10 or 11 when !HasOffsetWord() && !_rules.FirmwareRetraction => FirmwareRetraction(code == 10, comment),
            _ => null,
        };
    }

    private bool HasOffsetWord() => _line.Has('P') || _line.Has('L') || _line.Has('X') || _line.Has('Y') || _line.Has('Z');

    private bool IsForeignPause(double code)
    {
        var name = "M" + NumberFormatter.Format(code, 0);
        var here = false;
        foreach (var pause in _decoding.Dialect.Pauses) here |= pause == name;
        if (!here || _rules.Pauses.Count == 0) return false;
        foreach (var pause in _rules.Pauses)
        {
            if (pause == name) return false;
        }
        return true;
    }

    // G92: an extruder of another letter, a bare one that the target takes otherwise, inches.
    private string[]? Rename(string comment)
    {
        var state = _in.Save();
        var from = (char)_decoding.Axis.Letter;
        if (_line.Count == 1)
        {
            if (_rules.BareG92 == _decoding.Dialect.BareG92) return null;
            if (_decoding.Dialect.BareG92 == BareG92Rule.Nothing) return [];
            return ["G92 X" + Text(state.X) + " Y" + Text(state.Y) + " Z" + Text(state.Z) + (_extruder != 0 ? " " + (char)_extruder + "0" : "") + comment];
        }
        var hasE = _decoding.Axis.Letter != 0 && _line.Find(from) >= 0;
        if (from == _extruder && _target!.EFactor == 1 && !(_target.Millimetres && state.Inches)) return null;
        if (!hasE && !(_target!.Millimetres && state.Inches)) return null;
        var line = "G92";
        if (_line.Find('X') >= 0) line += " X" + Text(state.X);
        if (_line.Find('Y') >= 0) line += " Y" + Text(state.Y);
        if (_line.Find('Z') >= 0) line += " Z" + Text(state.Z);
        if (hasE && _extruder != 0) line += " " + (char)_extruder + Text(state.E * _target!.EFactor);
        return line == "G92" ? [] : [line + comment];
    }

    private static string Text(double value) => NumberFormatter.Format(value, 6);

    private string[]? Dwell(string comment)
    {
        var from = _decoding.Dialect;
        var seconds = _line.TryGet('S', out var s) && from.DwellS > 0 ? s * from.DwellS : _line.TryGet('P', out var p) ? p * from.DwellP : 0;
        var there = _line.TryGet('S', out s) && _rules.DwellS > 0 ? s * _rules.DwellS : _line.TryGet('P', out p) ? p * _rules.DwellP : 0;
        if (seconds == there || !(seconds is >= 0 and < 1e9)) return null;
        return ["G4 P" + NumberFormatter.Format(seconds / _rules.DwellP, _rules.DwellP == 1 ? 3 : 0) + comment];
    }

    private string[] FirmwareRetraction(bool retract, string comment)
    {
        if (_target!.RetractionLength <= 0 || _extruder == 0)
        {
            Diagnostics.Add(Severity.Warning, "gcode.retraction_lost", _rules.Title + " knows no G10 and G11, and no length of retraction is given: they are left out.", new SourceLocation(Line: _number));
            return [];
        }
        var length = retract ? -_target.RetractionLength : _target.RetractionLength;
        if (_target.RelativeE is { } relative && _now.IsRelativeE != relative && _rules.RelativeE != RelativeERule.OnlyG90G91) Command(relative ? "M83" : "M82");
        var value = _now.IsRelativeE ? length : _now.Save().E + length;
        return ["G1 " + (char)_extruder + Text(value) + " F" + Text(_target.RetractionSpeed * 60) + comment];
    }
}

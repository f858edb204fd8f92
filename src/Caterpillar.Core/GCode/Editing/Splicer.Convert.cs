using System;
using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Dialects;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Conversion: the same print in other words.</summary>
internal sealed partial class Splicer
{
    private readonly ConvertTarget? _target;
    private bool _diameterStated;

    private double ChordTolerance => _target?.ChordTolerance ?? 0.01;

    private bool ExpandArcs => _target is { ExpandArcs: true };

    // E in the unit of the target; and what M221 did, where it does something else there.
    private Wanted Scaled(Wanted wanted)
    {
        if (_target is null || wanted.E == 0) return wanted;
        var e = wanted.E;
        if (_in.Flow != _now.Flow && _in.LastMoves.Count == 1) e += _in.LastMoves.Deposited[0] * (1 / _now.Flow - 1 / _in.Flow);
        return wanted with { E = e * _target.Factor(wanted.Tool) };
    }

    // In a target without E nothing is left of what happens in place.
    private bool IsLost(Wanted wanted)
        => _extruder == 0 && _target is not null && _decoding.Axis.HasAmounts && wanted.Kind is MoveKind.Retract or MoveKind.Restore or MoveKind.Prime;

    // Words that the target reads otherwise, or not at all, although the move would be the same here.
    private bool MustRewrite(byte[] text)
    {
        if (_target is null) return false;
        if (ExpandArcs && _in.LastArc is not null) return true;
        if (_target.Millimeters && _in.Save().Inches) return true;
        if (_target.LimitsDecimals && _rewriter.IsTooFine(_line, text)) return true;
        var from = _decoding.Axis;
        if (from == ExtrusionAxis.Both) return _axis != from && (_line.Find('A') >= 0 || _line.Find('B') >= 0);
        return _axis != from && from.Letter != 0 && _line.Find((char)from.Letter) >= 0;
    }

    // States the mode of E that is asked for (else that of the file), where another one is in force; and once that E is a volume.
    private void StateE(Wanted wanted)
    {
        if (_target is null || wanted.E == 0 || _extruder == 0) return;
        if (_target.StatedDiameter is { } diameter && !_diameterStated)
        {
            _diameterStated = true;
            Command("M200 D" + Text(diameter));
        }
        var relative = _target.RelativeE ?? _in.IsRelativeE;
        if (_now.IsRelativeE == relative || _rules.RelativeE == RelativeERule.OnlyG90G91) return;
        // In G91 most firmwares count E relative whatever is said.
        if (!relative && _rules.RelativeE == RelativeERule.EitherG91OrM83 && _now.Save().Relative) return;
        Command(relative ? "M83" : "M82");
    }

    // Null where the line stays as far as its words go; otherwise the lines in its place, perhaps none.
    private IReadOnlyList<string>? Replacement(byte[] text, int end)
    {
        var target = _target!;
        var letter = _line.Letters[0];
        var code = _line.HasValue[0] ? _line.Values[0] : -1;
        var from = _decoding.Dialect;
        if (letter == 'M')
        {
            if (code is 82 or 83 && (target.RelativeE is not null || from.RelativeE != _rules.RelativeE)) return [];
            if (code == 200 && (target.ChangesUnit || !_rules.Volumetric || !from.Volumetric)) return [];
            if (code == 220 && from.SpeedFactor != _rules.SpeedFactor) return [];
            if (code == 221 && (from.FlowFactor == FlowFactorRule.Ignored || _rules.FlowFactor == FlowFactorRule.Ignored)) return [];
            return null;
        }
        if (letter != 'G') return null;
        if (target.Millimeters && _line.HasCode(20)) return OtherModes();
        return code switch
        {
            92 => Rename(Comment(text, end)),
            10 or 11 when _in.LastMoves.Count > 0 && _rules.FirmwareRetraction
                => _line.HasAny(_rules.NoRetractionWith) ? ["G" + NumberFormatter.Format(code, 0) + Comment(text, end)] : null,
            10 or 11 when _in.LastMoves.Count > 0 => FirmwareRetraction(code == 10, Comment(text, end)),
            _ => null,
        };
    }

    private string Comment(byte[] text, int end) => _line.CommentStart >= 0 ? " " + TextEncoding.Decode(text, _line.CommentStart, end) : "";

    // The modes of a line but its unit.
    private List<string> OtherModes()
    {
        var modes = new List<string>();
        for (var i = 0; i < _line.Count; i++)
        {
            if (_line.Letters[i] == 'G' && _line.HasValue[i] && _line.Values[i] is not (20 or 21)
                && IsMode(_line.Values[i])) modes.Add("G" + NumberFormatter.Format(_line.Values[i], 1));
        }
        return modes;
    }

    // G92: an extruder of another letter, a bare one that the target takes otherwise, inches, volumes.
    private string[]? Rename(string comment)
    {
        var target = _target!;
        var from = _decoding.Axis;
        var inches = target.Millimeters && _in.Save().Inches;
        if (_line.Count == 1)
        {
            if (_rules.BareG92 == _decoding.Dialect.BareG92 && !target.ChangesUnit) return null;
            return _decoding.Dialect.BareG92 == BareG92Rule.Nothing ? [] : [Names(true, true, true, true) + comment];
        }
        var hasE = from == ExtrusionAxis.Both ? _line.Find('A') >= 0 || _line.Find('B') >= 0 : from.Letter != 0 && _line.Find((char)from.Letter) >= 0;
        var otherE = hasE && (_axis != from || target.ChangesUnit || (_in.Save().Inches && _decoding.Dialect.InchesOfE != _rules.InchesOfE));
        if (!otherE && !inches) return null;
        var line = Names(_line.Find('X') >= 0, _line.Find('Y') >= 0, _line.Find('Z') >= 0, hasE);
        return line == "G92" ? [] : [line + comment];
    }

    private string[] FirmwareRetraction(bool retract, string comment)
    {
        if (_target!.RetractionLength <= 0 || _extruder == 0)
        {
            Diagnostics.Add(Severity.Warning, "gcode.retraction_lost", _rules.Title
                + " knows no G10 and G11, and no length of retraction is given: they are left out.", new SourceLocation(Line: _number));
            return [];
        }
        var length = retract ? -_target.RetractionLength : _target.RetractionLength;
        StateE(new Wanted { E = length });
        var now = _now.Save();
        var unit = now.Inches ? 25.4 : 1;
        var value = _now.IsRelativeE ? length : now.E + length;
        return ["G1 " + (char)_extruder + Text(value, now.UnitOfE) + " F" + Text(_target.RetractionSpeed * 60 / now.FeedFactor, unit) + comment];
    }
}

namespace Caterpillar.GCode;

/// <summary>
/// Lines without motion: modes, position names, machine commands, homing, firmware retraction, dwells. A line stays if it means the same in the target.
/// Otherwise it is translated.
/// </summary>
internal sealed class OtherLines(SpliceContext context, MoveConversion conversion, bool hasStart)
{
    private readonly ConvertTarget? _target = context.Target;
    private readonly FlavorRules _rules = context.Rules;
    private readonly ParsedLine _line = context.Line;
    private readonly SplicedText _text = context.Text;
    private readonly LineTranslation? _translation = context.Target is null
        || context.Rules.Name == context.Decoding.Flavor.Name || context.Rules.Name == FlavorTable.Slicer.Name ? null
        : new LineTranslation(context, hasStart);

    /// <summary>Writes the current line with its figures, or others in its place.</summary>
    public void Write(FileLine line, FileLine image)
    {
        var written = context.Written;
        if (_target is not null && _line.Shape == LineShape.Code && Replacement(_target, line) is { } lines)
        {
            _text.Drop(_line);
            foreach (var other in lines) context.Command(other);
            return;
        }
        if (_translation?.IsForeign(line) == true)
        {
            WriteEvents(line);
            _translation.Watch();
            return;
        }
        var before = written.Save();
        var moves = written.ReadLine(_line, line.Text, line.End, out var commands);
        // A tool that was selected already, and is no longer after another one was put in, must not be selected.
        if (_target is null && context.Read.LastEvents.Count == 0 && written.LastEvents.Count > 0)
        {
            written.Restore(before);
            _text.Drop(_line);
            return;
        }
        if (_target is not null && !MeansTheSame(moves, commands))
        {
            written.Restore(before);
            WriteEvents(line);
            _translation?.Watch();
            return;
        }
        if (IsG92() && !context.HasSameShift)
        {
            written.Restore(before);
            _text.Drop(_line);
            var extruder = context.Decoding.Axis.FirstLetter;
            context.Command(context.RenamePosition(true, true, true, extruder != 0 && _line.Find((char)extruder) >= 0) + context.Comment(line));
            return;
        }
        _text.Add(image);
        _translation?.Watch();
        // Some firmware forgets what G92 has said when it homes.
        if (_target is not null && context.LineHomes && !context.HasSameShift) context.Command(context.RenamePosition(true, true, true, false));
    }

    /// <summary>Reports what a conversion left out.</summary>
    public void Report() => _translation?.Report();

    private bool IsG92() => _line.Shape == LineShape.Code && _line.Letters[0] == 'G' && _line.HasValue[0] && Math.Floor(_line.Values[0]) == 92;

    // Whether both machines have made the same of the line that they have read last.
    private bool MeansTheSame(int moves, int commands)
    {
        var read = context.Read.LastEvents;
        var written = context.Written.LastEvents;
        // A motion that the file's firmware refuses goes, also where the target would refuse it.
        if (commands > 0 || (_line.Shape == LineShape.Code && (_line.HasCode(0) || _line.HasCode(1) || _line.HasCode(2) || _line.HasCode(3)))) return false;
        if (moves > 0 && context.Read.LastMoves.Count == 0 && !context.LineHomes) return false;
        return read.Select(e => e.Event).SequenceEqual(written.Select(e => e.Event));
    }

    // The line in the words of the target; one that means nothing to the file's own firmware goes.
    private void WriteEvents(FileLine line)
    {
        var comment = context.Comment(line);
        _text.Drop(_line);
        if (_line.Shape == LineShape.Code && _line.Letters[0] != 'M') context.WriteModes();
        var lines = _translation?.Lines(line) ?? [.. context.Read.LastEvents.SelectMany(e => EventText.Lines(e.Event, _rules))];
        foreach (var text in lines)
        {
            context.Command(text + comment);
            comment = "";
        }
        if (context.LineHomes && !context.HasSameShift) context.Command(context.RenamePosition(true, true, true, false));
    }

    // Null where the line stays as far as its words go; otherwise the lines in its place, perhaps none.
    private IReadOnlyList<string>? Replacement(ConvertTarget target, FileLine line)
    {
        var letter = _line.Letters[0];
        var code = _line.HasValue[0] ? _line.Values[0] : -1;
        var from = context.Decoding.Flavor;
        if (letter == 'M')
        {
            var goes = code switch
            {
                82 or 83 => target.Options.RelativeE is not null || from.RelativeE != _rules.RelativeE,
                200 => target.ChangesUnit || !_rules.Volumetric || !from.Volumetric,
                220 => from.SpeedFactor != _rules.SpeedFactor,
                221 => from.FlowFactor == FlowFactorRule.Ignored || _rules.FlowFactor == FlowFactorRule.Ignored,
                _ => false,
            };
            return goes ? [] : null;
        }
        if (letter != 'G') return null;
        if (target.Millimeters && _line.HasCode(20)) return OtherModes();
        return code switch
        {
            92 => Rename(target, context.Comment(line)),
            10 or 11 when context.Read.LastMoves.Count > 0 && _rules.FirmwareRetraction
                => _line.HasAny(_rules.NoRetractionWith) ? ["G" + NumberFormatter.Format(code, 0) + context.Comment(line)] : null,
            10 or 11 when context.Read.LastMoves.Count > 0 => FirmwareRetraction(target, code == 10, context.Comment(line)),
            _ => null,
        };
    }

    // The modes of a line except its unit.
    private List<string> OtherModes()
        => [.. Enumerable.Range(0, _line.Count).Where(i => context.IsMode(i) && _line.Values[i] is not (20 or 21))
            .Select(i => "G" + NumberFormatter.Format(_line.Values[i], 1))];

    // G92: an extruder of another letter, a bare one that the target takes otherwise, inches, volumes.
    private string[]? Rename(ConvertTarget target, string comment)
    {
        var from = context.Decoding.Flavor;
        var inches = context.Read.State.Modes.Inches;
        if (_line.Count == 1)
        {
            if (_rules.BareG92 == from.BareG92 && !target.ChangesUnit) return null;
            return from.BareG92 == BareG92Rule.Nothing ? [] : [context.RenamePosition(true, true, true, true) + comment];
        }
        var hasE = conversion.HasExtruderWord();
        var changesE = hasE && (context.Axis != context.Decoding.Axis || target.ChangesUnit || (inches && from.InchesOfE != _rules.InchesOfE));
        if (!changesE && !(target.Millimeters && inches)) return null;
        var line = context.RenamePosition(_line.Find('X') >= 0, _line.Find('Y') >= 0, _line.Find('Z') >= 0, hasE);
        return line == "G92" ? [] : [line + comment];
    }

    private string[] FirmwareRetraction(ConvertTarget target, bool retract, string comment)
    {
        if (target.Options.RetractionLength <= 0 || context.Extruder == 0)
        {
            context.Diagnostics.Add(Severity.Warning, "gcode.retraction_lost", _rules.Title
                + " has no G10 and G11, and no retraction length is set. They are left out.", new SourceLocation(Line: context.Number));
            return [];
        }
        var length = retract ? -target.Options.RetractionLength : target.Options.RetractionLength;
        conversion.StateModeOfE(length);
        var state = context.Written.State;
        var value = state.Modes.RelativeE ? length : state.Extrusion.E + length;
        return ["G1 " + (char)context.Extruder + SpliceContext.Format(value, context.UnitOfE) + " F"
            + SpliceContext.Format(target.Options.RetractionSpeed * 60 / state.Feed.Factor, context.Unit) + comment];
    }
}

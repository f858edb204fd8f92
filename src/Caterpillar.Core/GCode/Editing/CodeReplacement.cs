namespace Caterpillar.GCode;

/// <summary>Replaces start and end G-code around the layers of a file, and leaves out the lines of a cut.</summary>
internal sealed class CodeReplacement
{
    private readonly SpliceContext _context;
    private readonly PartFigures _figures;
    private readonly List<LineCut> _cuts;

    /// <summary>Replaces the lines before the first layer and after the last one by the lines of the options.</summary>
    public CodeReplacement(SpliceContext context, EditOptions options, SplicePlan plan, PartFigures figures)
    {
        (_context, _figures) = (context, figures);
        _cuts = [.. options.Cuts];
        if (options.Start is not null || options.End is not null) Replace(options);
        foreach (var cut in _cuts) plan.Touch(Math.Max(cut.First - 1, 1), cut.Last < int.MaxValue ? cut.Last + 1 : cut.Last);
    }

    /// <summary>True if lines are replaced.</summary>
    public bool Changes => _cuts.Count > 0;

    /// <summary>True for lines that are neither left out nor the first after such lines.</summary>
    public bool IsOutside(int line) => CutOf(line) is null && CutOf(line - 1) is null && !_cuts.Exists(c => c.Last == line - 1);

    /// <summary>The cut that leaves out a line, or null.</summary>
    public LineCut? CutOf(int line) => _cuts.Find(c => c.Has(line));

    /// <summary>Writes what comes in place of the lines before this one, then the state that it expects.</summary>
    public void WriteBefore(int line)
    {
        foreach (var cut in _cuts)
        {
            if (cut.Last != line - 1) continue;
            foreach (var own in cut.Lines) Write(own);
            WriteState(cut);
        }
    }

    /// <summary>Writes the end G-code.</summary>
    public void WriteEnd()
    {
        foreach (var cut in _cuts)
        {
            if (cut.Last < int.MaxValue) continue;
            foreach (var line in cut.Lines) Write(line);
        }
    }

    private void Write(string line)
    {
        if (line.Length > 0 && line[0] != ';')
        {
            _context.Command(line);
            return;
        }
        var bytes = TextEncoding.Encode(_figures.Image(line, 1));
        _context.Text.AddOwn(bytes, bytes.Length);
    }

    private void Replace(EditOptions options)
    {
        var (first, last) = _context.Decoding.PrintedLines;
        if (last == 0)
        {
            _context.Diagnostics.Add(Severity.Warning, "gcode.no_layers", "The file has no layers. Its start and end G-code were not replaced.");
            return;
        }
        if (options.Start is { } start && _cuts.FindIndex(c => c.First == 1) is var at)
        {
            if (at < 0) _cuts.Add(new LineCut(1, first - 1, start, true));
            else _cuts[at] = _cuts[at] with { Lines = start };
        }
        if (options.End is { } end) _cuts.Add(new LineCut(last + 1, int.MaxValue, end));
    }

    private void WriteState(LineCut cut)
    {
        var expected = _context.Read.State;
        var written = _context.Written.State;
        if (expected.Modes.Inches != written.Modes.Inches && _context.Target is not { Millimeters: true })
            _context.Command(expected.Modes.Inches ? "G20" : "G21");
        if (expected.Tool != written.Tool) _context.Event(new ToolEvent(expected.Tool));
        if (expected.Modes.Plane != written.Modes.Plane) _context.Command("G" + NumberFormatter.Format(17 + (int)expected.Modes.Plane));
        if (cut.Moves || cut.Height > written.Head.Machine.Z) WriteMoves(cut, expected, written);
        if (cut.Lines.Count > 0 || expected.Modes.Relative != written.Modes.Relative) _context.Command(expected.Modes.Relative ? "G91" : "G90");
        // A conversion states E itself.
        if (_context.Extruder != 0 && _context.Target is null) WriteModeOfE(cut, expected);
        if (cut.Moves && expected.Feed.Rate > 0 && expected.Feed.Rate != written.Feed.Rate)
            _context.Command("G1", 'F', expected.Feed.Rate / _context.Unit, _context.Style.DecimalsF);
    }

    // Up before across, across before down.
    private void WriteMoves(LineCut cut, InterpreterState expected, InterpreterState written)
    {
        var unit = _context.Unit;
        var shift = written.Head.Shift;
        if (written.Modes.Relative) _context.Command("G90");
        if (!cut.Moves)
        {
            _context.Command("G0 Z" + SpliceContext.Format(cut.Height - shift.Z, unit));
            return;
        }
        if (expected.Head.HasMoved && expected.Head.Machine != written.Head.Machine)
        {
            var to = SpliceContext.Format(expected.Head.Machine - shift, unit);
            var z = to.IndexOf("Z", StringComparison.Ordinal);
            var height = to.Substring(z);
            var rises = expected.Head.Machine.Z >= written.Head.Machine.Z;
            if (rises) _context.Command("G0 " + height);
            _context.Command("G0 " + to.Substring(0, z - 1));
            if (!rises) _context.Command("G0 " + height);
        }
        if (expected.Head.Shift != shift) _context.Command("G92 " + SpliceContext.Format(expected.Head.Written, unit));
    }

    private void WriteModeOfE(LineCut cut, InterpreterState expected)
    {
        var rule = _context.Rules.RelativeE;
        var modes = expected.Modes;
        var isRelative = modes.M83 || (rule == RelativeERule.LastWins && modes.LastRelative);
        if (rule != RelativeERule.OnlyG90G91 && (cut.Lines.Count > 0 || modes.RelativeE != _context.Written.State.Modes.RelativeE))
            _context.Command(isRelative ? "M83" : "M82");
        if (cut.Moves && !_context.Written.State.Modes.RelativeE)
            _context.Command("G92 " + (char)_context.Extruder + SpliceContext.Format(expected.Extrusion.E, _context.UnitOfE));
    }
}

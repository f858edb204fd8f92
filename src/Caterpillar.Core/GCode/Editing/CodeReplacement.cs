using Caterpillar.Flavors;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Replaces start and end G-code around the layers of a file.</summary>
internal sealed class CodeReplacement
{
    private readonly SpliceContext _context;
    private readonly IReadOnlyList<string> _start = [];
    private readonly IReadOnlyList<string> _end = [];

    /// <summary>Replaces the lines before the first layer and after the last one by the lines of the options.</summary>
    public CodeReplacement(SpliceContext context, EditOptions options, SplicePlan plan)
    {
        _context = context;
        if (options.Start is null && options.End is null) return;
        var (first, last) = PrintedLines(context.Decoding);
        if (last == 0)
        {
            context.Diagnostics.Add(Severity.Warning, "gcode.no_layers", "The file has no layers. Its start and end G-code were not replaced.");
            return;
        }
        if (options.Start is not null)
        {
            FirstKept = first;
            _start = options.Start;
            plan.Touch(1, first);
        }
        if (options.End is null) return;
        LastKept = last;
        _end = options.End;
        plan.Touch(last, int.MaxValue);
    }

    /// <summary>The first and the last line of the file to keep.</summary>
    public int FirstKept { get; }

    public int LastKept { get; } = int.MaxValue;

    /// <summary>True if lines are replaced.</summary>
    public bool Changes => FirstKept > 0 || LastKept < int.MaxValue;

    public bool Keeps(int line) => line >= FirstKept && line <= LastKept;

    /// <summary>Writes the start G-code, then the state that the first kept line expects.</summary>
    public void WriteStart()
    {
        foreach (var line in _start) _context.Command(line);
        var expected = _context.Read.State;
        var written = _context.Written.State;
        if (expected.Modes.Inches != written.Modes.Inches) _context.Command(expected.Modes.Inches ? "G20" : "G21");
        if (expected.Tool != written.Tool) _context.Event(new ToolEvent(expected.Tool));
        if (expected.Modes.Plane != written.Modes.Plane) _context.Command("G" + NumberFormatter.Format(17 + (int)expected.Modes.Plane));
        if (written.Modes.Relative) _context.Command("G90");
        var unit = expected.Modes.Unit;
        var shift = written.Head.Shift;
        if (expected.Head.HasMoved && expected.Head.Machine != written.Head.Machine)
            _context.Command("G0 " + SpliceContext.Format(expected.Head.Machine - shift, unit));
        if (expected.Head.Shift != shift) _context.Command("G92 " + SpliceContext.Format(expected.Head.Written, unit));
        _context.Command(expected.Modes.Relative ? "G91" : "G90");
        if (_context.Extruder != 0) WriteModeOfE(expected);
        if (expected.Feed.Rate > 0 && expected.Feed.Rate != written.Feed.Rate)
            _context.Command("G1", 'F', expected.Feed.Rate / unit, _context.Style.DecimalsF);
    }

    /// <summary>Writes the end G-code.</summary>
    public void WriteEnd()
    {
        foreach (var line in _end) _context.Command(line);
    }

    private void WriteModeOfE(InterpreterState expected)
    {
        var rule = _context.Rules.RelativeE;
        if (rule != RelativeERule.OnlyG90G91)
            _context.Command(expected.Modes.M83 || (rule == RelativeERule.LastWins && expected.Modes.LastRelative) ? "M83" : "M82");
        if (!_context.Written.State.Modes.RelativeE)
            _context.Command("G92 " + (char)_context.Extruder + SpliceContext.Format(expected.Extrusion.E, _context.UnitOfE));
    }

    /// <summary>The first line of the first layer and the line of the last extrusion of the print; 0 = none.</summary>
    public static (int First, int Last) PrintedLines(DecodedGCode decoding)
    {
        var (first, last) = (decoding.FirstLayerLine, 0);
        foreach (var block in decoding.Toolpath.Blocks)
        {
            var c = block.Columns;
            for (var i = 0; i < c.Count; i++)
            {
                if (c.Kind[i] != MoveKind.Print || c.Layer[i] < 0) continue;
                if (first == 0) first = c.Source[i];
                last = c.Source[i];
            }
        }
        return (first, last);
    }
}

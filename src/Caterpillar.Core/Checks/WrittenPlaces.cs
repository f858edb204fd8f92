using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>Places in a file that was written from a plan: its line, the move of the plan, and where the design states it.</summary>
internal sealed class WrittenPlaces(Toolpath plan, Toolpath read, WrittenLines lines, Printer printer)
{
    /// <summary>The place of a move of the plan by its line.</summary>
    public static SourceLocation OfMove(Toolpath plan, int move, int line)
        => new(Line: line, Step: plan[move].Source is >= 0 and var step ? step : null, Move: move, Origin: plan.PlaceOf(move));

    /// <summary>The place of a move that was read from the file.</summary>
    public SourceLocation? Of(int move) => move < 0 || move >= read.Count ? null : OfLine(read[move].Source);

    /// <summary>The place of an event that was read from the file.</summary>
    public SourceLocation? Of(MoveEvent what) => what.Source < 1 ? null : OfLine(what.Source);

    /// <summary>The place of an event of the plan.</summary>
    public SourceLocation OfEvent(int index)
    {
        var source = plan.Events[index].Source;
        var line = lines.LineOf(index);
        return new SourceLocation(Line: line > 0 ? line : null, Step: source >= 0 ? source : null, Origin: plan.PlaceOfStep(source));
    }

    private SourceLocation OfLine(int line)
    {
        if (lines.MoveAt(line) is >= 0 and var move) return OfMove(plan, move, line);
        if (lines.EventAt(line) is >= 0 and var index) return OfEvent(index) with { Line = line };
        var key = lines.IsStart(line) ? "start_template" : lines.IsEnd(line) ? "end_template" : "layer_template";
        return new SourceLocation(Line: line, Origin: new SourceLocation(printer.Name, Key: key));
    }
}

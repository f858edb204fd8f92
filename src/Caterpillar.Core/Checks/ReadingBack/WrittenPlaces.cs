namespace Caterpillar.Checks;

/// <summary>Places in a file that was written from a plan: its line, the move of the plan, and where the design states it.</summary>
/// <param name="plan">The plan.</param>
/// <param name="lineOf">The line of a move that was read; null if the move does not exist.</param>
/// <param name="lines">The lines of the plan.</param>
/// <param name="printer">Whose templates they are.</param>
internal sealed class WrittenPlaces(Toolpath plan, Func<int, int?> lineOf, WrittenLines lines, Printer printer)
{
    /// <summary>The place of a move of the plan by its line.</summary>
    public static SourceLocation OfMove(Toolpath plan, WrittenLines lines, int move, int line)
        => new(Line: lines.InFile(line), Step: plan[move].Source is >= 0 and var step ? step : null, Move: move, Origin: plan.PlaceOf(move));

    /// <summary>The place of a move that was read from the file.</summary>
    public SourceLocation? Of(int move) => lineOf(move) is { } line ? OfLine(line) : null;

    /// <summary>The place of an event that was read from the file.</summary>
    public SourceLocation? Of(MoveEvent what) => what.Source < 1 ? null : OfLine(what.Source);

    /// <summary>The place of an event of the plan.</summary>
    public SourceLocation OfEvent(int index)
    {
        var source = plan.Events[index].Source;
        var line = lines.LineOf(index);
        return new SourceLocation(Line: line > 0 ? lines.InFile(line) : null, Step: source >= 0 ? source : null, Origin: plan.PlaceOfStep(source));
    }

    /// <summary>The place of a line.</summary>
    public SourceLocation OfLine(int line)
    {
        if (lines.MoveAt(line) is >= 0 and var move) return OfMove(plan, lines, move, line);
        if (lines.EventAt(line) is >= 0 and var index) return OfEvent(index) with { Line = lines.InFile(line) };
        var key = lines.IsStart(line) ? "start_gcode" : lines.IsEnd(line) ? "end_gcode" : "layer_change_gcode";
        return new SourceLocation(Line: lines.InFile(line), Origin: new SourceLocation(printer.Name, Key: key));
    }
}

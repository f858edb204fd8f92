namespace Caterpillar.Checks;

/// <summary>Finds numbers that cannot be written: not finite, or beyond 10⁷.</summary>
internal static class PrintableNumbers
{
    // mm, mm of filament, mm/s, °C and whatever else.
    private const double Largest = 1e7;

    /// <summary>The error <see cref="SafeWriter.InvalidNumber"/> about the first number that is not below a limit; null = none.</summary>
    public static Diagnostic? Check(Toolpath toolpath, double largest = Largest)
    {
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var c = toolpath.Blocks[block].Columns;
            for (var i = 0; i < c.Count; i++)
            {
                if (Word(c, i, largest) is { } word) return Error($"{word.Name} of a move", word.Value, toolpath, toolpath.FirstOf(block) + i);
            }
            for (var i = 0; i < c.Arcs.Length; i++)
            {
                var center = c.Arcs[i].Center;
                if (Outside(center.X, center.Y, center.Z, largest) is { } value)
                    return Error("The center of an arc", value, toolpath, toolpath.FirstOf(block) + c.ArcMoves[i]);
            }
        }
        foreach (var entry in toolpath.Events)
        {
            if (!(Math.Abs(Value(entry.Event)) < largest)) return Error("A value of a command between moves", Value(entry.Event), toolpath, entry.Move);
        }
        return null;
    }

    private static (string Name, double Value)? Word(ToolpathColumns c, int i, double largest)
    {
        if (Outside(c.X[i], c.Y[i], c.Z[i], largest) is { } place) return ("The end point", place);
        if (!(Math.Abs(c.E[i]) < largest)) return ("E", c.E[i]);
        if (!(Math.Abs(c.Speed[i]) < largest)) return ("The speed", c.Speed[i]);
        return c.Turns?[i] is var (u, v, w) && Outside(u, v, w, largest) is { } turn ? ("A rotary axis", turn) : null;
    }

    private static double? Outside(double a, double b, double c, double largest)
        => !(Math.Abs(a) < largest) ? a : !(Math.Abs(b) < largest) ? b : !(Math.Abs(c) < largest) ? c : null;

    private static double Value(PrinterEvent what) => what switch
    {
        NozzleTemperatureEvent nozzle => nozzle.Celsius,
        BedTemperatureEvent bed => bed.Celsius,
        ChamberTemperatureEvent chamber => chamber.Celsius,
        PressureAdvanceEvent advance => advance.Seconds,
        FanEvent fan => fan.Speed,
        AccelerationEvent acceleration => acceleration.Value,
        LimitEvent limit => limit.Value,
        DwellEvent dwell => dwell.Seconds,
        _ => 0,
    };

    private static Diagnostic Error(string what, double value, Toolpath toolpath, int move)
    {
        var number = double.IsNaN(value) || double.IsInfinity(value) ? "not finite" : LongWords.Shorten(NumberFormatter.Format(value, 3)) + ", beyond 10⁷";
        var place = Findings.PlaceIn(toolpath, move) ?? new SourceLocation(Move: move);
        return new Diagnostic(Severity.Error, SafeWriter.InvalidNumber, $"{what} cannot be written: it is {number}.", place);
    }
}

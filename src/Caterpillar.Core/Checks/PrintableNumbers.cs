using System;
using Caterpillar.Basics;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>Finds numbers of a toolpath that no file can state: what is not finite, or beyond 10⁷.</summary>
internal static class PrintableNumbers
{
    // mm, mm of filament, mm/s, °C and whatever else.
    private const double Largest = 1e7;
    private const double LargestFinite = 1e100;

    /// <summary>The error <see cref="SafeWriter.Unprintable"/> about the first such number; null where there is none.</summary>
    public static Diagnostic? Check(Toolpath toolpath) => Check(toolpath, Largest);

    /// <summary>True where all numbers are finite, with many orders of magnitude to spare.</summary>
    public static bool AreFinite(Toolpath toolpath) => Check(toolpath, LargestFinite) is null;

    private static Diagnostic? Check(Toolpath toolpath, double largest)
    {
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var c = toolpath.Blocks[block].Columns;
            for (var i = 0; i < c.Count; i++)
            {
                if (Word(c, i, largest) is { } word) return Error($"{word} of a move", toolpath.FirstOf(block) + i);
            }
            for (var i = 0; i < c.Arcs.Length; i++)
            {
                var center = c.Arcs[i].Center;
                if (!(Math.Abs(center.X) < largest && Math.Abs(center.Y) < largest && Math.Abs(center.Z) < largest))
                    return Error("The center of an arc", toolpath.FirstOf(block) + c.ArcMoves[i]);
            }
        }
        foreach (var entry in toolpath.Events)
        {
            if (!(Math.Abs(Value(entry.Event)) < largest)) return Error($"The value of a {entry.Event.GetType().Name}", entry.Move);
        }
        return null;
    }

    private static string? Word(ToolpathColumns c, int i, double largest)
        => !(Math.Abs(c.X[i]) < largest && Math.Abs(c.Y[i]) < largest && Math.Abs(c.Z[i]) < largest) ? "The end"
            : !(Math.Abs(c.E[i]) < largest) ? "E" : !(Math.Abs(c.Speed[i]) < largest) ? "The speed"
            : c.A is not null && !(Math.Abs(c.A[i]) < largest && Math.Abs(c.B![i]) < largest && Math.Abs(c.C![i]) < largest) ? "A rotary axis" : null;

    private static double Value(PrinterEvent what) => what switch
    {
        NozzleTemperatureEvent nozzle => nozzle.Celsius,
        BedTemperatureEvent bed => bed.Celsius,
        FanEvent fan => fan.Speed,
        AccelerationEvent acceleration => acceleration.Value,
        LimitEvent limit => limit.Value,
        DwellEvent dwell => dwell.Seconds,
        _ => 0,
    };

    private static Diagnostic Error(string what, int move)
        => new(Severity.Error, SafeWriter.Unprintable, what + " cannot be written: it is not finite, or beyond 10⁷.", new SourceLocation(Move: move));
}

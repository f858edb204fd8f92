using System;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>Finds numbers of a toolpath that no file can state: what is not finite, or beyond 10⁷.</summary>
internal static class PrintableNumbers
{
    // mm, mm of filament, mm/s, °C and whatever else.
    private const double Largest = 1e7;

    /// <summary>The error <see cref="SafeWriter.Unprintable"/> about the first such number; null where there is none.</summary>
    public static Diagnostic? Check(Toolpath toolpath)
    {
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var c = toolpath.Blocks[block].Columns;
            for (var i = 0; i < c.Count; i++)
            {
                if (Word(c, i) is { } word) return Error($"{word} of a move", toolpath.FirstOf(block) + i);
            }
            for (var i = 0; i < c.Arcs.Length; i++)
            {
                if (!IsPoint(c.Arcs[i].Center)) return Error("The center of an arc", toolpath.FirstOf(block) + c.ArcMoves[i]);
            }
        }
        foreach (var entry in toolpath.Events)
        {
            if (!IsNumber(Value(entry.Event))) return Error($"The value of a {entry.Event.GetType().Name}", entry.Move);
        }
        return null;
    }

    private static string? Word(ToolpathColumns c, int i)
        => !IsNumber(c.X[i]) || !IsNumber(c.Y[i]) || !IsNumber(c.Z[i]) ? "The end" : !IsNumber(c.E[i]) ? "E" : !IsNumber(c.Speed[i]) ? "The speed"
            : c.A is not null && !(IsNumber(c.A[i]) && IsNumber(c.B![i]) && IsNumber(c.C![i])) ? "A rotary axis" : null;

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

    private static bool IsPoint(Vec3 p) => IsNumber(p.X) && IsNumber(p.Y) && IsNumber(p.Z);

    private static bool IsNumber(double value) => Math.Abs(value) < Largest;

    private static Diagnostic Error(string what, int move)
        => new(Severity.Error, SafeWriter.Unprintable, what + " cannot be written: it is not finite, or beyond 10⁷.", new SourceLocation(Move: move));
}

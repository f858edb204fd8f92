namespace Caterpillar.Checks;

/// <summary>Moves outside the space that the nozzle can reach or below the bed, and extrusions on excluded areas.</summary>
internal sealed class PositionCheck(Printer printer, Findings findings) : MoveCheck
{
    // mm; what is written has three decimals.
    private const double Tolerance = 0.001;
    private const double ArcTolerance = 0.05;
    private readonly bool _isMapped = printer.AxisMappings.Count > 0;
    private readonly Kinematics? _kinematics = printer.Kinematics;

    public override IReadOnlyList<string> Codes => [CheckCodes.Outside, CheckCodes.Below, CheckCodes.ExcludedArea, CheckCodes.AxisRange];

    public override void Move(in CheckedMove move)
    {
        var (start, end) = (move.Start, _isMapped ? AxisMapping.Head(move.End, printer.AxisMappings) : move.End);
        var reachable = printer.CanReach(end, Tolerance);
        if (reachable && move.Arc is { } arc)
            reachable = printer.BedShape == BedShape.Round ? ReachesAlong(arc, start, end) : printer.BuildBounds.Contains(arc.Bounds(start, end), Tolerance);
        if (!reachable) Report(move.Index, end);
        if (_kinematics is not null) Axes(move);
        if (move.Kind != MoveKind.Print) return;
        foreach (var area in printer.ExcludedAreas)
        {
            if (!Crosses(move, area)) continue;
            Report(move.Index, end, area);
            return;
        }
    }

    // A chord stays in between for the rotary axes, and nearly so for the slides.
    private void Axes(in CheckedMove move)
    {
        var (index, end, turns) = (move.Index, move.End, move.EndTurns);
        foreach (var axis in _kinematics!.Axes)
        {
            var word = axis.Of(turns);
            if (word >= axis.Min - Tolerance && word <= axis.Max + Tolerance) continue;
            findings.Add(CheckCodes.AxisRange, index, () => $"A move turns {axis.Word} to {NumberFormatter.Format(word, 2)} degrees, but "
                + $"{printer.Title} turns it only from {NumberFormatter.Format(axis.Min, 2)} to {NumberFormatter.Format(axis.Max, 2)}. "
                + "Limit the tilt, or turn the part on the bed.");
        }
        if (printer.SlideRange.Count == 0) return;
        var slides = _kinematics.Machine(end, turns);
        if (!printer.SlideRange[0].Contains(slides, ArcTolerance))
            findings.Add(CheckCodes.AxisRange, index, () => $"For a move to {end} the slides of {printer.Title} go to {slides}, beyond "
                + $"{printer.SlideRange[0]}. Move the print, or limit the tilt.");
    }

    private void Report(int move, Vec3 end)
    {
        if (end.Z < 0 && printer.CanReach(end.WithZ(0), Tolerance))
            findings.Add(CheckCodes.Below, move, () => $"A move goes to Z {NumberFormatter.Format(end.Z, 3)} mm, below the bed. Raise it.");
        else
            findings.Add(CheckCodes.Outside, move, () => $"A move goes to {end}, outside the build volume of {printer.Title}: "
                + $"{printer.BuildBounds}{(printer.BedShape == BedShape.Round ? ", round" : "")}. Move or scale the print.");
    }

    private void Report(int move, Vec3 end, Bounds area)
        => findings.Add(CheckCodes.ExcludedArea, move, () => $"An extrusion to {end} crosses an excluded area of {printer.Title}: {area}. Move the print.");

    private bool ReachesAlong(Arc arc, Vec3 start, Vec3 end)
    {
        var chords = arc.ChordCount(start, ArcTolerance);
        for (var k = 1; k < chords; k++)
        {
            if (!printer.CanReach(arc.PointAt(start, end, (double)k / chords), ArcTolerance)) return false;
        }
        return true;
    }

    private static bool Crosses(in CheckedMove move, Bounds area)
    {
        if (move.Arc is not { } arc) return Crosses(move.Start, move.End, area);
        var chords = arc.ChordCount(move.Start, ArcTolerance);
        var at = move.Start;
        for (var k = 1; k <= chords; k++)
        {
            var next = arc.PointAt(move.Start, move.End, (double)k / chords);
            if (Crosses(at, next, area)) return true;
            at = next;
        }
        return false;
    }

    // The edges of an area do not belong to it.
    private static bool Crosses(Vec3 a, Vec3 b, Bounds area)
    {
        double low = 0, high = 1;
        return Inside(a.X, b.X, area.Min.X, area.Max.X, ref low, ref high) && Inside(a.Y, b.Y, area.Min.Y, area.Max.Y, ref low, ref high);
    }

    private static bool Inside(double a, double b, double min, double max, ref double low, ref double high)
    {
        min += Tolerance;
        max -= Tolerance;
        var d = b - a;
        // Where it does not move the parts are infinite, or no number on an edge.
        low = Math.Max(low, Math.Min((min - a) / d, (max - a) / d));
        high = Math.Min(high, Math.Max((min - a) / d, (max - a) / d));
        return low < high;
    }
}

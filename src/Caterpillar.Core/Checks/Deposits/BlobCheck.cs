namespace Caterpillar.Checks;

/// <summary>
/// Material extruded in place: a blob spreads around the nozzle into the gap above the bed, the object and the print, and is too much if it grows too wide.
/// </summary>
internal sealed class BlobCheck(PrintSetup setup, PrintedSoFar printed, Findings findings)
{
    // Widths in nozzles.
    private const double Widest = 10;
    private const double Refused = 20;
    private const int Rings = 20;
    private const int Directions = 8;

    // mm.
    private const double Flat = 0.002;

    // What is soft yields by this part of a layer.
    private const double Yields = 0.25;
    private readonly double _nozzle = setup.Printer.NozzleDiameter;
    private readonly double _height = setup.Settings.LargerLayerHeight;

    /// <param name="move">The move.</param>
    /// <param name="isFirst">True if nothing is printed yet.</param>
    public void Look(in CheckedMove move, bool isFirst)
    {
        // A machine may prime in place before it prints.
        if (isFirst && move.Role == Role.Purge) return;
        var gap = GapAt(move.End);
        var width = Width(move.End, move.Deposited, gap);
        if (width > Refused * _nozzle) ReportBlob(move.Index, move.Deposited, gap, width);
        // Higher up it hangs from the nozzle.
        else if (gap <= _nozzle && gap > 0 && !isFirst && width > Widest * _nozzle) ReportSqueezed(move.Index, move.Deposited, gap, width);
    }

    // Ring by ring, until it has room; what is left spreads as in the last ring.
    private double Width(Vec3 p, double volume, double gap)
    {
        var (step, inner, room) = (Refused * _nozzle / 2 / Rings, 0.0, Math.Max(gap, Flat));
        for (var ring = 1; ring <= Rings; ring++)
        {
            if (ring > 1) room = RoomAround(p, inner + step / 2);
            var outer = inner + step;
            var fits = Math.PI * (outer * outer - inner * inner) * room;
            if (fits >= volume) break;
            volume -= fits;
            inner = outer;
        }
        return 2 * Math.Sqrt(inner * inner + volume / (Math.PI * room));
    }

    private double RoomAround(Vec3 p, double radius)
    {
        var sum = 0.0;
        for (var k = 0; k < Directions; k++)
        {
            var (sin, cos) = Angle.SinCos(360.0 / Directions * k);
            sum += Math.Max(GapAt(p + new Vec3(cos, sin) * radius), Flat);
        }
        return sum / Directions;
    }

    private double GapAt(Vec3 p)
    {
        var top = printed.Deposit.TopUnder(p, double.PositiveInfinity);
        var floor = p.Z - printed.FloorUnder(p);
        return Math.Min(floor, Math.Max(p.Z - top, Yields * Math.Min(_height, p.Z)));
    }

    private void ReportBlob(int move, double volume, double gap, double width)
        => findings.Add(CheckCodes.Blob, move, () => $"{Number(volume)} mm³ extruded in place with the nozzle {Number(gap)} mm above the bed "
            + $"or the print make a blob {Number(width)} mm wide. Extrude less, or raise the nozzle first.", width);

    private void ReportSqueezed(int move, double volume, double gap, double width)
        => findings.Add(CheckCodes.Squeezed, move, () => $"{Number(volume)} mm³ extruded in place do not fit into the {Number(gap)} mm under the nozzle: "
            + $"the blob would be {Number(width)} mm wide. Extrude less.", width);

    private static string Number(double value) => NumberFormatter.Format(value, 2);
}

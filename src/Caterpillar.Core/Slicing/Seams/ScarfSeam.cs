namespace Caterpillar.Slicing;

/// <summary>
/// A loop whose start climbs from the layer below to its height with growing flow, and whose end runs out over that ramp. Both together are as thick as
/// the rest of the wall.
/// </summary>
internal static class ScarfSeam
{
    // The share of the layer's thickness at which the ramp begins: the nozzle can't print without a gap.
    private const double First = 0.1;

    // mm, far below what a file can hold.
    private const double Rounding = 1e-9;

    /// <summary>An open path along the loop, longer by the scarf, or the loop itself if it is too short.</summary>
    public static PrintPath Apply(PrintPath loop, double thickness, PrintSettings settings)
    {
        var scarf = settings.ScarfSeamLength;
        if (!loop.IsClosed || scarf <= 0 || loop.Length < 2 * scarf) return loop;
        var z = loop.Start.Z;
        var points = new List<Vec3>();
        var beads = new List<Bead>();
        var ramp = new List<(Vec3 To, double At, Bead Bead)>();
        var at = 0.0;
        points.Add(loop.Start.WithZ(z - thickness * (1 - First)));
        for (var i = 0; i < loop.SegmentCount; i++)
        {
            Vec3 from = loop.RawPoints[i], to = loop.EndOf(i);
            var length = from.DistanceTo(to);
            var done = 0.0;
            while (at + done < scarf - Rounding && done < length)
            {
                var step = NextStep(at + done, scarf, settings.ScarfSeamSteps);
                var end = step >= at + length ? length : step - at;
                var mean = Share((2 * at + done + end) / 2, scarf);
                var point = Vec3.Lerp(from, to, end / length);
                var bead = loop.BeadOf(i);
                points.Add(point.WithZ(z - thickness * (1 - Share(at + end, scarf))));
                beads.Add(Scaled(bead, mean));
                ramp.Add((point, 1 - mean, bead));
                done = end;
            }
            if (length - done > Rounding)
            {
                points.Add(to);
                beads.Add(loop.BeadOf(i));
            }
            at += length;
        }
        foreach (var (to, share, bead) in ramp)
        {
            points.Add(to);
            beads.Add(Scaled(bead, share));
        }
        return loop.WithGeometry(points, beads, closed: false);
    }

    private static double Share(double at, double scarf) => First + (1 - First) * Math.Min(1, at / scarf);

    // The end of the step of the ramp that a length lies in.
    private static double NextStep(double at, double scarf, int steps) => Math.Min((Math.Floor(at / scarf * steps + Rounding) + 1) * scarf / steps, scarf);

    private static Bead Scaled(Bead bead, double share) => new(bead.Area * share, bead.Height * share, bead.Speed);
}

namespace Caterpillar.Curved;

/// <summary>Maximum slope of layers that a print head can print without touching the part uphill.</summary>
internal static class HeadSlope
{
    /// <summary>The limit of the settings, or else of the head, degrees.</summary>
    /// <param name="setup">The settings, and the printer.</param>
    /// <param name="span">As in <see cref="OfHead"/>.</param>
    /// <param name="rise">As in <see cref="OfHead"/>.</param>
    public static double Limit(PrintSetup setup, double span, double rise)
        => setup.Settings.CurvedMaxSlope > 0 ? setup.Settings.CurvedMaxSlope : OfHead(setup.Printer, span, rise);

    /// <summary>The limit of a head, degrees.</summary>
    /// <param name="printer">The outline and boxes of its head.</param>
    /// <param name="span">Length of the part in plan, mm: farther out nothing is touched.</param>
    /// <param name="rise">Height between the lowest and the highest point of a layer, mm: parts of the head higher up touch nothing.</param>
    public static double OfHead(Printer printer, double span, double rise)
    {
        var tip = printer.HeadOutline[0].Radius;
        var limit = 90.0;
        for (var i = 1; i < printer.HeadOutline.Count; i++)
        {
            // The outline rises straight from the point before: its inner end is the lowest.
            var (inner, outer) = (printer.HeadOutline[i - 1], printer.HeadOutline[i]);
            if (inner.Radius < span && inner.Height < rise) limit = Math.Min(limit, Reach(outer.Radius, outer.Height, inner));
        }
        foreach (var box in printer.HeadBoxes)
        {
            var near = new Vec3(Math.Max(0, Math.Max(box.Min.X, -box.Max.X)), Math.Max(0, Math.Max(box.Min.Y, -box.Max.Y))).LengthXY;
            if (near < span && box.Min.Z < rise) limit = Math.Min(limit, Angle.Atan2(Math.Min(box.Min.Z, rise), Math.Min(box.ReachXY, span)));
        }
        return limit;

        // A slope meets the edge at its outer end, or where the part, or the rise of its layers, ends.
        double Reach(double radius, double height, HeadPoint inner)
        {
            var share = 1.0;
            if (radius > span) share = Math.Min(share, (span - inner.Radius) / (radius - inner.Radius));
            if (height > rise) share = Math.Min(share, (rise - inner.Height) / (height - inner.Height));
            var (r, h) = (inner.Radius + (radius - inner.Radius) * share, inner.Height + (height - inner.Height) * share);
            // Up to 45 degrees it does not matter if only the flat of the tip presses into what it prints on.
            return Math.Min(Angle.Atan2(h, r - tip), Math.Max(45, Angle.Atan2(h, r)));
        }
    }

    /// <summary>The largest angle from its axis, in degrees, that a head may have to clear everything higher in each layer.</summary>
    /// <param name="slope">The steepest slope, degrees. Up to 45 degrees it alone decides.</param>
    /// <param name="layers">The paths of each layer; some of their points are looked at.</param>
    /// <param name="tip">Radius of the tip and half the width of an extrusion, mm. Points within three times this distance touch only the tip.</param>
    public static double HalfAngle(double slope, IEnumerable<IEnumerable<PathStep>> layers, double tip)
    {
        const int Most = 200;
        var least = 90 - slope;
        foreach (var layer in slope > 45 ? layers : [])
        {
            var points = layer.SelectMany(s => s.Path.RawPoints).ToArray();
            var step = points.Length / Most + 1;
            for (var i = 0; i < points.Length; i += step)
            {
                for (var k = 0; k < points.Length; k += step)
                {
                    var away = (points[k] - points[i]).LengthXY;
                    if (away > 3 * tip) least = Math.Min(least, Angle.Atan2(away - tip, Math.Max(0, points[k].Z - points[i].Z)));
                }
            }
        }
        return least;
    }
}

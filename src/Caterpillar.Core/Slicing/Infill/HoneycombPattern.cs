namespace Caterpillar.Slicing;

/// <summary>
/// Hexagons of lines that never cross: each line follows the upper and lower sides of a row of hexagons in turn, and where two lines would share a side they
/// run next to each other, one extrusion apart.
/// </summary>
internal static class HoneycombPattern
{
    private static readonly double Sqrt3 = Math.Sqrt(3);

    /// <summary>Null where the hexagons would be smaller than their extrusions are wide.</summary>
    public static List<Polyline>? Rows(InfillRequest request)
    {
        // A line goes two sides, one straight and one sloped, on a side and a half, so lines are 4/3 spacings apart: their height and the distance of the
        // pairs.
        var pitch = request.Spacing * 4 / 3;
        var height = pitch - request.Width;
        var side = 2 * height / Sqrt3;
        if (side < 2 * request.Width) return null;
        var frame = new PatternFrame(request.Area, request.Angle);
        var period = 3 * side;
        var rows = new List<Polyline>();
        long first = (long)Math.Floor(frame.MinU / period) - 1, last = (long)Math.Ceiling(frame.MaxU / period) + 1;
        for (var row = (long)Math.Floor(frame.MinV / pitch) - 1; row * pitch <= frame.MaxV + pitch; row++)
        {
            // Neighbors mirror each other: where one is high the next is low.
            var up = (row & 1) == 0 ? 1 : -1;
            double high = row * pitch + up * height / 2, low = row * pitch - up * height / 2;
            var points = new Vec3[4 * (last - first)];
            var n = 0;
            for (var k = first; k < last; k++)
            {
                var u = k * period;
                points[n++] = frame.At(u, high);
                points[n++] = frame.At(u + side, high);
                points[n++] = frame.At(u + 1.5 * side, low);
                points[n++] = frame.At(u + 2.5 * side, low);
            }
            rows.Add(Polyline.Own(points, closed: false));
        }
        return rows;
    }
}

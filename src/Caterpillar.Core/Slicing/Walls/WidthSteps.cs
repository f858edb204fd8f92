namespace Caterpillar.Slicing;

/// <summary>A segment of a path has one bead; where the width changes much from its one end to the other it becomes several.</summary>
internal static class WidthSteps
{
    /// <summary>The path with so many more points that the width changes by at most <paramref name="most"/> mm within a segment.</summary>
    public static (Vec3[] Points, double[] Widths) Split(Vec3[] points, double[] widths, bool closed, double most, double shortest)
    {
        var newPoints = new List<Vec3>(points.Length);
        var newWidths = new List<double>(points.Length);
        for (var i = 0; i < points.Length; i++)
        {
            newPoints.Add(points[i]);
            newWidths.Add(widths[i]);
            if (i + 1 == points.Length && !closed) break;
            var next = i + 1 == points.Length ? 0 : i + 1;
            var wanted = Math.Ceiling(Math.Abs(widths[next] - widths[i]) / most - 1e-9);
            var pieces = (int)Math.Min(wanted, Math.Floor((points[next] - points[i]).LengthXY / shortest));
            for (var k = 1; k < pieces; k++)
            {
                var t = (double)k / pieces;
                newPoints.Add(Vec3.Lerp(points[i], points[next], t));
                newWidths.Add(widths[i] + (widths[next] - widths[i]) * t);
            }
        }
        return newPoints.Count == points.Length ? (points, widths) : (newPoints.ToArray(), newWidths.ToArray());
    }
}

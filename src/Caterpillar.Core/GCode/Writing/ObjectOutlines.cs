namespace Caterpillar.GCode;

/// <summary>
/// Outlines of objects on the bed: convex polygons with at most sixteen corners, each the outermost point of the extrusions in one direction. The sides of the
/// bounding box are touched, and round outlines lose at most 2 % of their radius.
/// </summary>
internal static class ObjectOutlines
{
    // The other eight directions are opposite.
    private const int Axes = 8;
    private static readonly (double X, double Y)[] Directions
        = [.. Enumerable.Range(0, Axes).Select(k => Angle.SinCos(k * 180.0 / Axes)).Select(d => (d.Cos, d.Sin))];

    /// <summary>The named objects in the order of their first move, with the corners counterclockwise in mm; none for objects that print nothing.</summary>
    public static IReadOnlyList<(string Name, IReadOnlyList<Vec3> Outline)> Of(Toolpath toolpath)
    {
        var names = new List<string>();
        var extremes = new List<Extremes>();
        var (last, open) = (-1, (Extremes?)null);
        for (var b = 0; b < toolpath.Blocks.Count; b++)
        {
            var c = toolpath.Blocks[b].Columns;
            var start = toolpath.StartOf(b);
            for (var i = 0; i < c.Count; i++)
            {
                if (c.Layer[i] != last)
                {
                    last = c.Layer[i];
                    open = last < 0 || toolpath.Layers[last].Object is not { Length: > 0 } name ? null : Find(name);
                }
                var end = new Vec3(c.X[i], c.Y[i], c.Z[i]);
                if (open is not null && c.Kind[i] == MoveKind.Print)
                {
                    open.Include(start);
                    open.Include(end);
                    if (c.TryGetArc(i, out var arc))
                    {
                        var count = arc.ChordCount(start, end, 0.05);
                        for (var k = 1; k < count; k++) open.Include(arc.PointAt(start, end, (double)k / count));
                    }
                }
                start = end;
            }
        }
        return [.. names.Select((name, i) => (name, extremes[i].Outline()))];

        Extremes Find(string name)
        {
            var known = names.IndexOf(name);
            if (known >= 0) return extremes[known];
            names.Add(name);
            extremes.Add(new Extremes());
            return extremes[extremes.Count - 1];
        }
    }

    private sealed class Extremes
    {
        private readonly double[] _farthest = Enumerable.Repeat(double.NegativeInfinity, 2 * Axes).ToArray();
        private readonly Vec3[] _points = new Vec3[2 * Axes];

        public void Include(Vec3 point)
        {
            for (var k = 0; k < Axes; k++)
            {
                var along = point.X * Directions[k].X + point.Y * Directions[k].Y;
                if (along > _farthest[k]) (_farthest[k], _points[k]) = (along, point);
                if (-along > _farthest[k + Axes]) (_farthest[k + Axes], _points[k + Axes]) = (-along, point);
            }
        }

        public IReadOnlyList<Vec3> Outline()
        {
            if (double.IsInfinity(_farthest[0])) return [];
            var corners = new List<Vec3>();
            foreach (var point in _points)
            {
                var corner = point.WithZ(0);
                if (!corners.Contains(corner)) corners.Add(corner);
            }
            return corners;
        }
    }
}

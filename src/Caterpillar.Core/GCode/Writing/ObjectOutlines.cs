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
        if (toolpath.Layers.All(l => l.Object.Length == 0)) return [];
        var names = new List<string>();
        var outlines = new Dictionary<string, Extremes>(StringComparer.Ordinal);
        foreach (var move in toolpath.Moves())
        {
            if (move.Layer < 0 || toolpath.Layers[move.Layer].Object is not { Length: > 0 } name) continue;
            if (!outlines.TryGetValue(name, out var outline))
            {
                names.Add(name);
                outlines.Add(name, outline = new Extremes());
            }
            if (move.Kind != MoveKind.Print) continue;
            outline.Include(move.Start);
            outline.Include(move.End);
            if (move.Arc is not { } arc) continue;
            var chords = arc.ChordCount(move.Start, move.End, 0.05);
            for (var k = 1; k < chords; k++) outline.Include(arc.PointAt(move.Start, move.End, (double)k / chords));
        }
        return [.. names.Select(name => (name, outlines[name].Outline()))];
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

        public IReadOnlyList<Vec3> Outline() => double.IsInfinity(_farthest[0]) ? [] : _points.Select(p => p.WithZ(0)).Distinct().ToList();
    }
}

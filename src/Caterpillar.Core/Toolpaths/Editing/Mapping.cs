namespace Caterpillar.Toolpaths;

/// <summary>
/// Moves, rotates and scales paths and toolpaths. Arcs stay arcs if circles stay circles in the XY plane, otherwise they become chords. Scaling a toolpath
/// also scales the heights, widths and E of its extrusions. Scaling a path keeps its cross-sections, because the design sets them.
/// </summary>
public static class Mapping
{
    /// <summary>The transformed path.</summary>
    /// <param name="path">The path.</param>
    /// <param name="map">The transformation. Its translation is in mm.</param>
    /// <param name="tolerance">Maximum deviation of chords from an arc before the transformation, mm.</param>
    public static PrintPath Transformed(this PrintPath path, Affine map, double tolerance = 0.01)
    {
        if (path is null) throw new ArgumentNullException(nameof(path));
        var straight = KeepsCircles(map) ? path : PathArcs.Expand(path, tolerance);
        var segments = Enumerable.Range(0, straight.SegmentCount).ToArray();
        var mapped = straight.WithGeometry(straight.Points.Select(map.Apply), segments.Select(straight.BeadOf), path.IsClosed,
            segments.Select(i => straight.ArcOf(i) is { } arc ? Image(arc, map) : (Arc?)null));
        return path.Layer is { } layer ? (mapped with { Layer = Image(layer, map) }) : mapped;
    }

    /// <summary>The transformed toolpath. Extrusions are scaled with their cross-sections. Retractions, primes and speeds do not change.</summary>
    /// <inheritdoc cref="Transformed(PrintPath, Affine, double)" path="/param"/>
    public static Toolpath Transform(this Toolpath toolpath, Affine map, double tolerance = 0.01)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        var start = toolpath.Start is { } from ? map.Apply(from) : (Vec3?)null;
        var mapped = new ToolpathMapper(toolpath, MappedMoves.All(toolpath), new AffineRunMap(map, tolerance), tolerance).Run(start ?? map.Apply(Vec3.Zero));
        return mapped.With(start, toolpath.Layers.Select(l => Image(l, map)));
    }

    /// <summary>
    /// Transforms only the selected extrusions and the selected moves between them. Travel moves lead to the new starts of extrusions. Layers that are selected
    /// as a whole (by number and object) get their new heights.
    /// </summary>
    /// <inheritdoc cref="Transform(Toolpath, Affine, double)" path="/param"/>
    public static Toolpath Transform(this Toolpath toolpath, MoveFilter filter, Affine map, double tolerance = 0.01, CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (filter is null) throw new ArgumentNullException(nameof(filter));
        var mapped = new ToolpathMapper(toolpath, MappedMoves.Of(toolpath, filter), new AffineRunMap(map, tolerance), tolerance)
            .Run(toolpath.Start ?? Vec3.Zero, cancel);
        return mapped.With(toolpath.Start, toolpath.Layers.Select(l => filter.MatchesLayer(l) ? Image(l, map) : l));
    }

    // Circles in XY stay circles in XY and Z stays linear along them.
    internal static bool KeepsCircles(Affine map)
    {
        double x = map.XAxis.LengthXY, y = map.YAxis.LengthXY;
        return map.XAxis.Z == 0 && map.YAxis.Z == 0 && map.ZAxis.X == 0 && map.ZAxis.Y == 0
            && x > 0 && Math.Abs(x - y) <= 1e-9 * x && Math.Abs(Vec3.Dot(map.XAxis, map.YAxis)) <= 1e-9 * x * y;
    }

    // Shifts, turns and mirrors, whose rounding is no scale.
    internal static bool KeepsLengths(Affine map)
    {
        static bool IsOne(double length) => Math.Abs(length - 1) <= 1e-12;
        return IsOne(map.XAxis.Length) && IsOne(map.YAxis.Length) && IsOne(map.ZAxis.Length) && IsOne(Math.Abs(map.Determinant));
    }

    internal static Arc Image(Arc arc, Affine map)
    {
        var turned = map.XAxis.X * map.YAxis.Y - map.XAxis.Y * map.YAxis.X < 0;
        return new Arc(map.Apply(arc.Center), turned ? -arc.Sweep : arc.Sweep, arc.Plane);
    }

    private static Layer Image(Layer layer, Affine map)
        => map.XAxis.Z == 0 && map.YAxis.Z == 0
            ? layer with { Z = map.Apply(new Vec3(0, 0, layer.Z)).Z, Thickness = layer.Thickness * Math.Abs(map.ZAxis.Z) }
            : layer;
}

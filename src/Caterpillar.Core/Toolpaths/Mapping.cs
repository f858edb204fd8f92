using System;
using System.Collections.Generic;
using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>
/// Moves, turns and scales paths and toolpaths. Cross-sections and speeds stay; E follows the length of the printed moves. Arcs stay arcs where the map keeps circles in
/// the XY plane, else they become chords.
/// </summary>
public static class Mapping
{
    /// <summary>The image of a path.</summary>
    /// <param name="path">The path.</param>
    /// <param name="map">The map, shift in mm.</param>
    /// <param name="tolerance">Distance in mm that chords keep from an arc before it is mapped.</param>
    public static PrintPath Transformed(this PrintPath path, Affine map, double tolerance = 0.01)
    {
        if (path is null) throw new ArgumentNullException(nameof(path));
        var mapped = Mapped(path, map, KeepsCircles(map), tolerance);
        return path.Layer is { } layer ? mapped.With(layer: Image(layer, map)) : mapped;
    }

    /// <summary>The image of a toolpath. The material of a printed move follows its length; retractions, primes and speeds stay.</summary>
    /// <inheritdoc cref="Transformed(PrintPath, Affine, double)" path="/param"/>
    public static Toolpath Transformed(this Toolpath toolpath, Affine map, double tolerance = 0.01)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        var keepsArcs = KeepsCircles(map);
        var builder = new ToolpathBuilder(toolpath.Source, toolpath.Start is { } from ? map.Apply(from) : null);
        foreach (var layer in toolpath.Layers) builder.AddLayer(Image(layer, map));
        var next = 0;
        void Events(int before)
        {
            for (; next < toolpath.Events.Count && toolpath.Events[next].Move <= before; next++) builder.AddEvent(toolpath.Events[next].Event);
        }
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var columns = toolpath.Blocks[block].Columns;
            for (var i = 0; i < columns.Count; i++)
            {
                var move = toolpath[toolpath.FirstOf(block) + i];
                Events(move.Index);
                Add(builder, move, map, keepsArcs, tolerance);
                if (columns.A is not null) builder.SetRotary(columns.A[i], columns.B![i], columns.C![i]);
            }
        }
        Events(toolpath.Count);
        return builder.Build(toolpath.Tools);
    }

    private static PrintPath Mapped(PrintPath path, Affine map, bool keepsArcs, double tolerance)
    {
        var points = new List<Vec3> { map.Apply(path.Start) };
        var beads = new List<Bead>();
        var arcs = new List<Arc?>();
        for (var i = 0; i < path.SegmentCount; i++)
        {
            var start = path.Points[i];
            var end = path.EndOf(i);
            if (path.ArcOf(i) is not { } arc)
            {
                Add(map.Apply(end), null);
            }
            else if (keepsArcs)
            {
                Add(map.Apply(end), Image(arc, map));
            }
            else
            {
                var chords = arc.ChordCount(start, tolerance);
                for (var k = 1; k <= chords; k++) Add(map.Apply(arc.PointAt(start, end, (double)k / chords)), null);
            }
            void Add(Vec3 point, Arc? image)
            {
                points.Add(point);
                beads.Add(path.BeadOf(i));
                arcs.Add(image);
            }
        }
        if (path.IsClosed) points.RemoveAt(points.Count - 1);
        return path.WithGeometry(points, beads, path.IsClosed, arcs);
    }

    private static void Add(ToolpathBuilder builder, Move move, Affine map, bool keepsArcs, double tolerance)
    {
        var arc = move.Arc;
        var chords = arc is { } a && !keepsArcs ? a.ChordCount(move.Start, tolerance) : 1;
        var image = arc is { } kept && keepsArcs ? Image(kept, map) : (Arc?)null;
        var last = move.Start;
        var length = move.Length;
        for (var k = 1; k <= chords; k++)
        {
            var point = chords == 1 ? move.End : arc!.Value.PointAt(move.Start, move.End, (double)k / chords);
            var end = map.Apply(point);
            var start = map.Apply(last);
            var share = chords == 1 ? 1 : 1.0 / chords;
            var deposited = move.Deposited * share;
            if (move.Kind == MoveKind.Print && length > 0) deposited = move.Deposited / length * (image is { } turned ? turned.Length(start, end) : start.DistanceTo(end));
            var e = move.E * share + (deposited - move.Deposited * share);
            builder.Add(end, e, deposited, move.Speed, move.Kind, move.Role, move.Layer, move.Tool, move.Source, image);
            last = point;
        }
    }

    // Circles in XY stay circles in XY and Z stays linear along them.
    private static bool KeepsCircles(Affine map)
    {
        double x = map.XAxis.LengthXY, y = map.YAxis.LengthXY;
        return map.XAxis.Z == 0 && map.YAxis.Z == 0 && map.ZAxis.X == 0 && map.ZAxis.Y == 0
            && x > 0 && Math.Abs(x - y) <= 1e-9 * x && Math.Abs(Vec3.Dot(map.XAxis, map.YAxis)) <= 1e-9 * x * y;
    }

    private static Arc Image(Arc arc, Affine map)
    {
        var turned = map.XAxis.X * map.YAxis.Y - map.XAxis.Y * map.YAxis.X < 0;
        return new Arc(map.Apply(arc.Center), turned ? -arc.Sweep : arc.Sweep, arc.Plane);
    }

    private static Layer Image(Layer layer, Affine map)
        => map.XAxis.Z == 0 && map.YAxis.Z == 0
            ? layer with { Z = map.Apply(new Vec3(0, 0, layer.Z)).Z, Thickness = layer.Thickness * Math.Abs(map.ZAxis.Z) }
            : layer;
}

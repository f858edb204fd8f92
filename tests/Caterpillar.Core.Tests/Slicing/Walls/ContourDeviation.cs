using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;

namespace Caterpillar.Tests.Slicing;

/// <summary>
/// How far outer walls lie from where the exact plane section wants them: half of their width inside of it. At a corner that turns inwards the wall goes
/// around in a point, so the lines of both edges count there.
/// </summary>
internal sealed class ContourDeviation
{
    /// <summary>mm; farther off counts as off.</summary>
    public const double Allowed = 0.0125;

    private const double Step = 0.05;
    private const double Cell = 1;
    private readonly List<(double Distance, double Line)> _near = [];

    /// <summary>Length of the outer walls that were measured, mm.</summary>
    public double Length { get; private set; }

    /// <summary>The part of it that is off.</summary>
    public double Off { get; private set; }

    public double Largest { get; private set; }

    public double SharePercent => 100 * Off / Length;

    /// <summary>Measures a layer out of every so many.</summary>
    public static ContourDeviation Of(TriMesh mesh, PrintSettings settings, int every)
    {
        settings = settings with { OverhangClasses = [], Support = SupportKind.None, SkirtLoops = 0 };
        var layers = PlanarSlicer.Slice([new NamedMesh("part", mesh)], settings).Value!.Layers.Where((_, i) => i % every == every / 2).ToArray();
        var sections = MeshSections.At(mesh, Array.ConvertAll(layers, l => l.Layer.Z - l.Layer.Thickness / 2)).Value!;
        var deviation = new ContourDeviation();
        for (var i = 0; i < layers.Length; i++)
        {
            var edges = Edges(Region.From(sections[i].Loops));
            foreach (var step in layers[i].Steps)
            {
                if (step.Path.Role == Role.OuterWall) deviation.Measure(step.Path, settings.BeadShape, edges);
            }
        }
        return deviation;
    }

    private void Measure(PrintPath path, BeadShape shape, Dictionary<(int, int), List<(Vec3 A, Vec3 B)>> edges)
    {
        for (var i = 0; i < path.SegmentCount; i++)
        {
            Vec3 a = path.Points[i], b = path.EndOf(i);
            var half = path.BeadOf(i).Width(shape) / 2;
            var pieces = (int)Math.Ceiling(a.DistanceTo(b) / Step);
            for (var k = 0; k < pieces; k++)
            {
                var off = DeviationAt(Vec3.Lerp(a, b, (k + 0.5) / pieces), half, edges);
                var length = a.DistanceTo(b) / pieces;
                Length += length;
                if (off > Allowed) Off += length;
                Largest = Math.Max(Largest, off);
            }
        }
    }

    // The lines of all edges that are as near as the nearest, within what is allowed: a corner may be made of several short edges.
    private double DeviationAt(Vec3 p, double half, Dictionary<(int, int), List<(Vec3 A, Vec3 B)>> edges)
    {
        _near.Clear();
        var nearest = double.PositiveInfinity;
        int column = (int)Math.Floor(p.X / Cell), row = (int)Math.Floor(p.Y / Cell);
        for (var y = row - 1; y <= row + 1; y++)
        {
            for (var x = column - 1; x <= column + 1; x++)
            {
                if (!edges.TryGetValue((x, y), out var cell)) continue;
                foreach (var (a, b) in cell)
                {
                    double dx = b.X - a.X, dy = b.Y - a.Y, px = p.X - a.X, py = p.Y - a.Y, square = dx * dx + dy * dy;
                    var t = Math.Min(1, Math.Max(0, (px * dx + py * dy) / square));
                    double ex = px - t * dx, ey = py - t * dy, distance = Math.Sqrt(ex * ex + ey * ey);
                    if (distance > nearest + Allowed) continue;
                    nearest = Math.Min(nearest, distance);
                    _near.Add((distance, Math.Abs(px * dy - py * dx) / Math.Sqrt(square)));
                }
            }
        }
        var off = Math.Abs(nearest - half);
        foreach (var (distance, line) in _near)
        {
            if (distance <= nearest + Allowed) off = Math.Min(off, Math.Abs(line - half));
        }
        return off;
    }

    // In every cell that their boxes meet.
    private static Dictionary<(int, int), List<(Vec3 A, Vec3 B)>> Edges(Region region)
    {
        var edges = new Dictionary<(int, int), List<(Vec3 A, Vec3 B)>>();
        foreach (var contour in region.Contours)
        {
            for (var i = 0; i < contour.Count; i++)
            {
                Vec3 a = contour[i], b = contour[i + 1 == contour.Count ? 0 : i + 1];
                if (a == b) continue;
                for (var y = (int)Math.Floor(Math.Min(a.Y, b.Y) / Cell); y <= (int)Math.Floor(Math.Max(a.Y, b.Y) / Cell); y++)
                {
                    for (var x = (int)Math.Floor(Math.Min(a.X, b.X) / Cell); x <= (int)Math.Floor(Math.Max(a.X, b.X) / Cell); x++)
                    {
                        if (!edges.TryGetValue((x, y), out var cell)) edges.Add((x, y), cell = []);
                        cell.Add((a, b));
                    }
                }
            }
        }
        return edges;
    }
}

using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing.Curved;

/// <summary>Solids between two surfaces, and slicing them along fields.</summary>
internal static class CurvedSolids
{
    /// <summary>Massive, so that volumes can be compared; nothing that is not part of the solid; any slope.</summary>
    public static readonly PrintSettings Massive = new()
    {
        LayerHeight = 0.5, FirstLayerHeight = 0.5, LineWidth = 0.8, BeadShape = BeadShape.Rectangle, WallCount = 1, InfillPercent = 100, InfillOverlapPercent = 0,
        SimplifyTolerance = 0, SkirtLoops = 0, TopLayers = 0, BottomLayers = 0, MinLayerTime = 0, OverhangClasses = ValueList<OverhangClass>.Empty, CurvedMaxSlope = 80,
        CurvedMaxGap = 2,
    };

    /// <summary>A block over a rectangle between two surfaces.</summary>
    public static TriMesh Between(Bounds plan, int steps, Func<double, double, double> low, Func<double, double, double> high)
    {
        var points = new List<Vec3>();
        for (var side = 0; side < 2; side++)
        {
            for (var j = 0; j <= steps; j++)
            {
                for (var i = 0; i <= steps; i++)
                {
                    double x = plan.Min.X + plan.Size.X * i / steps, y = plan.Min.Y + plan.Size.Y * j / steps;
                    points.Add(new Vec3(x, y, side == 0 ? low(x, y) : high(x, y)));
                }
            }
        }
        int At(int side, int i, int j) => side * (steps + 1) * (steps + 1) + j * (steps + 1) + i;
        var triangles = new List<int>();
        void Quad(int a, int b, int c, int d) => triangles.AddRange([a, b, c, a, c, d]);
        for (var j = 0; j < steps; j++)
        {
            for (var i = 0; i < steps; i++)
            {
                Quad(At(0, i, j), At(0, i, j + 1), At(0, i + 1, j + 1), At(0, i + 1, j));
                Quad(At(1, i, j), At(1, i + 1, j), At(1, i + 1, j + 1), At(1, i, j + 1));
            }
        }
        for (var i = 0; i < steps; i++)
        {
            Quad(At(0, i, 0), At(0, i + 1, 0), At(1, i + 1, 0), At(1, i, 0));
            Quad(At(0, i + 1, steps), At(0, i, steps), At(1, i, steps), At(1, i + 1, steps));
            Quad(At(0, 0, i + 1), At(0, 0, i), At(1, 0, i), At(1, 0, i + 1));
            Quad(At(0, steps, i), At(0, steps, i + 1), At(1, steps, i + 1), At(1, steps, i));
        }
        return TriMesh.Create(points, triangles);
    }

    public static Bounds Plan(double x0, double y0, double x1, double y1) => new(new Vec3(x0, y0), new Vec3(x1, y1));

    public static Result<SliceResult> Try(LayerField field, PrintSettings settings, CurvedOptions? options, params TriMesh[] meshes)
        => CurvedSlicer.Slice([new NamedMesh("test", TriMesh.Merge(meshes))], field, new PrintSetup { Settings = settings }, options);

    public static IReadOnlyList<SlicedLayer> Slice(LayerField field, PrintSettings settings, params TriMesh[] meshes)
    {
        var result = Try(field, settings, null, meshes);
        Assert.That(result.Diagnostics.Where(d => d.Severity != Severity.Remark), Is.Empty);
        return result.Value!.Layers;
    }

    public static double Volume(SlicedLayer layer) => layer.Steps.Sum(s => s.Path.Volume);

    public static IEnumerable<Vec3> Points(SlicedLayer layer) => layer.Steps.SelectMany(s => s.Path.Points);
}

using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Display;
using Caterpillar.Files;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;

namespace Caterpillar.Examples;

/// <summary>Images of slicing settings, for the manual.</summary>
internal static class SlicingImages
{
    private static readonly View Slanted = new(-60, 30);
    private static readonly View Top = new(-90, 90);

    public static void Write(string folder)
    {
        var plain = new PrintSettings { MinLayerTime = 0, FirstLayerSpeed = 0 };
        var dome = Revolved((14, 0), (14, 2), (13, 4.5), (11, 7), (8, 9), (4, 10.2), (0, 10.5));
        Draw(folder, "skins", dome, plain, 44, 44, Top);
        Draw(folder, "bridge", Table(), plain, 0, 25, Slanted);
        Draw(folder, "bridge_layer", Table(), plain, 25, 25, Top);
        Draw(folder, "overhangs", Revolved((6, 0), (6, 2), (14, 7), (14, 9)), plain, 0, 99, new View(-60, -15), ColorBy.Speed);
        var adaptive = plain with { AdaptiveLayers = true, AdaptiveMinHeight = 0.08, AdaptiveMaxHeight = 0.6, AdaptiveCuspHeight = 0.08 };
        Draw(folder, "adaptive", dome, adaptive, 0, 999, new View(-60, 8), ColorBy.Layer);
        Draw(folder, "brim", Table(), plain with { BrimWidth = 4, SkirtLoops = 2, SkirtDistance = 4 }, 0, 3, Slanted);
        Draw(folder, "raft", Table(), plain with { RaftLayers = 3 }, 0, 6, Slanted);
        var tools = plain with { PurgeTower = true, PurgeVolume = 20, PurgeTowerWidth = 25, WallTool = 1 };
        Draw(folder, "two_tools", Revolved((12, 0), (12, 8)), tools, 0, 75, Slanted);
        var vase = plain with { SpiralVase = true, LayerHeight = 0.6, FirstLayerHeight = 0.6, LineWidth = 0.8 };
        Draw(folder, "vase", Revolved((8, 0), (12, 6), (13, 10), (10, 18), (12, 24)), vase, 0, 999, Slanted);
        Draw(folder, "rough", Revolved((8, 0), (8, 10)), plain with { FuzzySkinThickness = 0.25, LayerHeight = 0.3 }, 0, 25, Slanted);
        Draw(folder, "thick_infill", Revolved((10, 0), (10, 6)), plain with { CombineInfillLayers = 3 }, 0, 17, Slanted);
        var solid = plain with { WallCount = 2, InfillDensityPercent = 100, TopLayers = 0, BottomLayers = 0 };
        Draw(folder, "thin_walls", Wedges(), solid, 4, 4, Top);
        Draw(folder, "thin_walls_before", Wedges(), solid with { VariableWallWidth = false }, 4, 4, Top);
        var boss = Plate(boss: true);
        Draw(folder, "one_wall", boss, plain with { WallCount = 3, OnlyOneWallTop = true }, 19, 19, Top);
        Draw(folder, "one_wall_before", boss, plain with { WallCount = 3 }, 19, 19, Top);
        Draw(folder, "polyholes", Plate(boss: false), plain with { HoleToPolyhole = true }, 10, 10, Top);
        Draw(folder, "polyholes_before", Plate(boss: false), plain, 10, 10, Top);
        Draw(folder, "ears", Plate(boss: false), plain with { BrimType = BrimType.Ears, BrimWidth = 5 }, 0, 0, Top);
        var shelf = TriMesh.Merge([Block(0, 0, 5, 24, 10), Block(5, 0, 7, 24, 26)]);
        Draw(folder, "extra_walls", shelf, plain with { ExtraWallsOnOverhangs = true }, 25, 25, Top);
        Draw(folder, "extra_walls_before", shelf, plain, 25, 25, Top);
        var mushroom = Revolved((4, 0), (4, 12), (14, 14), (14, 17));
        Draw(folder, "support_grid", mushroom, plain with { Support = SupportKind.Grid }, 0, 66, new View(-60, 12));
        Draw(folder, "support_tree", mushroom, plain with { Support = SupportKind.Tree }, 0, 66, new View(-60, 12));
    }

    private static void Draw(string folder, string name, TriMesh mesh, PrintSettings settings, int from, int to, View view, ColorBy color = ColorBy.Role)
    {
        var setup = new PrintSetup { Settings = settings, Printer = new Printer { ToolOffsets = new(Vec3.Zero, Vec3.Zero) } };
        var sliced = PlanarSlicer.Slice([new NamedMesh(name, mesh.Moved(new Vec3(100, 100)))], settings).Value ?? throw new InvalidOperationException(name);
        var steps = sliced.Layers.Where((_, i) => i >= from && i <= to).SelectMany(l => l.Steps).ToArray();
        var toolpath = Planner.Plan(steps, setup).Value ?? throw new InvalidOperationException(name);
        var bytes = PngWriter.ToBytes(ToolpathImage.Draw(toolpath, new ToolpathImageOptions { Width = 480, Height = 360, View = view, ColorBy = color }));
        File.WriteAllBytes(Path.Combine(folder, "slicing_" + name + ".png"), bytes);
        Console.WriteLine($"slicing_{name}.png: {bytes.Length} bytes");
    }

    /// <summary>A slab on two walls.</summary>
    private static TriMesh Table() => TriMesh.Merge([Block(0, 0, 5, 5, 24), Block(0, 25, 5, 30, 24), Block(5, 0, 7, 30, 24)]);

    /// <summary>A plate with holes of 3.4, 5 and 8 mm, and if asked for a boss in its middle.</summary>
    private static TriMesh Plate(bool boss)
    {
        var solid = new BlockSolid([0, 12, 18, 30], [0, 12, 18, 30], [0, 4, 6]);
        solid.Fill(0, 3, 0, 3, 0, 1);
        if (boss) solid.Fill(1, 2, 1, 2, 1, 2);
        solid.DrillAlongZ(0, 0, 0, 1, 1.7);
        solid.DrillAlongZ(2, 0, 0, 1, 1.7);
        solid.DrillAlongZ(0, 2, 0, 1, 2.5);
        solid.DrillAlongZ(2, 2, 0, 1, 4);
        return solid.ToMesh();
    }

    /// <summary>Four spokes that taper from 3 to 0.3 mm.</summary>
    private static TriMesh Wedges()
    {
        Vec3[] Spoke(double turn)
        {
            var (sin, cos) = Angle.SinCos(turn);
            Vec3 At(double along, double aside) => new(along * cos - aside * sin, along * sin + aside * cos);
            return [At(1, -1.5), At(12, -0.15), At(12, 0.15), At(1, 1.5)];
        }
        return TriMesh.Merge(Enumerable.Range(0, 4).Select(k => Lofted([(0, Spoke(90 * k)), (2, Spoke(90 * k))])));
    }

    // From z0 to z1, y0 to y1, x from 0 to a width.
    private static TriMesh Block(double z0, double y0, double z1, double y1, double width)
        => Lofted([(z0, Rectangle(y0, y1, width)), (z1, Rectangle(y0, y1, width))]);

    private static Vec3[] Rectangle(double y0, double y1, double width) => [new(0, y0), new(width, y0), new(width, y1), new(0, y1)];

    internal static TriMesh Revolved(params (double Radius, double Z)[] profile)
        => Lofted(profile.Select(p => (p.Z, Circle(p.Radius))).ToArray());

    private static Vec3[] Circle(double radius)
        => Enumerable.Range(0, 120).Select(i => Angle.SinCos(3.0 * i)).Select(a => new Vec3(radius * a.Cos, radius * a.Sin)).ToArray();

    internal static TriMesh Lofted((double Z, Vec3[] Ring)[] rings)
    {
        var n = rings[0].Ring.Length;
        var points = rings.SelectMany(r => r.Ring.Select(p => p.WithZ(r.Z))).ToList();
        var triangles = new List<int>();
        for (var k = 0; k + 1 < rings.Length; k++)
        {
            for (var i = 0; i < n; i++)
            {
                int a = k * n + i, b = k * n + (i + 1) % n;
                triangles.AddRange([a, b, b + n, a, b + n, a + n]);
            }
        }
        points.Add(rings[0].Ring.Aggregate(Vec3.Zero, (s, p) => s + p / n).WithZ(rings[0].Z));
        points.Add(rings[rings.Length - 1].Ring.Aggregate(Vec3.Zero, (s, p) => s + p / n).WithZ(rings[rings.Length - 1].Z));
        for (var i = 0; i < n; i++)
        {
            int next = (i + 1) % n, top = (rings.Length - 1) * n;
            triangles.AddRange([points.Count - 2, next, i, points.Count - 1, top + i, top + next]);
        }
        return TriMesh.Create(points, triangles);
    }
}

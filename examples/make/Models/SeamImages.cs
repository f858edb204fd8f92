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
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples;

/// <summary>Images of seam positions for the manual, with a knob at each seam.</summary>
internal static class SeamImages
{
    public static void Write(string folder)
    {
        var plain = new PrintSettings
        {
            MinLayerTime = 0, LayerHeight = 0.4, FirstLayerHeight = 0.4, WallCount = 1, InfillDensityPercent = 0, TopLayers = 0, BottomLayers = 0,
                TopThickness = 0,
            BottomThickness = 0,
        };
        SeamPosition[] positions =
            [SeamPosition.Aligned, SeamPosition.Corner, SeamPosition.Rear, SeamPosition.Point, SeamPosition.Random, SeamPosition.Nearest];
        foreach (var position in positions)
            Draw(folder, position.ToString().ToLowerInvariant(), plain with { SeamPosition = position, SeamPoint = new Vec3(130, 115) });
        var marks = Enumerable.Range(0, 15).Select(i => new SeamMark(new Vec3(109 - 0.4 * i, 103 + 0.4 * i, i), 4));
        Draw(folder, "painted", plain with { SeamPosition = SeamPosition.Rear, SeamEnforcers = new ValueList<SeamMark>(marks.Where((_, i) => i > 3)) });
    }

    private static void Draw(string folder, string name, PrintSettings settings)
    {
        var setup = new PrintSetup { Settings = settings };
        var mesh = SlicingImages.Lofted([(0, Ring(0)), (14, Ring(25))]).Moved(new Vec3(100, 100));
        var sliced = PlanarSlicer.Slice([new NamedMesh(name, mesh)], settings).Value ?? throw new InvalidOperationException(name);
        var paths = sliced.Layers.SelectMany(l => l.Steps).Cast<Step>().ToArray();
        // The nearest seam is only known after travel planning. One loop per layer.
        var planned = Planner.Plan(paths, setup).Value ?? throw new InvalidOperationException(name);
        var starts = planned.Moves().Where(m => m.Kind == MoveKind.Print).GroupBy(m => m.Layer).Select(l => (l.First().Start, Layer: l.Key));
        var steps = new List<Step>(paths);
        foreach (var (at, layer) in starts)
        {
            var knob = new PrintPath([at - new Vec3(0.05, 0), at + new Vec3(0.05, 0)], [new Bead(0.45, 0.4)])
                with { Role = Role.Bridge, Layer = sliced.Layers[layer].Layer };
            steps.Add(new PathStep(knob));
        }
        var toolpath = Planner.Plan(steps, setup).Value ?? throw new InvalidOperationException(name);
        var bytes = PngWriter.ToBytes(ToolpathImage.Draw(toolpath, new ToolpathImageOptions { Width = 360, Height = 270, View = new View(35, 30) }));
        File.WriteAllBytes(Path.Combine(folder, "seam_" + name + ".png"), bytes);
        Console.WriteLine($"seam_{name}.png: {bytes.Length} bytes");
    }

    // Round, with a notch that turns as it climbs.
    private static Vec3[] Ring(double turn)
    {
        const double Half = 14;
        return Enumerable.Range(0, 180).Select(i =>
        {
            var (sin, cos) = Angle.SinCos(2.0 * i + turn);
            var toNotch = Math.Abs((2.0 * i - 20 + 540) % 360 - 180);
            var radius = 10 - 3 * Math.Max(0, 1 - toNotch / Half);
            return new Vec3(radius * cos, radius * sin);
        }).ToArray();
    }
}

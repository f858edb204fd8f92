using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Display;
using Caterpillar.Files;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples;

/// <summary>Images of curved slicing, for the manual.</summary>
internal static class CurvedImages
{
    public static void Write(string folder)
    {
        foreach (var (name, make, color, view) in CurvedExamples.All)
        {
            var options = new ToolpathImageOptions { Width = 480, Height = 360, View = view, ColorBy = color };
            var example = make();
            // Others hide what they are printed on.
            var toolpath = name == "terrain" ? OnObject(example) : example.Toolpath;
            var bytes = PngWriter.ToBytes(ToolpathImage.Draw(toolpath, options));
            File.WriteAllBytes(Path.Combine(folder, "curved_" + name + ".png"), bytes);
            Console.WriteLine($"curved_{name}.png: {bytes.Length} bytes");
        }
    }

    // The object below as light rows, which shade like a surface.
    private static Toolpath OnObject(CurvedExample example)
    {
        const double Apart = 0.7, Deep = 0.3;
        var under = example.Setup.PrintedOn!;
        var (box, surface) = (under.Bounds, PlanSurface.Of(under));
        var rows = new List<Step>();
        for (var y = box.Min.Y + Apart / 2; y < box.Max.Y; y += Apart)
        {
            var points = Enumerable.Range(0, (int)((box.Max.X - box.Min.X) / Apart)).Select(i => box.Min.X + Apart * (i + 0.5)).Where(x => surface.Covers(x, y))
                .Select(x => new Vec3(x, y, surface.Height(x, y))).ToList();
            if (points.Count > 1) rows.Add(new PathStep(new PrintPath(points, new Bead(1.3 * Apart * Deep, Deep)) { Role = Role.GapFill }));
        }
        var below = Planner.Plan(rows, new PrintSetup(), new PlanOptions { Policy = PlanPolicy.AsDrawn }).OrThrow();
        return Planner.Merge([below, example.Toolpath], new PrintSetup()).OrThrow();
    }
}

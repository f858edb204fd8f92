using System;
using System.Collections.Generic;
using System.IO;
using Caterpillar.Display;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples;

/// <summary>Pictures of the trace examples for the manual.</summary>
internal static class TracePictures
{
    public static void Write(string folder)
    {
        Directory.CreateDirectory(folder);
        foreach (var (name, make) in KanadaParts.All)
        {
            var byArea = name is "globe" or "lettered_bowl";
            var options = new PictureOptions
            {
                Width = 480,
                Height = 360,
                View = new View(-60, name.StartsWith("heart", StringComparison.Ordinal) || name.Contains("plate", StringComparison.Ordinal) ? 40 : 22),
                ColourBy = byArea ? ColourBy.Speed : ColourBy.Height,
            };
            var bytes = PngWriter.ToBytes(Picture.Draw(Drawn(make()), options));
            File.WriteAllBytes(Path.Combine(folder, "kanada_" + name + ".png"), bytes);
            Console.WriteLine($"kanada_{name}.png: {bytes.Length} bytes");
        }
    }

    // The moves that print the paths one after the other; E in mm³.
    private static Toolpath Drawn(IReadOnlyList<PrintPath> paths)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, paths[0].Start);
        for (var step = 0; step < paths.Count; step++)
        {
            var path = paths[step];
            if (path.Start != builder.Position) builder.Add(path.Start, 0, 0, 100, MoveKind.Travel, path.Role, -1, 0, step);
            for (var i = 0; i < path.SegmentCount; i++)
            {
                var bead = path.BeadOf(i);
                var volume = path.LengthOf(i) * bead.Area;
                builder.Add(path.EndOf(i), volume, volume, bead.Speed, MoveKind.Print, path.Role, -1, 0, step, path.ArcOf(i));
            }
        }
        return builder.Build([new ToolpathTool(1)]);
    }
}

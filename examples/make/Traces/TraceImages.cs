using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Display;
using Caterpillar.Files;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;

namespace Caterpillar.Examples;

/// <summary>Images of the trace examples for the manual.</summary>
internal static class TraceImages
{
    public static void Write(string folder)
    {
        Directory.CreateDirectory(folder);
        foreach (var (name, make) in KanadaParts.All)
        {
            var byArea = name is "globe" or "lettered_bowl";
            var options = new ToolpathImageOptions
            {
                Width = 480,
                Height = 360,
                View = new View(-60, name.StartsWith("heart", StringComparison.Ordinal) || name.Contains("plate", StringComparison.Ordinal) ? 40 : 22),
                ColorBy = byArea ? ColorBy.Speed : ColorBy.Height,
            };
            var bytes = PngWriter.ToBytes(ToolpathImage.Draw(Drawn(make()), options));
            File.WriteAllBytes(Path.Combine(folder, "kanada_" + name + ".png"), bytes);
            Console.WriteLine($"kanada_{name}.png: {bytes.Length} bytes");
        }
    }

    private static Toolpath Drawn(IReadOnlyList<PrintPath> paths)
        => Planner.Plan(paths.Select(path => (Step)path).ToArray(), new PrintSetup(), new PlanOptions { Policy = PlanPolicy.AsDrawn, Start = paths[0].Start })
            .Value
            ?? throw new InvalidOperationException("The example cannot be planned.");
}

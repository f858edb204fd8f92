using System;
using System.IO;
using Caterpillar.Display;
using Caterpillar.Files;

namespace Caterpillar.Examples;

/// <summary>Images of curved slicing, for the manual.</summary>
internal static class CurvedImages
{
    public static void Write(string folder)
    {
        foreach (var (name, make, color, view) in CurvedExamples.All)
        {
            var options = new ToolpathImageOptions { Width = 480, Height = 360, View = view, ColorBy = color };
            var bytes = PngWriter.ToBytes(ToolpathImage.Draw(make().Toolpath, options));
            File.WriteAllBytes(Path.Combine(folder, "curved_" + name + ".png"), bytes);
            Console.WriteLine($"curved_{name}.png: {bytes.Length} bytes");
        }
    }
}

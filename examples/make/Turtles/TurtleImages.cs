using System;
using System.IO;
using Caterpillar.Display;
using Caterpillar.Files;
using Caterpillar.Jobs;
using Caterpillar.Machines;

namespace Caterpillar.Examples;

/// <summary>The image of turtle programs for the manual: a sheet of four columns.</summary>
internal static class TurtleImages
{
    private const int Columns = 4;
    private const int Width = 320;
    private const int Height = 240;

    private static readonly string[] Programs =
    [
        "braille_rule30", "branching_tree", "bumpy_prism", "hair_bridge", "hilbert", "kanada_tree", "nonplanar_vase", "pine_tree", "prism_bottoms", "rose",
        "string_art_parabola", "weave_wall",
    ];

    /// <summary>Draws the programs of a folder.</summary>
    public static void Write(string programs, string folder)
    {
        var options = new ToolpathImageOptions { Width = Width, Height = Height, ColorBy = ColorBy.Role };
        var sheet = new RasterImage(Columns * Width, (Programs.Length + Columns - 1) / Columns * Height, ToolpathImage.Background);
        var setup = new ProfileLibrary().Setup("generic").OrThrow();
        for (var i = 0; i < Programs.Length; i++)
        {
            var file = Path.Combine(programs, Programs[i] + ".turtle");
            using var job = PrintJob.Turtle(file, setup).OrThrow();
            Copy(ToolpathImage.Draw(job.Toolpath, options), sheet, i % Columns * Width, i / Columns * Height);
        }
        var bytes = PngWriter.ToBytes(sheet);
        File.WriteAllBytes(Path.Combine(folder, "turtles.png"), bytes);
        Console.WriteLine($"turtles.png: {bytes.Length} bytes");
    }

    private static void Copy(RasterImage from, RasterImage to, int x, int y)
    {
        for (var row = 0; row < from.Height; row++)
        {
            for (var column = 0; column < from.Width; column++) to[x + column, y + row] = from[column, row];
        }
    }
}

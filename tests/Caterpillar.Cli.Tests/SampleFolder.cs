using System;
using System.IO;
using System.Linq;
using Caterpillar.Tests;

namespace Caterpillar.Cli.Tests;

/// <summary>The files that the examples of help and manual name.</summary>
internal static class SampleFolder
{
    public const string Star = "param layers = 2\nparam side = 20\nstart 100 100 0.2\ndensity 0.05\nfor n = 0 to layers - 1 [\n  layer n 0.2\n"
        + "  repeat 5 [ forward side; right 144 ]\n  lift 0.2\n]\n";

    /// <param name="boxAt">An ASCII STL of a box, with the x and y of its corner.</param>
    /// <param name="run">Runs the program.</param>
    public static void Fill(Func<double, double, double, double, string> boxAt, Action<string[]> run)
    {
        string Box(double x, double y, double z) => boxAt(x, y, z, 0);
        foreach (var name in new[] { "a", "b", "box", "lid", "pawn" }) File.WriteAllText(name + ".stl", Box(8, 6, 2));
        File.WriteAllText("part.stl", Box(8, 6, 13));
        File.WriteAllText("roof.stl", Box(6, 5, 20));
        foreach (var name in new[] { "hat", "branching" }) File.WriteAllText(name + ".stl", Box(8, 6, 4));
        // Start code does not go there.
        File.WriteAllText("scan.stl", boxAt(8, 6, 4, 100));
        File.WriteAllText("logo.stl", boxAt(5, 4, 0.8, 101));
        Directory.CreateDirectory("models");
        File.WriteAllText("models/a.stl", Box(8, 8, 1));
        File.WriteAllText("models/b.stl", Box(6, 8, 1));
        File.WriteAllText("star.turtle", Star);
        File.WriteAllText("values.csv", "layers,side\n1,15\n2,20\n3,25\n");
        File.WriteAllText("heights.csv", "name,layer_height_mm,infill_density_percent,--rotate\ncoarse,0.28,15,0\nfine,0.12,15,0\nturned,0.2,30,45\n");
        File.WriteAllText("curves.csv", "x,y,z\n10,10,0.2\n30,10,0.2\n30,50,0.2\n");
        File.WriteAllText("drawing.svg", Svg(40, 40, "M5 5L30 5L30 30"));
        File.WriteAllText("pattern.svg", Svg(200, 200, "M102 96L106 96L106 98"));
        File.WriteAllText("header.gcode", "G21\nG90\nM82\nM104 S200\nG28\nM109 S200\nG92 E0\n");
        File.WriteAllText("footer.gcode", "M104 S0\nM140 S0\nG28 X0\nM84\n");
        run(["slice", "part.stl", "-o", "part.gcode"]);
        File.Copy("part.gcode", "print.gcode");
        run(["slice", Path.Combine(TestData.Repository, "examples", "models", "bracket.stl"), "-o", "bracket.gcode"]);
        CopyExamples();
    }

    private static string Svg(int width, int height, string path)
        => $"<svg width=\"{width}mm\" height=\"{height}mm\" viewBox=\"0 0 {width} {height}\"><path d=\"{path}\"/></svg>";

    private static void CopyExamples()
    {
        foreach (var folder in new[] { "models", "turtle", "curves", "scale", "turtle/lib" })
        {
            var from = Path.Combine(TestData.Repository, "examples", folder);
            Directory.CreateDirectory(Path.Combine("examples", folder));
            foreach (var file in Directory.EnumerateFiles(from)) File.Copy(file, Path.Combine("examples", folder, Path.GetFileName(file)));
        }
    }
}

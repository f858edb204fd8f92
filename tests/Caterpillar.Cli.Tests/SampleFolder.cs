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
        foreach (var name in new[] { "a", "b", "box", "cube", "lid", "pawn" }) File.WriteAllText(name + ".stl", Box(8, 6, 2));
        File.WriteAllText("part.stl", Box(8, 6, 13));
        File.WriteAllText("roof.stl", Box(6, 5, 20));
        foreach (var name in new[] { "hat", "branching" }) File.WriteAllText(name + ".stl", Box(8, 6, 4));
        // Start code does not go there.
        File.WriteAllText("scan.stl", boxAt(8, 6, 4, 100));
        File.WriteAllText("vessel.stl", boxAt(60, 60, 100, 120));
        File.WriteAllText("shell.obj", Tube());
        File.WriteAllText("side.csv", "curve,x,y,z\n0,130,119.9,60\n0,145,119.9,60\n1,155,119.9,60\n1,170,119.9,60\n");
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
        FillSlicers();
        run(["slice", "part.stl", "-o", "part.gcode"]);
        File.Copy("part.gcode", "print.gcode");
        run(["slice", Path.Combine(TestData.Repository, "examples", "models", "bracket.stl"), "-o", "bracket.gcode"]);
        CopyExamples();
    }

    // Open at both ends.
    private static string Tube()
    {
        const int Sides = 12;
        var points = Enumerable.Range(0, 2 * Sides).Select(i => (Radius: i < Sides ? 8 : 10, Angle: 2 * Math.PI * i / Sides, Z: i < Sides ? 0 : 6))
            .Select(p => FormattableString.Invariant($"v {p.Radius * Math.Cos(p.Angle):F4} {p.Radius * Math.Sin(p.Angle):F4} {p.Z}"));
        var faces = Enumerable.Range(1, Sides).Select(i => (A: i, B: i % Sides + 1)).Select(f => $"f {f.A} {f.B} {f.B + Sides} {f.A + Sides}");
        return string.Join("\n", points.Concat(faces)) + "\n";
    }

    // Settings of other slicers.
    private static void FillSlicers()
    {
        const string Machine = "bed_shape = 0x0,220x0,220x220,0x220\nmax_print_height = 200\ngcode_flavor = marlin2\nnozzle_diameter = 0.4\n"
            + "machine_max_feedrate_x = 200\nmachine_max_feedrate_y = 200\nmachine_max_feedrate_z = 12\nmachine_max_feedrate_e = 60\n"
            + "retract_length = 0.8\nretract_speed = 35\nretract_lift = 0.2\nstart_gcode = G28\nend_gcode = M104 S0\\nM140 S0\n";
        const string Print = "layer_height = 0.2\nfirst_layer_height = 0.2\nperimeters = 2\nfill_density = 15%\nfill_pattern = gyroid\n"
            + "perimeter_speed = 60\nexternal_perimeter_speed = 50%\ninfill_speed = 80\ntravel_speed = 150\n";
        const string Filament = "temperature = 210\nbed_temperature = 60\nfirst_layer_bed_temperature = 60\nfilament_diameter = 1.75\n";
        File.WriteAllText("old.ini", "[printer:Old One]\ndefault_print_profile = Fine\ndefault_filament_profile = Silver\n" + Machine
            + "[print:Fine]\n" + Print + "[filament:Silver]\n" + Filament);
        File.WriteAllText("old.gcode", "G28\nM109 S210\nG1 X50 Y50 Z0.2 F3000\nG1 X90 E2\n; " + (Machine + Print + Filament).Replace("\n", "\n; "));
        File.WriteAllText("machine.json", """
            { "type": "machine", "name": "Machine", "printable_area": ["0x0", "220x0", "220x220", "0x220"], "printable_height": "200",
              "nozzle_diameter": ["0.4"], "machine_start_gcode": "G28", "machine_end_gcode": "M104 S0" }
            """);
        using var zip = System.IO.Compression.ZipFile.Open("project.3mf", System.IO.Compression.ZipArchiveMode.Create);
        const string Faces = "0 2 1,0 3 2,4 5 6,4 6 7,0 1 5,0 5 4,1 2 6,1 6 5,2 3 7,2 7 6,3 0 4,3 4 7";
        var corners = new[] { "0 0 0", "9 0 0", "9 9 0", "0 9 0", "0 0 4", "9 0 4", "9 9 4", "0 9 4" }.Select(c => c.Split(' '));
        Put("Metadata/Slic3r_PE.config", "; " + (Machine + Print + Filament).TrimEnd().Replace("\n", "\n; "));
        Put("3D/3dmodel.model", "<model unit=\"millimeter\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"><resources><object id=\"1\">"
            + "<mesh><vertices>" + string.Concat(corners.Select(c => $"<vertex x=\"{c[0]}\" y=\"{c[1]}\" z=\"{c[2]}\"/>")) + "</vertices><triangles>"
            + string.Concat(Faces.Split(',').Select(f => f.Split(' ')).Select(f => $"<triangle v1=\"{f[0]}\" v2=\"{f[1]}\" v3=\"{f[2]}\"/>"))
            + "</triangles></mesh></object></resources><build><item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 100 90 0\"/></build></model>");

        void Put(string path, string text)
        {
            using var writer = new StreamWriter(zip.CreateEntry(path).Open());
            writer.Write(text);
        }
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

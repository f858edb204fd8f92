using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;
using Caterpillar.Geometry;
using Caterpillar.Tests.Geometry.Meshes;

namespace Caterpillar.Bench;

/// <summary>Curved slicing against planar slicing of the same mesh, whole processes, checks included; growth with layers and with triangles.</summary>
internal static class CurvedRuns
{
    private const int Runs = 3;

    /// <summary>A table in Markdown.</summary>
    /// <param name="program">The published program.</param>
    /// <param name="models">The folder of saddle_roof.stl and branching.stl.</param>
    public static void Run(string program, string models)
    {
        var work = Directory.CreateTempSubdirectory("caterpillar-").FullName;
        try
        {
            var (roof, branching) = (Path.Combine(models, "saddle_roof.stl"), Path.Combine(models, "branching.stl"));
            Console.WriteLine("| model | layers | processor | of planar | peak | lines of G-code |");
            Console.WriteLine("|---|---|---|---|---|---|");
            Compare(program, work, roof, [],
            [
                ["--surface", roof, "--blend", "2,18"], ["--surface", roof], ["--field", "between", "--surface", roof], ["--deform", "cone=12"],
                ["--field", "z - 1.5 * sin(4 * x) * cos(3 * y)"], ["--deform", "x; y; z - r * r / 300"],
            ]);
            string[] coarse = ["--set", "layer_height_mm=0.3", "--set", "first_layer_height_mm=0.3"];
            Compare(program, work, branching, coarse, [["--field", "harmonic"], ["--field", "geodesic"]]);
            foreach (var height in new[] { "0.4", "0.1" })
                Compare(program, work, roof, ["--set", "layer_height_mm=" + height], [["--surface", roof, "--blend", "2,18"]]);
            foreach (var edge in new[] { 0.65, 0.32 })
            {
                var fine = Refined(roof, edge, work);
                Compare(program, work, fine, [], [["--surface", fine, "--blend", "2,18"]]);
            }
        }
        finally
        {
            Directory.Delete(work, true);
        }
    }

    private static void Compare(string program, string work, string model, string[] common, string[][] fields)
    {
        var planar = Row(program, work, model, common, [], 0);
        foreach (var field in fields) Row(program, work, model, common, field, planar);
    }

    private static double Row(string program, string work, string model, string[] common, string[] field, double planar)
    {
        var output = Path.Combine(work, "o.gcode");
        // Whether all of it could be printed is not the question here.
        var runs = ProcessRuns.Of(program, ["slice", model, .. common, .. field, "--override", "measured", "-o", output], Runs);
        var words = common.Where(w => w != "--set").Concat(field.Length == 0 ? ["planar"] : field.Select(Path.GetFileName));
        var ratio = planar > 0 ? (runs.Processor / planar).ToString("0.0 ×", CultureInfo.InvariantCulture) : "";
        var lines = File.ReadLines(output).Count().ToString("N0", CultureInfo.InvariantCulture);
        Console.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"| {Path.GetFileNameWithoutExtension(model)} | `{string.Join(' ', words)}` | {runs.Processor:0.00} s | {ratio} | {runs.Peak:0} MB | {lines} |"));
        return runs.Processor;
    }

    private static string Refined(string model, double edge, string work)
    {
        var mesh = MeshReader.Read(model).Value![0].Mesh;
        var fine = MeshRefiner.Refine(mesh, edge, int.MaxValue, CancellationToken.None).Mesh;
        var file = Path.Combine(work, $"roof of {fine.TriangleCount.ToString("N0", CultureInfo.InvariantCulture)} triangles.stl");
        File.WriteAllBytes(file, StlWriter.ToBytes(fine, "roof"));
        return file;
    }
}

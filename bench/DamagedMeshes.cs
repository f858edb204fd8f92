using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Tests.Geometry.Meshes;
using Caterpillar.Toolpaths;

namespace Caterpillar.Bench;

/// <summary>
/// <c>damaged FOLDER FIRST COUNT OUT</c>: the closed meshes of a folder, damaged at random by so many seeds, repaired and cut; seeds with layers below 90 % of
/// their area are named, and their good and bad meshes are written into OUT for other programs. <c>lost GOOD.gcode BAD.gcode</c>: layers of solid prints with
/// less than 90 % of the material of the undamaged mesh, whatever program wrote them.
/// </summary>
internal static class DamagedMeshes
{
    private const double Enough = 0.9;
    private const double Thickness = 0.2;

    private static readonly string[] Names =
    [
        "fandisk.stl", "spot.obj", "cheburashka.ply", "homer.stl", "plate_holes.stl", "torus.obj", "nested_boxes.obj", "overlap_boxes.stl", "tube_thin.stl",
    ];

    public static void Run(string folder, int first, int count, string target)
    {
        Directory.CreateDirectory(target);
        long layers = 0;
        for (var seed = first; seed < first + count; seed++)
        {
            var good = TriMesh.Merge(MeshReader.Read(Path.Combine(folder, Names[seed % Names.Length])).Value!.Select(m => m.Mesh));
            var (damaged, what) = MeshDamage.Damage(good, seed);
            var heights = Enumerable.Range(0, (int)(good.Bounds.Max.Z / Thickness)).Select(i => (i + 0.5) * Thickness).ToArray();
            layers += heights.Length;
            var (expected, actual) = (Areas(good, heights), Areas(Repaired(damaged), heights));
            var lost = Enumerable.Range(0, heights.Length).Where(i => actual[i] < Enough * expected[i])
                .Select(i => (heights[i], actual[i] / expected[i])).ToList();
            if (lost.Count == 0) continue;
            File.WriteAllBytes(Path.Combine(target, $"{Text(seed)}-good.stl"), StlWriter.ToBytes(good));
            File.WriteAllBytes(Path.Combine(target, $"{Text(seed)}-bad.stl"), StlWriter.ToBytes(damaged));
            Console.WriteLine($"{what} ({Names[seed % Names.Length]}): {Described(lost)}");
        }
        Console.WriteLine($"{Text(count)} meshes, {Text(layers)} layers");
    }

    public static void Lost(string good, string bad)
    {
        var (expected, actual) = (Volumes(good), Volumes(bad));
        var lost = expected.Where(l => actual.GetValueOrDefault(l.Key) < Enough * l.Value)
            .Select(l => (l.Key, actual.GetValueOrDefault(l.Key) / l.Value)).OrderBy(l => l.Key).ToList();
        Console.WriteLine($"  {Path.GetFileNameWithoutExtension(bad)}: {Described(lost)}");
    }

    private static TriMesh Repaired(TriMesh damaged)
        => MeshRepair.ToSolid(TriMesh.Merge(MeshReader.Read(StlWriter.ToBytes(damaged), "damaged.stl").Value!.Select(m => m.Mesh))).Mesh;

    private static double[] Areas(TriMesh mesh, double[] heights)
        => MeshSections.At(mesh, heights, new SectionOptions { GapMm = 10 }).Value!.Select(s => ContourMeasure.NonZero(s.Loops).Area).ToArray();

    private static Dictionary<double, double> Volumes(string file)
    {
        var volumes = new Dictionary<double, double>();
        foreach (var move in GCodeDecoder.DecodeFile(file, new DecodeOptions { FilamentDiameter = 1.75 }).Value!.Toolpath.Moves())
        {
            if (move.Kind != MoveKind.Print) continue;
            var z = Math.Round(move.End.Z, 3);
            volumes[z] = volumes.GetValueOrDefault(z) + move.Deposited;
        }
        return volumes;
    }

    private static string Described(List<(double Z, double Share)> lost)
        => lost.Count == 0 ? "no layer below 90 %"
            : $"{Text(lost.Count)} layers below 90 %, z {Text(lost[0].Z, 1)} to {Text(lost[^1].Z, 1)}, least {Text(100 * lost.Min(l => l.Share), 0)} %";

    private static string Text(double value, int decimals = 0) => value.ToString("F" + decimals, CultureInfo.InvariantCulture);
}

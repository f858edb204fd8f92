using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GCode;
using Caterpillar.Tests.Slicing;
using Caterpillar.Toolpaths;

namespace Caterpillar.Bench;

/// <summary>
/// <c>coverage MODEL FILE.gcode...</c>: the beads of sampled layers of solid prints, painted on pixels of 0.02 mm and compared with the model's own section,
/// whatever program wrote the files. A bead covers its area over the thickness of the layer, so that the beads of a full layer touch.
/// </summary>
internal static class Coverage
{
    private const double Pixel = 0.02;
    private const double Thickness = 0.2;

    // What the round sides of the outermost beads leave open of the section, mm; less than a pixel more or less.
    private const double Edge = 0.02;

    private static readonly double[] Samples = [0.21, 0.47, 0.83];

    public static void Run(string[] arguments)
    {
        var mesh = TriMesh.Merge(MeshReader.Read(arguments[0]).Value!.Select(m => m.Mesh).ToArray());
        var layers = Array.ConvertAll(Samples, s => (int)Math.Round(s * mesh.Bounds.Size.Z / Thickness));
        var heights = Array.ConvertAll(layers, l => mesh.Bounds.Min.Z + (l + 0.5) * Thickness);
        var sections = MeshSections.At(mesh, heights).Value!;
        foreach (var file in arguments[1..])
        {
            var toolpath = GCodeDecoder.DecodeFile(file, new DecodeOptions { FilamentDiameter = 1.75 }).Value!.Toolpath;
            var sums = new double[5];
            for (var i = 0; i < layers.Length; i++) Measure(toolpath, Region.From(sections[i].Loops), (layers[i] + 1) * Thickness, sums);
            var (area, off) = (Text(sums[0]), Text(sums[4]));
            var share = Array.ConvertAll(sums, s => Text(100 * s / sums[0]).PadLeft(5));
            var line = $"area {area,8} mm², open {share[1]} %, double {share[2]} %, outside {share[3]} %, center line outside {off} mm";
            Console.WriteLine($"{Path.GetFileName(file),-32} {line}");
        }
    }

    private static void Measure(Toolpath toolpath, Region section, double z, double[] sums)
    {
        var paths = Paths(toolpath, z);
        if (paths.Count == 0 || section.IsEmpty) return;
        // Every program puts the model at its own place of the bed.
        var box = Bounds.Empty;
        foreach (var (points, _) in paths) box = points.Aggregate(box, (b, p) => b.Include(p));
        var shift = section.Bounds.Center - box.Center;
        var raster = new BeadRaster(section.Bounds, Pixel);
        var reach = section.Offset(0.005);
        foreach (var (points, spacings) in paths)
        {
            for (var i = 0; i < points.Count; i++) points[i] = new Vec3(points[i].X + shift.X, points[i].Y + shift.Y);
            raster.Add(points, spacings, closed: false);
            for (var i = 1; i < points.Count; i++)
            {
                var middle = (points[i] + points[i - 1]) * 0.5;
                if (!reach.Contains(middle.X, middle.Y)) sums[4] += points[i].DistanceTo(points[i - 1]);
            }
        }
        var (area, open, twice, _) = raster.Measure(section.Offset(-Edge));
        sums[0] += area;
        sums[1] += open;
        sums[2] += twice;
        sums[3] += raster.Measure(section).Outside;
    }

    private static string Text(double value) => value.ToString("F2", CultureInfo.InvariantCulture);

    // Points at most a millimeter apart, and what the bead covers there.
    private static List<(List<Vec3> Points, List<double> Spacings)> Paths(Toolpath toolpath, double z)
    {
        var paths = new List<(List<Vec3> Points, List<double> Spacings)>();
        var open = false;
        foreach (var move in toolpath.Moves())
        {
            var printed = move.Kind == MoveKind.Print && Math.Abs(move.End.Z - z) < 0.02 && move.Length > 0;
            if (!printed)
            {
                open = false;
                continue;
            }
            var spacing = toolpath.VolumeOf(move)!.Value / move.Length / Thickness;
            if (!open) paths.Add(([], []));
            open = true;
            var (points, spacings) = paths[^1];
            var pieces = (int)Math.Ceiling(move.Length);
            for (var i = 0; i <= pieces; i++)
            {
                points.Add(Vec3.Lerp(move.Start, move.End, (double)i / pieces).WithZ(0));
                spacings.Add(spacing);
            }
        }
        return paths;
    }
}

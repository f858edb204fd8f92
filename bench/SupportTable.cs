using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Simulation;
using Caterpillar.Slicing;
using Caterpillar.Tests.Geometry.Meshes;
using Caterpillar.Toolpaths;

namespace Caterpillar.Bench;

/// <summary>
/// What supports cost, touch and hold, as made by Caterpillar and by the slicers that are installed: the settings of <see cref="PrintTimes"/>, supports
/// from 50° on, 15 % dense, two dense layers at the top, with a gap to the part of 0.6 mm sideways and 0.2 mm in height.
/// </summary>
internal static class SupportTable
{
    private const double Angle = 50;

    // mm; a bead holds what is no higher above it and no farther aside, and touches a layer if only the gap lies between them.
    private const double HeldAbove = 1;
    private const double HeldAside = 1;
    private const double TouchedAbove = 0.3;
    private const double TouchedAside = 0.225;
    private const double Thickness = 0.2;

    // mm² for each sample, and mm from the surface where another body may cover it.
    private const double SampleArea = 0.05;
    private const double Outside = 0.15;
    // Of whole meshes: where layers are lost, there is nothing to hold.
    private static readonly string[] Files = ["spot.obj", "homer.stl", "ogre_bodies.ply", "igea.ply", "cheburashka.ply", "torus.obj"];

    private static readonly PrintSettings Settings = PrintTimes.Settings with
    {
        SupportAngle = Angle, SupportDensityPercent = 15, SupportInterfaceLayers = 2, SupportXyGap = 0.6, SupportTopGap = 0.2, SupportBottomGap = 0.2,
        SupportSpeed = 60, MaxAreaLossPercent = 100, MaxBridgeLength = 0, SupportRemoveSmallOverhang = false,
    };

    /// <summary>A table in Markdown for the meshes of a folder and some of its own.</summary>
    /// <param name="folder">Of the meshes.</param>
    /// <param name="only">Names of meshes and programs; none = all.</param>
    public static void Run(string folder, string[] only)
    {
        Console.WriteLine("| mesh | program | supports | time | filament | retractions | touched | held |");
        Console.WriteLine("|---|---|---|---|---|---|---|---|");
        var temporary = Directory.CreateTempSubdirectory("supports").FullName;
        bool IsAsked(string name, string[] of) => !only.Any(of.Contains) || only.Contains(name);
        string[] programs = ["Caterpillar", "PrusaSlicer", "CuraEngine"];
        var shapes = SupportShapes.All().ToDictionary(s => s.Name, s => s.Mesh);
        var names = Files.Concat(shapes.Keys).ToArray();
        foreach (var name in names.Where(n => IsAsked(n, names)))
        {
            var meshes = shapes.TryGetValue(name, out var shape) ? [new NamedMesh(name, shape)] : MeshReader.Read(Path.Combine(folder, name)).Value!;
            var models = ModelPlacement.OnBed(meshes, PrintTimes.Printer.BuildBounds.Center);
            var mesh = TriMesh.Merge(models.Select(m => m.Mesh).ToArray());
            var stl = Path.Combine(temporary, "model.stl");
            File.WriteAllBytes(stl, StlWriter.ToBytes(mesh));
            var samples = Samples(mesh);
            Toolpath? Peer(Func<string, ProcessStartInfo> command)
            {
                var output = Path.Combine(temporary, "peer.gcode");
                File.Delete(output);
                return PrintTimes.Peer(output, command(output));
            }
            void Row(string program, string supports, Toolpath? toolpath)
            {
                if (toolpath is not null) Console.WriteLine($"| {name} | {program} | {supports} | {Measure(toolpath, samples)} |");
            }
            foreach (var kind in IsAsked(programs[0], programs) ? new[] { SupportKind.None, SupportKind.Grid, SupportKind.Tree } : [])
            {
                var settings = Settings with { Support = kind };
                var setup = new PrintSetup { Printer = PrintTimes.Printer, Settings = settings };
                Row(programs[0], kind.ToString().ToLowerInvariant(), Planner.Plan(PlanarSlicer.Slice(models, settings).Value!.ToSteps(), setup).Value!);
            }
            if (IsAsked(programs[1], programs))
            {
                const string Supports = "--support-material --support-material-threshold 40 --support-material-spacing 2.6 --support-material-xy-spacing 0.6"
                    + " --support-material-interface-layers 2 --support-material-interface-spacing 0.15 --dont-support-bridges=0 --support-material-style ";
                Row(programs[1], "none", Peer(o => PrintTimes.Prusa(stl, o)));
                Row(programs[1], "grid", Peer(o => PrintTimes.Prusa(stl, o, Supports + "grid")));
                Row(programs[1], "snug", Peer(o => PrintTimes.Prusa(stl, o, Supports + "snug")));
            }
            if (!IsAsked(programs[2], programs)) continue;
            string[] common =
            [
                "support_enable=true", "support_type=everywhere", "support_angle=50", "support_pattern=lines", "support_infill_rate=15", "speed_support=60",
                "support_line_distance=3", "support_xy_distance=0.6", "support_z_distance=0.2", "support_top_distance=0.2", "support_bottom_distance=0.2",
                "support_interface_enable=true", "support_roof_enable=true", "support_bottom_enable=false", "support_roof_height=0.4",
                "support_line_width=0.45",
                "support_roof_line_width=0.45", "support_roof_line_distance=0.6", "support_interface_pattern=lines", "speed_support_infill=60",
                "speed_support_roof=60", "support_roof_pattern=lines",
            ];
            Row(programs[2], "none", Peer(o => PrintTimes.Cura(stl, o, "support_enable=false")));
            Row(programs[2], "grid", Peer(o => PrintTimes.Cura(stl, o, common)));
            Row(programs[2], "tree", Peer(o => PrintTimes.Cura(stl, o, [.. common, "support_structure=tree", "support_wall_count=1",
                "support_tree_enable=true", "support_tree_collision_resolution=0.2", "support_infill_rate=0", "support_line_distance=0"])));
        }
        Directory.Delete(temporary, recursive: true);
    }

    private readonly record struct Sample(Vec3 Place, double Area, bool Hangs, bool IsBelow);

    // Of the surface where it is not upright and no other body covers it.
    private static List<Sample> Samples(TriMesh mesh)
    {
        const double Section = 0.1;
        var count = (int)(mesh.Bounds.Max.Z / Section) + 1;
        var heights = Enumerable.Range(0, count).Select(i => (i + 0.5) * Section).ToArray();
        var sections = MeshSections.At(mesh, heights).Value!
            .Select(s => Region.From(s.Loops)).ToArray();
        var samples = new List<Sample>();
        for (var t = 0; t < mesh.Indices.Count; t += 3)
        {
            Vec3 a = mesh.Vertices[mesh.Indices[t]], b = mesh.Vertices[mesh.Indices[t + 1]], c = mesh.Vertices[mesh.Indices[t + 2]];
            var cross = Vec3.Cross(b - a, c - a);
            var area = cross.Length / 2;
            if (!(area > 0)) continue;
            var normal = cross / cross.Length;
            if (Math.Abs(normal.Z) < 0.2) continue;
            var number = (int)Math.Ceiling(area / SampleArea);
            for (var k = 0; k < number; k++)
            {
                double u = (0.5 + 0.7548776662466927 * k) % 1, v = (0.5 + 0.5698402909980532 * k) % 1;
                if (u + v > 1) (u, v) = (1 - u, 1 - v);
                var place = a + (b - a) * u + (c - a) * v;
                var beside = place + normal * Outside;
                var at = (int)(beside.Z / Section);
                if (place.Z < 2 * Thickness || (at >= 0 && at < count && sections[at].Contains(beside.X, beside.Y))) continue;
                samples.Add(new Sample(place, area / number, normal.Z < -Basics.Angle.Sin(Angle), normal.Z < 0));
            }
        }
        return samples;
    }

    private static string Measure(Toolpath toolpath, List<Sample> samples)
    {
        var statistics = PrintStatistics.Of(Timeline.Of(toolpath, new PrintSetup { Printer = PrintTimes.Printer }));
        var beads = new Dictionary<(int X, int Y), List<Move>>();
        foreach (var move in toolpath.Moves())
        {
            if (move.Kind != MoveKind.Print || move.Role is not (Role.Support or Role.SupportInterface)) continue;
            double Low(double p, double q) => Math.Min(p, q) - HeldAside;
            double High(double p, double q) => Math.Max(p, q) + HeldAside;
            for (var x = (int)Low(move.Start.X, move.End.X); x <= (int)High(move.Start.X, move.End.X); x++)
            {
                for (var y = (int)Low(move.Start.Y, move.End.Y); y <= (int)High(move.Start.Y, move.End.Y); y++)
                {
                    if (!beads.TryGetValue((x, y), out var list)) beads.Add((x, y), list = []);
                    list.Add(move);
                }
            }
        }
        double touched = 0, held = 0, hanging = 0;
        foreach (var sample in samples)
        {
            if (sample.Hangs) hanging += sample.Area;
            if (!beads.TryGetValue(((int)sample.Place.X, (int)sample.Place.Y), out var near)) continue;
            // From the top of beads below, to the bottom of beads above.
            bool Reaches(Move bead, double z, double above, double aside)
            {
                var gap = sample.IsBelow ? z - bead.End.Z : bead.End.Z - Thickness - z;
                return gap > -Thickness && gap <= above && Distance(sample.Place, bead) <= aside;
            }
            if (sample.Hangs && near.Exists(b => Reaches(b, sample.Place.Z, HeldAbove, HeldAside))) held += sample.Area;
            // The layer that prints this place begins and ends here.
            var layers = sample.Place.Z / Thickness;
            var edge = (sample.IsBelow ? Math.Floor(layers + 1e-6) : Math.Ceiling(layers - 1e-6)) * Thickness;
            if (near.Exists(b => Reaches(b, edge, TouchedAbove, TouchedAside))) touched += sample.Area;
        }
        return string.Create(CultureInfo.InvariantCulture,
            $"{statistics.Duration:0} s | {statistics.Filament / 1000:0.00} m | {statistics.Retractions} | {touched:0} mm² | {100 * held / hanging:0.0} %");
    }

    private static double Distance(Vec3 p, Move move)
    {
        var (a, along) = (move.Start, (move.End - move.Start).WithZ(0));
        var square = along.LengthSquared;
        var t = square > 0 ? Math.Max(0, Math.Min(1, Vec3.Dot((p - a).WithZ(0), along) / square)) : 0;
        return (p - a - along * t).LengthXY;
    }
}

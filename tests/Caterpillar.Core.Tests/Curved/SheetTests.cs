using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>Surfaces printed as single walls along the level curves of a field on their mesh.</summary>
public class SheetTests
{
    private static readonly string[] Keys =
        ["open_contours=surface", "layer_height_mm=0.2", "first_layer_height_mm=0.2", "skirt_loops=0", "min_layer_time_s=0"];

    private static readonly PrintSetup Setup = new ProfileLibrary().Setup("generic", values: Keys).OrThrow();
    private static readonly double Least = LayerRules.LeastGap(Setup), Most = LayerRules.GreatestGap(Setup);

    // From ring to ring: where a surface is at a share of its length and an angle in degrees. With less than a full turn it is open on one side.
    private static TriMesh Tube(Func<double, double, Vec3> at, int rings = 20, int sides = 72, double turn = 360)
    {
        var row = turn < 360 ? sides + 1 : sides;
        var points = new List<Vec3>();
        var corners = new List<int>();
        for (var i = 0; i <= rings; i++)
        {
            for (var k = 0; k < row; k++) points.Add(at((double)i / rings, turn * k / sides));
        }
        for (var i = 0; i < rings; i++)
        {
            for (var k = 0; k < sides; k++)
            {
                int a = i * row + k, b = i * row + (k + 1) % row;
                corners.AddRange([a, b, b + row, a, b + row, a + row]);
            }
        }
        return TriMesh.Create(points, corners);
    }

    private static Vec3 Round(double radius, double angle, double z) => new Vec3(100 + radius * Angle.Cos(angle), 100 + radius * Angle.Sin(angle), z);

    // Flares out by 45 degrees.
    private static TriMesh Cone() => Tube((share, angle) => Round(6 + 10 * share, angle, 10 * share));

    // Turns over outside: its last quarter descends.
    private static TriMesh Cap() => Tube((share, angle) => Round(14 - 8 * Angle.Cos(135 * share), angle, 8 * Angle.Sin(135 * share)), 40);

    // A stem whose end turns over outside, high enough for a head that leans down.
    private static TriMesh Flower() => Tube((share, angle) => share < 0.7 ? Round(3, angle, 35 * share)
        : Round(6 - 3 * Angle.Cos(400 * (share - 0.7)), angle, 24.5 + 3 * Angle.Sin(400 * (share - 0.7))), 50, 24);

    // Ends in a slanted rim: walls are far apart on one side.
    private static TriMesh Slanted(double rise) => Tube((share, angle) => Round(10, angle, share * (12 + rise * Angle.Cos(angle))));

    private static Result<CurvedResult> Try(TriMesh mesh, double maxTilt = 0, PrintSetup? setup = null)
        => CurvedSlicer.Slice([new NamedMesh("sheet", mesh)], LayerField.Harmonic(MeshBoundaries.Find(mesh).OrThrow()), setup ?? Setup,
            new CurvedOptions { MaxTilt = maxTilt });

    private static PrintPath[] Paths(CurvedResult result) => result.Layers.SelectMany(l => l.Steps).Select(s => s.Path).ToArray();

    [Test]
    public void Walls_that_take_less_than_the_layer_time_at_the_slowest_are_noted()
    {
        var tube = Tube((share, angle) => Round(4, angle, 2 * share));
        Assert.That(Try(tube).Diagnostics.Select(d => d.Code), Has.None.EqualTo("slice.layer_time"));
        var slow = Try(tube, 0, Setup with { Settings = Setup.Settings with { MinLayerTime = 60 } });
        Assert.That(slow.Diagnostics.Single(d => d.Code == "slice.layer_time").Count, Is.EqualTo(slow.Value!.Layers.Count));
        Assert.That(Paths(slow.Value).Select(p => p.BeadOf(0).Speed), Is.All.EqualTo(Setup.Settings.MinPrintSpeed).Within(1e-9));
    }

    [Test]
    public void Progress_of_a_sheet_rises_wall_by_wall()
    {
        var tube = Tube((share, angle) => Round(4, angle, 2 * share));
        var told = new List<double>();
        CurvedSlicer.Slice([new NamedMesh("sheet", tube)], LayerField.Harmonic(MeshBoundaries.Find(tube).OrThrow()), Setup, progress: new Told(told)).OrThrow();
        Assert.That(told, Is.Ordered.And.All.InRange(0, 1));
        Assert.That(told, Has.Count.GreaterThanOrEqualTo(10), "Ten walls.");
    }

    private sealed class Told(List<double> shares) : IProgress<double>
    {
        public void Report(double value) => shares.Add(value);
    }

    // What the walls cover of the surface.
    private static double Covered(IEnumerable<PrintPath> paths)
        => paths.Sum(p => Enumerable.Range(0, p.SegmentCount).Sum(i => p.LengthOf(i) * p.BeadOf(i).Height));

    private static double Area(TriMesh mesh) => Enumerable.Range(0, mesh.TriangleCount).Sum(t =>
    {
        var (a, b, c) = mesh.Triangle(t);
        return Vec3.Cross(mesh.Vertices[b] - mesh.Vertices[a], mesh.Vertices[c] - mesh.Vertices[a]).Length / 2;
    });

    [Test]
    public void A_tube_is_one_wall_on_its_mesh_layer_by_layer()
    {
        var tube = Tube((share, angle) => Round(10, angle, 4 * share));
        var paths = Paths(Try(tube).OrThrow());
        Assert.That(paths, Has.Length.EqualTo(20));
        var bead = SliceRules.Of(Setup.Settings, 0.2).Bead(WallRules.Of(Setup.Settings, 0.2).OuterWidth);
        for (var i = 0; i < paths.Length; i++)
        {
            Assert.That(paths[i].IsClosed, Is.True);
            Assert.That(paths[i].Points.Select(p => p.Z), Is.All.EqualTo(0.2 * (i + 1)).Within(1e-3));
            Assert.That(paths[i].Points.Select(p => new Vec3(p.X - 100, p.Y - 100).Length), Is.All.InRange(9.98, 10.001));
            Assert.That(paths[i].BeadOf(0).Height, Is.EqualTo(0.2).Within(1e-3));
            Assert.That(paths[i].BeadOf(0).Area, Is.EqualTo(bead.Area).Within(1).Percent);
            Assert.That((paths[i].Role, paths[i].Layer!.Index), Is.EqualTo((Role.OuterWall, i)));
        }
    }

    [Test]
    public void Heights_of_walls_are_measured_along_the_surface()
    {
        var result = Try(Cone()).OrThrow();
        var last = 0.0;
        foreach (var path in Paths(result))
        {
            var z = path.Points.Average(p => p.Z);
            Assert.That(path.BeadOf(0).Height, Is.EqualTo((z - last) * Math.Sqrt(2)).Within(3).Percent, $"at {z}");
            last = z;
        }
        Assert.That(result.Field.Normal(Round(11, 30, 5)).DistanceTo((Round(1, 30, 1) - new Vec3(100, 100)).Unit()), Is.LessThan(0.05), "Along the surface.");
    }

    [TestCase(0)]
    [TestCase(4)]
    [TestCase(8)]
    [TestCase(10)]
    public void Walls_cover_the_surface_once_and_keep_their_limits(double rise)
    {
        var sheet = Slanted(rise);
        var paths = Paths(Try(sheet, 60).OrThrow());
        Assert.That(Covered(paths), Is.EqualTo(Area(sheet)).Within(1.5).Percent);
        var heights = paths.SelectMany(p => Enumerable.Range(0, p.SegmentCount).Select(i => p.BeadOf(i).Height)).ToArray();
        Assert.That(heights.Min(), Is.GreaterThan(0.95 * Least));
        Assert.That(heights.Max(), Is.LessThan(1.05 * Most));
        Assert.That(paths.All(p => p.IsClosed), Is.EqualTo(rise < 8), "Where walls come too close, only some are printed.");
    }

    [Test]
    public void The_height_of_a_wall_is_its_distance_from_the_one_below()
    {
        var paths = Paths(Try(Slanted(8), 60).OrThrow());
        var random = new Random(5);
        for (var n = 0; n < 300; n++)
        {
            var at = random.Next(20, paths.Length);
            var path = paths[at];
            var i = random.Next(path.SegmentCount);
            if (path.LengthOf(i) < 0.2) continue;
            var middle = Vec3.Lerp(path.Points[i], path.EndOf(i), 0.5);
            var below = paths.Take(at).Reverse().Take(60)
                .Min(p => Enumerable.Range(0, p.SegmentCount).Min(k => middle.DistanceToSegment(p.Points[k], p.EndOf(k))));
            Assert.That(path.BeadOf(i).Height, Is.EqualTo(below).Within(8).Percent.Or.EqualTo(below).Within(0.015), $"path {at} at {middle}");
        }
    }

    [Test]
    public void Walls_between_two_walls_of_an_open_surface_do_not_cross_their_gap()
    {
        // Half of a tube, high at both ends and low in the middle, where only every few walls are printed.
        var sheet = Tube((share, angle) => Round(10, angle, share * (9 + 6 * Angle.Cos(2 * angle))), sides: 36, turn: 180);
        int[] Row(int ring) => [.. Enumerable.Range(37 * ring, 37)];
        var ends = MeshBoundaries.Near(sheet, BoundaryShape.Of(Row(0)), [BoundaryShape.Of(Row(20))], 0).OrThrow();
        var paths = Paths(CurvedSlicer.Slice([new NamedMesh("sheet", sheet)], LayerField.Harmonic(ends), Setup, new CurvedOptions { MaxTilt = 70 }).OrThrow());
        Assert.That(paths.SelectMany(p => Enumerable.Range(0, p.SegmentCount).Select(p.LengthOf)).Max(), Is.LessThan(5));
        Assert.That(Covered(paths), Is.EqualTo(Area(sheet)).Within(1.5).Percent);
    }

    [Test]
    public void Walls_that_turn_over_need_a_tool_that_tilts()
    {
        var refused = Try(Cap()).Diagnostics.Single(d => d.Severity == Severity.Error);
        Assert.That(refused.Code, Is.EqualTo("curved.overhanging_layers"));
        Assert.That(refused.Message, Does.StartWith("Layers overhang or fold back on 47.8 % of the surface").And.Contain("rotary axes"));
        Assert.That(Try(Cap(), 30).Diagnostics.Select(d => d.Message), Has.Some.Contain("--max-tilt"));
        Assert.That(Covered(Paths(Try(Cap(), 90).OrThrow())), Is.EqualTo(Area(Cap())).Within(1.5).Percent);
    }

    [Test]
    public void The_second_of_two_surfaces_is_looked_at_too()
    {
        var (tube, cap) = (Tube((share, angle) => Round(4, angle, 3 * share)), Cap().Moved(new Vec3(40, 0)));
        var both = LayerField.Harmonic(MeshBoundaries.Find(TriMesh.Merge([tube, cap])).OrThrow());
        var found = CurvedSlicer.Slice([new NamedMesh("tube", tube), new NamedMesh("cap", cap)], both, Setup).Diagnostics;
        Assert.That(found.Where(d => d.Severity == Severity.Error).Select(d => d.Code), Does.Contain("curved.overhanging_layers"));
    }

    [Test]
    public void A_surface_that_turns_over_is_written_for_a_tilting_head_without_a_finding()
    {
        var setup = new ProfileLibrary().Setup("five_axis_head", values: [.. Keys, "layer_height_mm=0.3", "brim_width_mm=3"]).OrThrow();
        var flower = Flower();
        var options = new PrintJobOptions { Tilt = new ToolAim() };
        var field = LayerField.Harmonic(MeshBoundaries.Find(flower).OrThrow());
        using var job = PrintJob.Slice([new SliceModel(new NamedMesh("flower", flower), setup.Settings)], field, setup, options).OrThrow();
        var written = job.Write(System.IO.Stream.Null, "flower.gcode");
        Assert.That(written.Diagnostics.Where(f => f.Severity != Severity.Note).Select(f => f.Message), Is.Empty);
        var kinematics = setup.Printer.Kinematics!;
        Assert.That(Enumerable.Range(0, job.Toolpath.Count).Min(i => kinematics.Direction(job.Toolpath.WordsAt(i)).Z), Is.LessThan(0.2));
    }

    [Test]
    public void Copies_have_the_same_walls_beside_each_other()
    {
        var cone = Cone();
        var shift = new Vec3(40, 10);
        NamedMesh[] copies = [new("a", cone), new NamedMesh("b", cone).Transformed(Affine.Move(shift))];
        var field = LayerField.Harmonic(MeshBoundaries.Find(cone).OrThrow()).ForCopies(copies);
        var layers = CurvedSlicer.Slice(copies, field, Setup).OrThrow().Layers;
        var (first, second) = (Of("a"), Of("b"));
        Assert.That(first, Has.Length.EqualTo(second.Length).And.Length.GreaterThan(50));
        for (var i = 0; i < first.Length; i++)
            Assert.That(second[i].Points.Zip(first[i].Points, (q, p) => q.DistanceTo(p + shift)), Is.All.LessThan(1e-9));
        Assert.That(layers.Select(l => l.Steps[0].Group!.Value.Layer), Is.EqualTo(Enumerable.Range(0, layers.Count)));

        PrintPath[] Of(string name) => layers.Where(l => l.Layer.Object == name).Select(l => l.Steps.Single().Path).ToArray();
    }

    [Test]
    public void Models_of_a_field_that_was_made_for_all_of_them_have_their_own_walls()
    {
        var (cone, tube) = (Cone(), Tube((share, angle) => Round(10, angle, 10 * share)).Moved(new Vec3(40, 0)));
        var both = LayerField.Harmonic(MeshBoundaries.Find(TriMesh.Merge([cone, tube])).OrThrow());
        var layers = CurvedSlicer.Slice([new NamedMesh("cone", cone), new NamedMesh("tube", tube)], both, Setup).OrThrow().Layers;
        var covered = layers.GroupBy(l => l.Layer.Object).ToDictionary(g => g.Key, g => Covered(g.SelectMany(l => l.Steps).Select(s => s.Path)));
        Assert.That(covered["cone"], Is.EqualTo(Area(cone)).Within(1.5).Percent);
        Assert.That(covered["tube"], Is.EqualTo(Area(tube)).Within(1.5).Percent);
    }

    [Test]
    public void A_closed_part_with_vertices_inside_its_flat_ends_is_one_wall_around_it()
    {
        var part = CurvedSolids.Between(new Bounds(new Vec3(90, 90), new Vec3(110, 102)), 10, (_, _) => 0, (_, _) => 3);
        var paths = Paths(Try(part).OrThrow());
        Assert.That(paths, Has.Length.EqualTo(15));
        Assert.That(Covered(paths), Is.EqualTo(64 * 3).Within(1).Percent);
        Assert.That(Try(part).Value!.Field.Normal(new Vec3(100, 96, 0)).IsFinite, Is.True);
    }

    [Test]
    public void Walls_below_the_bed_are_left_out_and_told()
    {
        var result = Try(Tube((share, angle) => Round(10, angle, 4 * share - 1)));
        Assert.That(result.Diagnostics.Select(d => d.Code), Does.Contain("curved.below_surface"));
        Assert.That(Paths(result.Value!).SelectMany(p => p.Points).Min(p => p.Z), Is.InRange(0, 0.2));
    }

    [TestCase(0, true)]
    [TestCase(0.2, false)]
    public void A_skirt_goes_around_a_surface_that_begins_level(double tilt, bool expected)
    {
        var tube = Tube((share, angle) => Round(5, angle, share * 2 + (1 - share) * tilt * (1 + Angle.Cos(angle))), 2, 24);
        var layers = Try(tube, 0, Setup with { Settings = Setup.Settings with { SkirtLoops = 1 } }).OrThrow().Layers;
        Assert.That(layers[0].Steps[0].Path.Role == Role.Skirt, Is.EqualTo(expected));
    }

    [Test]
    public void Walls_that_are_too_steep_for_an_upright_head_are_refused()
    {
        var slanted = Slanted(10);
        var steep = Try(slanted).Diagnostics.Single(d => d.Severity == Severity.Error);
        Assert.That(steep.Code, Is.EqualTo("curved.too_steep"));
        Assert.That(Try(slanted, setup: Setup with { Settings = Setup.Settings with { CurvedMaxSlope = 60 } }).Value, Is.Not.Null);
    }

    // Its layers and the 5 m of its walls count alike.
    [Test]
    public void Without_enough_memory_a_surface_is_refused_before_it_is_traced()
    {
        var cone = Cone();
        var refused = CurvedSlicer.Slice([new NamedMesh("sheet", cone)], LayerField.Harmonic(MeshBoundaries.Find(cone).OrThrow()), Setup,
            new CurvedOptions { Memory = new MemoryLimit(600_000) });
        Assert.That(refused.Diagnostics.Select(d => d.Code), Does.Contain(MemoryLimit.Code));
    }
}

using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Files;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Tests.Geometry.Meshes;
using Caterpillar.Tests.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>Fields, plans and boundaries in closed form.</summary>
[Category("Arithmetic")]
public class FieldDetailTests
{
    // A plan that is 2 mm high at x = 0 and 3 mm at x = 10, which is the level of its own layer; layers bend from 1 to 3 mm.
    [TestCase(0, 0.5, 0.5, 1, 0)]
    [TestCase(0, 1, 1, 1, 0)]
    [TestCase(0, 2, 1.5, 0.5, 0.05)]
    [TestCase(0, 3, 2, 1, 0.1)]
    [TestCase(0, 3.5, 2.5, 1, 0.1)]
    [TestCase(0, 5, 4, 1, 0.1)]
    [TestCase(10, 2, 2, 1, 0.05)]
    [TestCase(20, 2, 2.5, 1.5, 0.05)]
    [TestCase(20, 3.5, 4.5, 1, 0.1)]
    public void Layers_blend_from_level_to_parallel_with_the_plan(double x, double value, double height, double spread, double slope)
    {
        var field = new VerticalField(PlanSurface.Of((u, _) => 2 + 0.1 * u), new LayerBlend(1, 3), 3);
        Assert.That(field.Height(x, 7, value), Is.EqualTo(height).Within(1e-9));
        Assert.That(field.Value(new Vec3(x, 7, height)), Is.EqualTo(value).Within(1e-9));
        Assert.That(field.Spread(new Vec3(x, 7, height)), Is.EqualTo(spread).Within(1e-9));
        var normal = field.Normal(new Vec3(x, 7, height));
        Assert.That((normal.X / normal.Z, normal.Y), Is.EqualTo((-slope, 0.0)).Within(1e-6));
        var (first, second) = field.Heights(x, 7, value, 8);
        Assert.That((first, second), Is.EqualTo((height, 7 + 0.1 * x)).Within(1e-9));
    }

    [Test]
    public void A_field_starts_level_with_a_level_plan_or_a_blend()
    {
        var slope = PlanSurface.Of((x, _) => 0.1 * x);
        Assert.That(new VerticalField(slope, null).StartsLevel, Is.False);
        Assert.That(new VerticalField(slope, new LayerBlend(1, 3)).StartsLevel && new VerticalField(PlanSurface.Level(1), null).StartsLevel, Is.True);
    }

    [TestCase(1, 0.5, 2)]
    [TestCase(2, 1, 2)]
    [TestCase(4, 1.5, 4)]
    [TestCase(6, 2, 4)]
    [TestCase(10, 3, 4)]
    [TestCase(-1, -0.5, 2)]
    public void Between_surfaces_layers_are_spread_evenly(double z, double value, double spread)
    {
        var field = new BetweenField([PlanSurface.Level(0), PlanSurface.Of((x, _) => 2 + 0.1 * x), PlanSurface.Level(6)]);
        Assert.That((field.Value(new Vec3(0, 3, z)), field.Height(0, 3, value), field.Spread(new Vec3(0, 3, z))), Is.EqualTo((value, z, spread)).Within(1e-9));
        var shifted = new ShiftedField(field, 0.3);
        Assert.That((shifted.Value(new Vec3(0, 3, z)), shifted.Height(0, 3, value + 0.3)), Is.EqualTo((value + 0.3, z)).Within(1e-9));
        Assert.That(shifted.Creases, Is.EqualTo(new[] { 0.3, 1.3, 2.3 }).Within(1e-9));
        // Between the lowest and the middle surface, layers have a part of its slope; from there on less again.
        var normal = field.Normal(new Vec3(0, 3, z));
        Assert.That(-normal.X / normal.Z, Is.EqualTo(0.1 * (value <= 1 ? value : 2 - value)).Within(1e-6));
    }

    [Test]
    public void A_height_map_covers_its_rectangle_with_its_edges()
    {
        var plan = PlanSurface.HeightMap(new GrayImage(2, 2, [0, 1, 0, 1]), new Bounds(new Vec3(1, 2, 3), new Vec3(11, 22, 5)));
        bool[] Covered(params double[] places) => [.. Enumerable.Range(0, places.Length / 2).Select(i => plan.Covers(places[2 * i], places[2 * i + 1]))];
        Assert.That(Covered(1, 2, 11, 22, 5, 5, 1 - 5e-7, 2 - 5e-7, 11 + 5e-7, 22 + 5e-7), Is.All.True);
        Assert.That(Covered(0.999, 5, 11.001, 5, 5, 1.999, 5, 22.001), Is.All.False);
        Assert.That((plan.Height(-9, 5), plan.Height(99, 5), plan.Detail), Is.EqualTo((3.0, 5.0, 5.0)).Within(1e-9));
    }

    // Points at 0, 1 and 10 mm on a slope of 2: the widest cone between the last two is 8 mm for 18 mm, for a tip of 1 mm.
    [TestCase(63.434949, 1, 8, 18)]
    [TestCase(63.434949, 2.9, 6.1, 18)]
    [TestCase(63.434949, 3.2, 6.8, 20)]
    [TestCase(63.434949, 3.5, 1, 2)]
    [TestCase(46, 1, 8, 18)]
    [TestCase(45, 1, 1, 1)]
    public void A_head_has_to_be_within_the_angle_to_what_is_higher_in_its_layer(double slope, double tip, double aside, double up)
    {
        PathStep Path(double rise) => new(new PrintPath([new(0, 0, 0), new(1, 0, rise), new(10, 0, 10 * rise)], new Bead(0.1, 0.2)));
        Assert.That(HeadSlope.HalfAngle(slope, [[Path(0)], [Path(2)], [Path(0)]], tip), Is.EqualTo(Angle.Atan2(aside, up)).Within(1e-6));
    }

    [Test]
    public void Drawn_travels_follow_a_surface_with_its_detail_and_keep_their_speed()
    {
        var travel = new TravelStep([new Vec3(0, 0, 1), new Vec3(10, 0, 1)], 77);
        TravelStep Project(PlanSurface onto, double squeeze)
            => (TravelStep)SurfaceProjection.Project([travel], onto, new PrintSetup(), squeeze).OrThrow().Single();
        var over = Project(PlanSurface.Of((x, _) => Math.Abs(x - 5), 1), 0.25);
        Assert.That(over.Points.Select(p => p.X), Is.EqualTo(Enumerable.Range(0, 12).Select(k => k * 10 / 11.0)).Within(1e-9));
        foreach (var p in over.Points) Assert.That(p.Z, Is.EqualTo(Math.Abs(p.X - 5) + 0.75).Within(1e-9));
        Assert.That(over.Speed, Is.EqualTo(77));
        Assert.That(Project(PlanSurface.Level(3), 0).Points, Is.EqualTo(new[] { new Vec3(0, 0, 4), new Vec3(10, 0, 4) }));
    }

    [TestCase(-0.1)]
    [TestCase(double.NaN)]
    [TestCase(double.PositiveInfinity)]
    public void A_squeeze_is_a_length(double squeeze)
        => Assert.That(() => SurfaceProjection.Project([], PlanSurface.Level(3), new PrintSetup(), squeeze), Throws.InstanceOf<ArgumentOutOfRangeException>());

    [Test]
    public void An_arc_on_a_tilted_surface_becomes_chords_within_the_tolerance()
    {
        var half = new PrintPath([new(10, 0, 0.2), new(-10, 0, 0.2)], [Bead.FromWidth(0.4, 0.2)], arcs: [new Arc(Vec3.Zero, 180)]);
        var setup = new PrintSetup().With("curved_tolerance_mm=0.05").OrThrow();
        foreach (var detail in new[] { double.PositiveInfinity, 0.5 })
        {
            var path = ((PathStep)SurfaceProjection.Project([half], PlanSurface.Of((x, _) => 0.1 * x, detail), setup).OrThrow().Single()).Path;
            foreach (var p in path.Points) Assert.That((p.LengthXY, p.Z), Is.EqualTo((10.0, 0.2 + 0.1 * p.X)).Within(1e-9));
            var middles = Enumerable.Range(0, path.SegmentCount).Select(i => ((path.Points[i] + path.EndOf(i)) / 2).LengthXY);
            Assert.That(middles, Is.All.GreaterThan(10 - 0.05));
            Assert.That(path.SegmentCount, Is.InRange(10, 80));
        }
    }

    [Test]
    public void A_surface_that_does_not_do_is_told_before_anything_is_put_onto_it()
    {
        var empty = SurfaceProjection.Project([], PlanSurface.Of(TriMesh.Create([], [])), new PrintSetup());
        Assert.That((empty.Value, empty.Diagnostics.Single().Severity), Is.EqualTo(((IReadOnlyList<Step>?)null, Severity.Error)));
    }

    [Test]
    public void The_ends_of_a_closed_part_are_its_lowest_vertices_and_smooth_faces_that_fall_away_all_around()
    {
        IEnumerable<Vec3> Upper(TriMesh mesh) => BoundaryFinder.SmoothFaces(mesh).Upper.Select(v => mesh.Vertices[v]);
        var box = MeshMaker.Box(0, 0, 0, 10, 10, 5);
        Assert.That(Upper(box).Select(p => p.Z), Is.EqualTo(new[] { 5.0, 5, 5, 5 }));
        Assert.That(BoundaryFinder.SmoothFaces(box).Lower.Select(v => box.Vertices[v].Z), Is.EqualTo(new[] { 0.0, 0, 0, 0 }));
        // A stair: its lower step ends at a wall. A roof that is almost flat is one face, one of 30 degrees two.
        Assert.That(Upper(Bar([(0, 0), (20, 0), (20, 4), (10, 4), (10, 8), (0, 8)])).Select(p => p.Z), Is.EqualTo(new[] { 8.0, 8, 8, 8 }));
        foreach (var ridge in new[] { 6.4, 11 })
        {
            var roof = Upper(Bar([(0, 0), (20, 0), (20, 5), (10, ridge), (0, 5)])).Select(p => (p.X, p.Z)).Distinct().OrderBy(p => p.X);
            Assert.That(roof, Is.EqualTo(new[] { (0.0, 5.0), (10, ridge), (20, 5) }));
        }
        // What bends down smoothly until it is a wall has no end.
        var outline = Enumerable.Range(0, 13).Select(k => (10 * Angle.Cos(7.5 * k) + 1e-3, 10 + 10 * Angle.Sin(7.5 * k))).Prepend((10, 0)).ToArray();
        Assert.That(Upper(CurvedSolids.Lathe(32, outline)), Is.Empty);
    }

    // Rows of vertices every 0.5 mm; the line runs along y. Of the rows no farther than 0.5 mm, those beside a much nearer one do not count.
    [TestCase(0.6, new[] { 0.5 })]
    [TestCase(0.65, new[] { 0.5 })]
    [TestCase(0.66, new[] { 0.5, 1 })]
    [TestCase(0.75, new[] { 0.5, 1 })]
    [TestCase(0.84, new[] { 0.5, 1 })]
    [TestCase(0.9, new[] { 1.0 })]
    [TestCase(1, new[] { 1.0 })]
    public void A_boundary_along_a_line_is_no_band(double y, double[] rows)
    {
        var mesh = Sheet();
        var along = BoundaryFinder.Along(mesh, p => Math.Abs(p.Y - y), 0.5).Select(v => mesh.Vertices[v]).ToArray();
        Assert.That(along.Select(p => p.Y).Distinct().OrderBy(v => v), Is.EqualTo(rows));
        Assert.That(along, Has.Length.EqualTo(5 * rows.Length));
        Assert.That(BoundaryFinder.Within(mesh, p => Math.Abs(p.Y - y), 0.5), Has.Length.EqualTo(mesh.Vertices.Count(p => Math.Abs(p.Y - y) <= 0.5)));
    }

    [Test]
    public void Open_edges_are_loops_and_pieces_are_told_apart()
    {
        var two = TriMesh.Merge([Sheet(), Sheet().Moved(new Vec3(0, 0, 5))]);
        var loops = BoundaryFinder.OpenLoops(two);
        Assert.That(loops.Select(l => l.Length), Is.EqualTo(new[] { 16, 16 }));
        Assert.That(loops.Select(l => l.Select(v => two.Vertices[v].Z).Distinct().Single()), Is.EqualTo(new[] { 0.0, 5 }));
        foreach (var loop in loops)
        {
            for (var i = 0; i < loop.Length; i++)
                Assert.That(two.Vertices[loop[i]].DistanceTo(two.Vertices[loop[(i + 1) % loop.Length]]), Is.EqualTo(0.5).Within(1e-12));
        }
        Assert.That(two.Vertices[BoundaryFinder.Unreached(two, loops[0])!.Value].Z, Is.EqualTo(5));
        Assert.That(BoundaryFinder.Unreached(two, [loops[0][0], loops[1][3]]), Is.Null);
        var (lower, upper) = BoundaryFinder.OpenEdges(two);
        Assert.That((lower.Length, upper.Length), Is.EqualTo((16, 16)));
        Assert.That(upper.Select(v => two.Vertices[v].Z), Is.All.EqualTo(5));
        Assert.That(BoundaryFinder.OpenEdges(Sheet()), Is.EqualTo((Array.Empty<int>(), Array.Empty<int>())), "One edge is no boundary.");
    }

    [Test]
    public void A_field_that_is_not_level_at_the_bed_has_no_skirt_and_none_has_a_raft()
    {
        var part = new[] { new NamedMesh("part", Solids.Block(0, 0, 0, 5, 5, 1)) };
        string[] Codes(double slope, params string[] settings) => [.. CurvedSlicer.Slice(part, LayerField.Vertical(slope == 0 ? PlanSurface.Level(0)
            : PlanSurface.Of((x, _) => slope * x)), new PrintSetup().With(["layer_height_mm=0.5", "first_layer_height_mm=0.5", .. settings]).OrThrow())
            .Diagnostics.Select(d => d.Code)];
        Assert.That(Codes(0.05, "skirt_loops=1"), Has.One.EqualTo("curved.no_skirt"));
        Assert.That(Codes(0, "raft_layers=2"), Has.One.EqualTo("curved.no_skirt"));
        Assert.That(Codes(0, "skirt_loops=1", "support_angle_deg=30"), Is.EqualTo(new[] { "slice.no_effect" }), "What slicing says is told.");
        Assert.That(Codes(0.05, "skirt_loops=0"), Is.Empty);
    }

    // 5 × 5 vertices, 0.5 mm apart.
    private static TriMesh Sheet()
    {
        var points = Enumerable.Range(0, 25).Select(i => new Vec3(i % 5 * 0.5, i / 5 * 0.5)).ToArray();
        return TriMesh.Create(points, [.. Enumerable.Range(0, 16).SelectMany(i =>
        {
            var a = i / 4 * 5 + i % 4;
            return new[] { a, a + 1, a + 6, a, a + 6, a + 5 };
        })]);
    }

    // A bar of 5 mm along y with a profile that turns counterclockwise in x and z and is star-shaped from its first point.
    private static TriMesh Bar((double X, double Z)[] profile)
    {
        var n = profile.Length;
        Vec3[] points = [.. profile.Select(p => new Vec3(p.X, 0, p.Z)), .. profile.Select(p => new Vec3(p.X, 5, p.Z))];
        var faces = new List<int>();
        for (var i = 0; i < n; i++) faces.AddRange([i, i + n, (i + 1) % n + n, i, (i + 1) % n + n, (i + 1) % n]);
        for (var i = 1; i + 1 < n; i++) faces.AddRange([0, i, i + 1, n, i + 1 + n, i + n]);
        return TriMesh.Create(points, faces);
    }
}

using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Tests.Geometry.Meshes;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>The small parts of curved slicing, each by hand-computed numbers.</summary>
public class CurvedPartTests
{
    private static readonly PrintSettings Settings = new() { FirstLayerHeight = 0.2, LayerHeight = 0.2 };

    // Nearly straight up from the nozzle for 2 mm, then 45 degrees outward: atan of 8 / 6.6, 5 / 3.6 and 2 / 0.6.
    [TestCase(100, 100, 50.477369)]
    [TestCase(3.6, 100, 54.246113)]
    [TestCase(100, 5, 54.246113)]
    [TestCase(100, 2, 73.300756)]
    [TestCase(0.5, 100, 90)]
    public void A_head_touches_slopes_with_the_end_of_its_outline_or_where_the_part_ends(double span, double rise, double degrees)
    {
        var printer = new Printer { HeadOutline = new([new(0.5, 0), new(0.6, 2), new(6.6, 8)]), HeadBoxes = new([]) };
        Assert.That(HeadSlope.OfHead(printer, span, rise), Is.EqualTo(degrees).Within(1e-6));
    }

    [TestCase(-10, -10, 10, 10, 100, 100, 19.471221)]
    [TestCase(-10, -10, 10, 10, 10, 100, 26.565051)]
    [TestCase(-10, -10, 10, 10, 100, 5, 90)]
    [TestCase(20, 0, 30, 10, 20, 100, 90)]
    [TestCase(20, 0, 30, 10, 25, 100, 11.309932)]
    [TestCase(-30, -10, -20, -5, 20.5, 100, 90)]
    [TestCase(-30, -10, -20, -5, 25, 100, 11.309932)]
    [TestCase(-30, -10, -20, -5, 99, 100, 8.984877)]
    [TestCase(0, -30, 10, -20, 25, 100, 11.309932)]
    public void A_box_of_the_head_touches_slopes_with_its_farthest_corner_over_the_part(
        double x0, double y0, double x1, double y1, double span, double rise, double degrees)
    {
        var box = new Bounds(new Vec3(x0, y0, 5), new Vec3(x1, y1, 30));
        Assert.That(HeadSlope.OfHead(new Printer { HeadOutline = new([new(0.5, 0)]), HeadBoxes = new([box]) }, span, rise), Is.EqualTo(degrees).Within(1e-6));
    }

    [TestCase(0.5, 0.125)]
    [TestCase(-1, -1.5)]
    [TestCase(0, -0.5)]
    [TestCase(1, 1)]
    [TestCase(1.5, 2)]
    [TestCase(2, 3)]
    [TestCase(3, 5)]
    public void A_stretched_axis_keeps_one_position_and_goes_on_beyond_its_ends(double at, double stretched)
        => Assert.That(new AxisStretch(0, 1, [1, 2, 2], kept: 1).At(at), Is.EqualTo(stretched).Within(1e-12));

    [TestCase(-5, 1)]
    [TestCase(0.5, 1.5)]
    [TestCase(1, 2)]
    [TestCase(9, 2)]
    public void The_growth_of_lengths_along_an_axis_is_linear_between_nodes(double at, double stretch)
    {
        var axis = new AxisStretch(0, 1, [1, 2, 2], kept: 1);
        Assert.That(AxisStretch.Inverse(axis, axis, 0.5, axis.At(at)), Is.EqualTo((at, stretch)).Using<(double, double)>(
            (p, q) => Math.Abs(p.Item1 - q.Item1) + Math.Abs(p.Item2 - q.Item2) < 1e-12));
    }

    [Test]
    public void Moves_along_a_parabola_are_as_long_as_the_tolerance_allows()
    {
        var field = LayerField.Vertical(PlanSurface.Of((x, _) => x * x / 100, 1));
        var path = new PrintPath([new Vec3(-20, 0, 1), new Vec3(20, 0, 1)], [new Bead(0.08, 0.2)], false);
        var rules = new LiftRules(new PrintSettings { CurvedTolerance = 0.01 }, 0, 60, null, false);
        var points = new PathLifter(field, rules, null).Lift(new PathStep(path)).Single().Path.Points;
        var sags = points.Zip(points.Skip(1), (a, b) => (b.X - a.X) * (b.X - a.X) / 400).ToArray();
        Assert.That(sags, Has.All.LessThan(0.01));
        // At three quarters of the tolerance, in the middle where the chord is level, 1.73 mm.
        Assert.That(sags, Has.Length.LessThan(28).And.Length.GreaterThan(20));
    }

    [Test]
    public void Positions_between_two_stretches_are_found_again_everywhere()
    {
        AxisStretch low = new(-2, 0.5, [1, 1.2, 1.7, 1.1, 1], kept: -1), high = new(-2, 0.5, [2, 1, 1, 1.4, 3], kept: -1);
        for (var u = -3.0; u <= 1; u += 0.01)
        {
            var stretched = low.At(u) * 0.7 + high.At(u) * 0.3;
            Assert.That(AxisStretch.Inverse(low, high, 0.3, stretched).From, Is.EqualTo(u).Within(1e-9));
        }
    }

    [Test]
    public void The_height_of_a_value_is_found_in_few_steps_or_there_is_none()
    {
        var calls = 0;
        double Height(Func<double, double> value, double wanted)
        {
            calls = 0;
            return LayerField.Of(p => (++calls, value(p.Z)).Item2).Height(1, 2, wanted);
        }
        Assert.That(Height(z => z, 3), Is.EqualTo(3));
        Assert.That(calls, Is.EqualTo(1));
        Assert.That(Height(z => 2 * z, 3), Is.EqualTo(1.5).Within(1e-9));
        Assert.That(Height(z => z - 1000, 5), Is.EqualTo(1005).Within(1e-9));
        Assert.That(Height(z => z + 1000, 5), Is.EqualTo(-995).Within(1e-9));
        Assert.That(Height(z => z * z * z, 8), Is.EqualTo(2).Within(1e-9));
        Assert.That(calls, Is.LessThan(60));
        Assert.That(Height(z => Math.Exp(z / 100), 20), Is.EqualTo(100 * Math.Log(20)).Within(1e-9));
        Assert.That(calls, Is.LessThan(60));
        Assert.That(Height(z => z < 1 ? 0.001 * z : z, 5), Is.EqualTo(5).Within(1e-9));
        Assert.That(Height(Math.Atan, 2), Is.NaN);
        Assert.That(Height(z => 1, 2), Is.NaN);
        Assert.That(Height(z => double.NaN, 2), Is.NaN);
        Assert.That(Height(z => z > 4 ? double.NaN : z / 2, 3), Is.NaN);
    }

    [Test]
    public void Rules_of_layers_count_upward_and_downward()
    {
        var rules = new LayerRules(0.2, 0.3, 0.1, 0.5, 1);
        Assert.That(new[] { 0, 1, 3 }.Select(rules.Height), Is.EqualTo(new[] { 0, 0.2, 0.8 }).Within(1e-12));
        Assert.That(new[] { 2, 0, -2 }.Select(rules.Upper), Is.EqualTo(new[] { 1, 0, -0.2 }).Within(1e-12));
        Assert.That(new[] { 2, 0, -2 }.Select(rules.Lower), Is.EqualTo(new[] { 0.2, 0, -1 }).Within(1e-12));
        Assert.That(new[] { 1.2, 1.0, 0, -1 }.Select(rules.Fewest), Is.EqualTo(new[] { 3, 2, 0, -10 }));
        Assert.That(new[] { 1.0, 0.95, 0, -1 }.Select(rules.MostLayers), Is.EqualTo(new[] { 10, 9, 0, -2 }));
        Assert.That((rules.With(0.5).Least, rules.With(0.5).Most), Is.EqualTo((0.2, 0.4)));
        var setup = new PrintSetup { Settings = Settings };
        Assert.That(LayerRules.LeastGap(setup), Is.EqualTo(0.06).Within(1e-12));
        Assert.That(LayerRules.LeastGap(setup with { Settings = Settings with { LayerHeight = 0.1 } }), Is.EqualTo(0.05).Within(1e-12));
        Assert.That(LayerRules.GreatestGap(setup), Is.EqualTo(0.3).Within(1e-12));
        Assert.That(LayerRules.GreatestGap(setup with { Settings = Settings with { LayerHeight = 0.35 } }), Is.EqualTo(0.35).Within(1e-12));
        var own = setup with { Settings = Settings with { CurvedMinGap = 0.07, CurvedMaxGap = 0.4 } };
        Assert.That((LayerRules.LeastGap(own), LayerRules.GreatestGap(own)), Is.EqualTo((0.07, 0.4)));
    }

    [Test]
    public void Heights_on_a_grid_rise_no_faster_than_a_slope_in_all_directions()
    {
        var grid = new SlopeGrid(Vec3.Zero, 1, 9, 9);
        var heights = Enumerable.Repeat(double.PositiveInfinity, 81).ToArray();
        heights[4 * 9 + 4] = 7;
        grid.Lower(heights, 0.5);
        var (diagonal, knight) = (Math.Sqrt(2), Math.Sqrt(5));
        foreach (var (x, y, length) in new[] { (1, 0, 1.0), (3, 0, 3), (1, 1, diagonal), (2, 2, 2 * diagonal), (2, 1, knight), (3, 1, 1 + knight) })
        {
            foreach (var (i, j) in new[] { (x, y), (-x, y), (x, -y), (-x, -y), (y, x), (-y, x), (y, -x), (-y, -x) })
                Assert.That(heights[(4 + j) * 9 + 4 + i], Is.EqualTo(7 + 0.5 * length).Within(1e-12), $"{i}, {j}");
        }
        var over = SlopeGrid.Over(new Bounds(new Vec3(1, 2, 0), new Vec3(11, 22, 5)), 200);
        Assert.That((over.Cell, over.Columns, over.Rows, over.Count), Is.EqualTo((1.0, 16, 26, 416)));
        Assert.That((over.At(0), over.At(17)), Is.EqualTo((new Vec3(-1.5, -0.5), new Vec3(-0.5, 0.5))));
        Assert.That(SlopeGrid.Over(new Bounds(Vec3.Zero, new Vec3(1, 1, 1)), 200).Cell, Is.EqualTo(0.4));
    }

    [Test]
    public void A_layer_keeps_the_places_that_go_together()
    {
        var grid = new SlopeGrid(Vec3.Zero, 1, 5, 1);
        var all = FixedLayer.Of(3, [(0, 0), (3, 1)], grid, 0.5);
        Assert.That((all.Number, all.Places.Count), Is.EqualTo((3, 2)));
        Assert.That(all.Upper, Is.EqualTo(new[] { 0, 0.5, 1, 1, 1.5 }).Within(1e-12));
        Assert.That(all.Lower, Is.EqualTo(new[] { 0, 0, 0.5, 1, 0.5 }).Within(1e-12));
        Assert.That(FixedLayer.Of(3, [(0, 0), (1, 0), (3, 5)], grid, 0.5).Places.Select(p => p.Node), Is.EqualTo(new[] { 0, 1 }));
        Assert.That(FixedLayer.Of(3, [(0, 0), (2, 5), (3, 5)], grid, 0.5).Places.Select(p => p.Node), Is.EqualTo(new[] { 2, 3 }));
        Assert.That(FixedLayer.Of(3, [(0, 0), (3, 5)], grid, 0.5).Upper[4], Is.EqualTo(2).Within(1e-12), "As many of both: the lower one stays.");
    }

    [TestCase(0, 5, 0.5, 10, -0.05)]
    [TestCase(0, 10, 1, 10, -0.1)]
    [TestCase(0, 20, 1.5, 20, -0.05)]
    [TestCase(0, -5, -0.5, 10, 0.05)]
    [TestCase(0, 40, 2.5, 20, 0.05)]
    [TestCase(10, 5.5, 0.5, 11, -0.05)]
    public void Layers_divide_the_space_between_surfaces_and_go_on_beyond(double x, double z, double value, double spread, double slope)
    {
        var field = LayerField.Between(PlanSurface.Level(0), PlanSurface.Of((u, _) => 10 + 0.1 * u), PlanSurface.Level(30));
        var p = new Vec3(x, 3, z);
        Assert.That((field.Value(p), field.Height(x, 3, value), field.Spread(p)), Is.EqualTo((value, z, spread)).Within(1e-9));
        var normal = field.Normal(p);
        Assert.That((normal.X / normal.Z, normal.Y), Is.EqualTo((slope, 0.0)).Within(1e-6));
        Assert.That(field.StartsLevel, Is.True);
        Assert.That(field.Creases, Is.EqualTo(new[] { 0.0, 1, 2 }));
    }

    [TestCase(3, 3)]
    [TestCase(3.1, 3)]
    [TestCase(0.15, 0)]
    [TestCase(-0.1, -0.2)]
    [TestCase(-0.2, -0.2)]
    [TestCase(-1, -1)]
    [TestCase(-1.1, -1.2)]
    public void A_field_is_moved_by_whole_layers_until_the_part_begins_above_0(double lowest, double zeroAt)
    {
        var field = LayerField.Of(p => p.Z);
        var part = PartColumns.Of([MeshMaker.Box(0, 0, lowest, 10, 10, lowest + 5)]);
        var moved = LayerField.Anchored(field, part, Settings);
        Assert.That(moved.Height(5, 5, 0), Is.EqualTo(zeroAt).Within(1e-9));
        Assert.That(moved.Value(new Vec3(5, 5, zeroAt + 1)), Is.EqualTo(1).Within(1e-9));
        Assert.That(moved.ToFlat(moved.ToPart(new Vec3(1, 2, 3))).DistanceTo(new Vec3(1, 2, 3)), Is.LessThan(1e-9));
        Assert.That(moved.Heights(5, 5, 2, 1).First - moved.Heights(5, 5, 2, 1).Second, Is.EqualTo(1).Within(1e-9));
        if (zeroAt == 0) Assert.That(moved, Is.SameAs(field));
    }

    [Test]
    public void A_transformed_surface_has_the_heights_and_slopes_of_its_places()
    {
        var plan = PlanSurface.Of((x, _) => 0.1 * x, 5);
        void Same(Affine map, double x, double y, double height, double byX, double byY, double detail)
        {
            var moved = plan.Transformed(map);
            var slope = moved.Slope(x, y);
            Assert.That(new[] { moved.Height(x, y), slope.ByX, slope.ByY, moved.Detail }, Is.EqualTo(new[] { height, byX, byY, detail }).Within(1e-6));
        }
        Same(Affine.Move(new Vec3(5, 0, 2)), 15, 0, 3, 0.1, 0, 5);
        Same(Affine.Scale(2, 3, 4), 2, 0, 0.4, 0.2, 0, 10);
        Same(Affine.Rotate(Vec3.UnitZ, 90), 0, 10, 1, 0, 0.1, 5);
        Assert.That(plan.Transformed(Affine.Identity), Is.SameAs(plan));
        Assert.That(() => plan.Transformed(Affine.Rotate(Vec3.UnitX, 10)), Throws.ArgumentException);
        Assert.That(() => plan.Transformed(Affine.Scale(1, 1, 0)), Throws.ArgumentException);
        Assert.That(PlanSurface.Level(3).Moved(new Vec3(0, 0, 1)).IsLevel, Is.True);
        Assert.That(plan.IsLevel, Is.False);
    }

    [TestCase(45, 4, 6, -5)]
    [TestCase(-45, 4, 6, 5)]
    [TestCase(45, 1, 2, 0)]
    [TestCase(45, -2, -2, -5)]
    public void A_cone_falls_from_its_axis(double degrees, double x, double y, double height)
    {
        Assert.That(PlanSurface.Cone(new Vec3(1, 2), degrees).Height(x, y), Is.EqualTo(height).Within(1e-9));
        Assert.That(() => PlanSurface.Cone(Vec3.Zero, 80.1), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => PlanSurface.Cone(Vec3.Zero, double.NaN), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => PlanSurface.Cone(Vec3.Zero, -80), Throws.Nothing);
    }

    [TestCase(3, 4, 1.5, 0.5)]
    [TestCase(20, 5, 5, 0.5)]
    [TestCase(-10, 5, 0, 0.5)]
    [TestCase(5, 30, 2.5, 0.5)]
    [TestCase(10, 10, 5, 0.5)]
    public void Beyond_its_edge_a_mesh_has_the_height_where_one_comes_to_it(double x, double y, double height, double byX)
    {
        var mesh = TriMesh.Create([new Vec3(0, 0, 0), new Vec3(10, 0, 5), new Vec3(10, 10, 5), new Vec3(0, 10, 0)], [0, 1, 2, 0, 2, 3]);
        var plan = PlanSurface.Of(mesh);
        Assert.That(plan.Height(x, y), Is.EqualTo(height).Within(1e-6));
        Assert.That(plan.Slope(x, y).ByX, Is.EqualTo(byX).Within(1e-9));
        Assert.That(plan.Slope(x, y).ByY, Is.Zero.Within(1e-9));
        Assert.That(plan.Covers(x, y), Is.EqualTo(x is >= 0 and <= 10 && y is >= 0 and <= 10));
        Assert.That(plan.Covers(10.01, 5), Is.True, "By rounding.");
        Assert.That(plan.Covers(10.03, 5), Is.False);
        foreach (var (dx, dy) in new[] { (-1, 0), (0, 1), (0, -1), (1, 1), (-1, -1), (1, -1) })
        {
            Assert.That(plan.Covers(5 + 5.01 * dx, 5 + 5.01 * dy), Is.True, $"{dx}, {dy}");
            Assert.That(plan.Covers(5 + 5.03 * dx, 5 + 5.03 * dy), Is.False, $"{dx}, {dy}");
        }
        Assert.That(PlanSurface.OnBed(mesh.Moved(new Vec3(0, 0, -2))).Height(x, y), Is.EqualTo(plan.Covers(x, y) ? Math.Max(0, height - 2) : 0).Within(1e-6));
    }

    [TestCase("curved.plan_empty", 0, 0, 0)]
    [TestCase("curved.plan_vertical", 0, 0, 5)]
    [TestCase("curved.plan_upside_down", 0, 5, 0)]
    public void A_surface_without_heights_is_reported(string code, double x, double y, double z)
    {
        var empty = x + y + z == 0;
        var mesh = TriMesh.Create(empty ? [] : [Vec3.Zero, new Vec3(x, y, z), new Vec3(9, 0)], empty ? [] : [0, 1, 2]);
        var problems = new DiagnosticList();
        PlanSurface.Of(mesh).Check(problems);
        Assert.That(problems.ToList().Select(d => d.Code), Is.EqualTo(new[] { code }));
        Assert.That(PlanSurface.Of(mesh).Moved(new Vec3(1, 0)).Height(99, 99), Is.Not.NaN);
    }

    private static TriMesh TwoTowers()
    {
        var (a, b) = (MeshMaker.Box(0, 0, 0, 10, 10, 4), MeshMaker.Box(20, 0, 0, 30, 10, 8));
        return TriMesh.Create([.. a.Vertices, .. b.Vertices], [.. a.RawTriangles, .. b.RawTriangles.Select(t => t + a.Vertices.Count)]);
    }

    [TestCase(5, 5, 0.5, 2)]
    [TestCase(25, 5, 0.5, 4)]
    [TestCase(5, 5, 0.25, 1)]
    [TestCase(25, 5, 0.75, 6)]
    [TestCase(11, 5, 0.5, 2)]
    [TestCase(19, 5, 0.5, 4)]
    [TestCase(25, -1, 0.5, 4)]
    [TestCase(5, 10.5, 1, 4)]
    [TestCase(5, 5, 1.5, 6)]
    [TestCase(25, 5, -0.25, -2)]
    public void Layers_span_the_towers_of_a_part_each_with_its_own_heights(double x, double y, double level, double height)
    {
        var mesh = TwoTowers();
        var values = mesh.Vertices.Select(p => p.X < 15 ? p.Z / 4 : p.Z / 8).ToArray();
        var grid = SpanGrid.Of(mesh, values, [0, 0.5, 1]);
        Assert.That(grid.Height(x, y, level), Is.EqualTo(height).Within(2e-3));
        Assert.That(grid.Level(new Vec3(x, y, height)), Is.EqualTo(level).Within(2e-3));
        Assert.That(grid.Cell, Is.EqualTo(0.3));
    }

    [Test]
    public void How_fast_values_change_on_a_surface_is_the_thickness_of_its_layers()
    {
        var box = MeshMaker.Box(0, 0, 0, 10, 20, 4);
        var slope = new SurfaceSlope(box, box.Vertices.Select(p => 2 * p.Z).ToArray());
        Assert.That(slope.Thickness(0.5), Is.EqualTo(0.5).Within(1e-12));
        Assert.That(slope.Falling(0, out _), Is.Zero);
        var falling = new SurfaceSlope(box, box.Vertices.Select(p => -p.Z).ToArray());
        Assert.That(falling.Falling(0, out var place), Is.EqualTo(1).Within(1e-12));
        Assert.That(falling.Falling(89, out _), Is.EqualTo(1), "Straight down.");
        Assert.That(place.X, Is.EqualTo(0).Or.EqualTo(10), "On one of the largest faces.");
        Assert.That(new SurfaceSlope(box, new double[8]).Thickness(0.5), Is.EqualTo(1));
        var towers = TwoTowers();
        var two = new SurfaceSlope(towers, towers.Vertices.Select(p => p.X < 15 ? p.Z / 4 : p.Z / 8).ToArray());
        Assert.That((two.Thickness(0.3), two.Thickness(0.4)), Is.EqualTo((4.0, 8.0)).Within(1e-9), "A third is the lower one.");
    }

    private static JoinedExtrusion Joined(params (double X, double Y, Bead Bead)[] pieces)
    {
        var joined = new JoinedExtrusion(0.01, 0.1);
        var at = Vec3.Zero;
        foreach (var (x, y, bead) in pieces)
        {
            joined.Add(at, new Vec3(x, y), bead, keepsStart: false);
            at = new Vec3(x, y);
        }
        return joined;
    }

    [Test]
    public void Pieces_of_an_extrusion_are_joined_where_a_line_does_and_keep_their_volume()
    {
        Bead Of(double area, double height = 0.2, double speed = 30) => new(area, height, speed);
        int Pieces(double x, double y, Bead next) => Joined((1, 0, Of(1)), (x, y, next)).Beads.Count;
        Assert.That(Pieces(3, 0, Of(1)), Is.EqualTo(1));
        Assert.That(Pieces(3, 0, Of(1.09)), Is.EqualTo(1));
        Assert.That(Pieces(3, 0, Of(0.91)), Is.EqualTo(1));
        Assert.That(Pieces(3, 0, Of(1.2)), Is.EqualTo(2));
        Assert.That(Pieces(3, 0, Of(0.8)), Is.EqualTo(2));
        Assert.That(Pieces(3, 0, Of(1, speed: 40)), Is.EqualTo(2));
        Assert.That(Pieces(3, 0, Of(1, height: 0)), Is.EqualTo(2));
        Assert.That(Pieces(0.5, 0, Of(1)), Is.EqualTo(2), "Back.");
        Assert.That(Pieces(2, 0.019, Of(1)), Is.EqualTo(1));
        Assert.That(Pieces(2, 0.03, Of(1)), Is.EqualTo(2));
        var mean = Joined((1, 0, Of(1, 0.2)), (4, 0, Of(1.08, 0.3)));
        Assert.That((mean.Beads[0].Area, mean.Beads[0].Height), Is.EqualTo((1.06, 0.275)).Within(1e-12));
        Assert.That(mean.Points, Is.EqualTo(new[] { Vec3.Zero, new Vec3(4, 0) }));
        Assert.That(Joined((1, 0, Of(1)), (2, 0, Of(1.06)), (3, 0, Of(0.94))).Beads, Has.Count.EqualTo(2), "Both ends of the range count.");
        Assert.That(Joined((1, 0.009, Of(1)), (2, 0.009, Of(1)), (9, -0.02, Of(1))).Beads, Has.Count.EqualTo(2), "All points that were passed count.");
        Assert.That(Joined([.. Enumerable.Range(1, 60).Select(i => ((double)i, 0.0, Of(1)))]).Beads, Has.Count.EqualTo(2), "49 at most.");
        var kept = new JoinedExtrusion(0.01, 0.1);
        kept.Add(Vec3.Zero, new Vec3(1, 0), Of(1), false);
        kept.Add(new Vec3(1, 0), new Vec3(2, 0), Of(1), true);
        Assert.That((kept.Points.Count, kept.Beads.Count), Is.EqualTo((3, 2)));
        kept.Clear();
        kept.Add(new Vec3(5, 5), new Vec3(6, 5), Of(2), false);
        Assert.That(kept.Points, Is.EqualTo(new[] { new Vec3(5, 5), new Vec3(6, 5) }));
    }

    [TestCase(15, 15, 0)]
    [TestCase(10.5, 19.5, 0)]
    [TestCase(25, 15, -5)]
    [TestCase(4, 15, -6)]
    [TestCase(15, 2, -8)]
    [TestCase(15, 27, -7)]
    [TestCase(25, 25, -7.071)]
    [TestCase(6, 7, -5)]
    [TestCase(99, 15, -10.37)]
    public void Against_overhangs_layers_fall_with_the_distance_from_the_foot(double x, double y, double height)
    {
        Assert.That(Descending.Value.Height(x, y), Is.EqualTo(height).Within(x > 50 ? 0.7 : 0.03));
        Assert.That(Flatter.Value.Height(x, y), Is.EqualTo(Descending.Value.Height(x, y) / Math.Sqrt(3)).Within(1e-9));
    }

    [Test]
    public void Details_against_overhangs_are_four_cells()
    {
        Assert.That(Descending.Value.Detail, Is.EqualTo(1));
        Assert.That(new OverhangPlan(Region.Rectangle(1, 10, 8, 20), new Bounds(Vec3.Zero, new Vec3(9, 400, 10)), 45).Detail, Is.EqualTo(4));
    }

    private static readonly Lazy<OverhangPlan> Descending = new(() => Against(45));
    private static readonly Lazy<OverhangPlan> Flatter = new(() => Against(30));

    private static OverhangPlan Against(double degrees)
        => new(Region.Rectangle(10, 10, 20, 20), new Bounds(Vec3.Zero, new Vec3(30, 30, 10)), degrees);

    [TestCase(0.5, 0, 1, 0)]
    [TestCase(0, 0.5, 0, 1)]
    [TestCase(0.3, 0.3, 0.70710678, 0.70710678)]
    [TestCase(0.3, -0.3, 0.70710678, -0.70710678)]
    public void Slopes_of_layers_are_measured_along_and_across_their_main_direction(double byX, double byY, double cos, double sin)
    {
        var field = LayerField.Vertical(PlanSurface.Of((x, y) => byX * x + byY * y));
        var samples = SlopeSamples.Of(field, PartColumns.Of([MeshMaker.Box(0, 0, 0, 10, 10, 6)]), 5, 3)!;
        Assert.That(new[] { Math.Abs(samples.Cos), samples.Sin * Math.Sign(samples.Cos + 1e-3) }, Is.EqualTo(new[] { cos, sin }).Within(1e-3));
        var most = Math.Sqrt(1 + byX * byX + byY * byY);
        Assert.That(samples.Most, Is.EqualTo(most).Within(1e-6));
        for (var level = 0; level < 3; level++)
        {
            var (u, v) = samples.Axes(level);
            foreach (var at in new[] { -3.0, 0, 4.4, 9, 30 })
                Assert.That((u.At(at + 1) - u.At(at), v.At(at + 1) - v.At(at)), Is.EqualTo((most, 1.0)).Within(1e-6));
        }
        Assert.That(SlopeSamples.Of(LayerField.Of(_ => 1.0), PartColumns.Of([MeshMaker.Box(0, 0, 0, 10, 10, 6)]), 5, 3), Is.Null);
    }
}

using System;
using System.Linq;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Tests.Geometry.Meshes;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>Fields of curved layers and what they are made of, each by hand-computed numbers.</summary>
public class CurvedPartTests
{
    private static readonly PrintSettings Settings = new() { FirstLayerHeight = 0.2, LayerHeight = 0.2 };

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
        var wide = MeshMaker.Box(0, 0, 0, 20, 10, 4);
        new SurfaceSlope(wide, wide.Vertices.Select(p => -p.Z).ToArray()).Falling(0, out place);
        Assert.That(place.Y, Is.EqualTo(0).Or.EqualTo(10), "On one of the others.");
        Assert.That(new SurfaceSlope(box, new double[8]).Thickness(0.5), Is.EqualTo(1));
        var towers = TwoTowers();
        var two = new SurfaceSlope(towers, towers.Vertices.Select(p => p.X < 15 ? p.Z / 4 : p.Z / 8).ToArray());
        Assert.That((two.Thickness(0.3), two.Thickness(0.4)), Is.EqualTo((4.0, 8.0)).Within(1e-9), "A third is the lower one.");
    }
}

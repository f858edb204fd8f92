using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Files;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Tests.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

public class LayerFieldTests
{
    private static readonly TriMesh Part = CurvedSolids.Between(CurvedSolids.Plan(-10, -10, 10, 10), 10, (_, _) => 0, (x, _) => 6 + 0.1 * x);

    private static LayerField[] Fields() =>
    [
        LayerField.Vertical(PlanSurface.Level(0)), LayerField.Vertical(PlanSurface.Of((x, y) => 0.1 * x * y, 2)),
        LayerField.Vertical(PlanSurface.Of((x, _) => 6 + 0.1 * x), new LayerBlend(1, 5)),
        LayerField.Between(PlanSurface.Level(0), PlanSurface.Of((x, _) => 6 + 0.1 * x), PlanSurface.Level(9)),
        LayerField.Formula("z + 0.3 * sin(20 * z + 10 * x)").OrThrow(), LayerField.Offset(CurvedSolids.Sheet(30, 50, 130, 60, 50).Moved(new Vec3(0, -30, -28))),
        LayerField.Deformed("x + 0.1 * z", "y * (1 + 0.02 * x)", "z + 0.01 * r ^ 2").OrThrow(),
    ];

    [Test]
    public void Points_come_back_from_flat_layers()
    {
        var random = new Random(5);
        foreach (var field in Fields())
        {
            var fitted = field.FitTo(PartColumns.Of([Part]), CurvedSolids.Massive, new DiagnosticList());
            for (var i = 0; i < 200; i++)
            {
                var p = new Vec3(random.NextDouble() * 20 - 10, random.NextDouble() * 20 - 10, 0.05 + random.NextDouble() * 5);
                var back = fitted.ToPart(fitted.ToFlat(p));
                Assert.That(back.DistanceTo(p), Is.LessThan(1e-6), $"{field.GetType().Name} at {p}");
                Assert.That(fitted.Normal(p).Length, Is.EqualTo(1).Within(1e-9));
                Assert.That(fitted.Normal(p).Z, Is.GreaterThan(0));
            }
        }
    }

    [Test]
    public void The_part_begins_at_the_value_0_of_a_fitted_field()
    {
        var columns = PartColumns.Of([Part]);
        foreach (var field in Fields())
        {
            var problems = new DiagnosticList();
            var fitted = field.FitTo(columns, CurvedSolids.Massive, problems);
            Assert.That(problems.ToList(), Is.Empty);
            Assert.That(columns.Columns.Min(c => fitted.Value(new Vec3(c.X, c.Y, c.Low))), Is.InRange(-1e-6, CurvedSolids.Massive.LayerHeight));
        }
    }

    [Test]
    public void A_blend_is_level_at_the_bed_and_its_uppermost_layers_are_parallel_to_the_plan()
    {
        static double Roof(double x, double y) => 6 + 0.1 * x;
        var field = LayerField.Vertical(PlanSurface.Of(Roof), new LayerBlend(1, 5)).FitTo(PartColumns.Of([Part]), CurvedSolids.Massive, new DiagnosticList());
        // The highest place of the plan, 7 mm, is a border of layers of 0.5 mm.
        Assert.That(field.Height(-8, 0, 1), Is.EqualTo(1).Within(1e-12));
        Assert.That(field.Height(-8, 0, 7), Is.EqualTo(Roof(-8, 0)).Within(1e-12));
        Assert.That(field.Height(-8, 0, 6.5), Is.EqualTo(Roof(-8, 0) - 0.5).Within(1e-12));
        // Half of the change at half of the zone, and half of the slope; a quarter at a quarter.
        Assert.That(field.Height(-8, 0, 3), Is.EqualTo(3 - (7 - Roof(-8, 0)) / 2).Within(1e-12));
        foreach (var (value, share) in new[] { (0.5, 0.0), (1, 0), (2, 0.25), (3, 0.5), (5, 1), (6, 1) })
        {
            var normal = field.Normal(new Vec3(-8, 0, field.Height(-8, 0, value)));
            Assert.That(normal.X / normal.Z, Is.EqualTo(-0.1 * share).Within(1e-9), $"at {value}");
        }
    }

    [Test]
    public void A_formula_and_a_surface_are_transformed_with_the_part()
    {
        var map = Affine.Scale(2, 3, 1.5).Then(Affine.Rotate(Vec3.UnitZ, 90)).Then(Affine.Move(new Vec3(40, 50, 0)));
        var plan = PlanSurface.Formula("5 + 2 * sin(9 * x) + 0.1 * y").OrThrow();
        // x is along −Y at a distance of 50, y along X.
        var expected = PlanSurface.Formula("1.5 * (5 + 2 * sin(9 * (y - 50) / 2) + 0.1 * (40 - x) / 3)").OrThrow();
        var field = LayerField.Formula("z - 2 * sin(9 * x) - 0.1 * y", map).OrThrow();
        var moved = LayerField.Formula("z - 1.5 * (2 * sin(9 * (y - 50) / 2) + 0.1 * (40 - x) / 3)").OrThrow();
        var random = new Random(7);
        for (var i = 0; i < 100; i++)
        {
            var p = new Vec3(random.NextDouble() * 60, random.NextDouble() * 60, random.NextDouble() * 20);
            Assert.That(plan.Transformed(map).Height(p.X, p.Y), Is.EqualTo(expected.Height(p.X, p.Y)).Within(1e-9));
            var (byX, byY) = plan.Transformed(map).Slope(p.X, p.Y);
            var (alongX, alongY) = expected.Slope(p.X, p.Y);
            Assert.That((byX - alongX, byY - alongY), Is.EqualTo((0.0, 0.0)).Within(1e-3));
            Assert.That(field.Value(p), Is.EqualTo(moved.Value(p)).Within(1e-9));
        }
        Assert.That(() => plan.Transformed(Affine.Rotate(Vec3.UnitX, 10)), Throws.ArgumentException);
    }

    [Test]
    public void Copies_have_the_layers_of_the_part_at_their_places()
    {
        // Boxes of round copies side by side overlap at the corners.
        var part = new NamedMesh("part", CurvedSolids.Lathe(24, (8, 0), (8, 5)));
        NamedMesh[] copies = [part, part.Moved(new Vec3(15, 9.5, 0)), part.Moved(new Vec3(-30, 0, 0))];
        var field = LayerField.Formula("z - 0.3 * x + 0.1 * sin(20 * y)").OrThrow();
        var setup = new PrintSetup { Settings = CurvedSolids.Massive };
        var one = CurvedSlicer.Slice([part], field, setup).OrThrow().Layers;
        var all = CurvedSlicer.Slice(copies, field.ForCopies(copies), setup).OrThrow().Layers;
        Assert.That(all.Sum(CurvedSolids.Volume), Is.EqualTo(3 * one.Sum(CurvedSolids.Volume)).Within(0.5).Percent);
        foreach (var point in all.SelectMany(CurvedSolids.Points))
        {
            var center = copies.Select(c => c.Placed.Shift).OrderBy(s => (point - s).LengthXY).First();
            var value = field.Value(point - center) / 0.5;
            Assert.That(value - Math.Round(value), Is.EqualTo(0).Within(0.02), $"between layers at {point}");
        }
        var bent = LayerField.Deformed("x + 0.1 * z", "y", "z").OrThrow();
        Assert.That(() => bent.ForCopies(copies), Throws.ArgumentException);
    }

    [Test]
    public void A_height_map_has_its_heights_in_the_middles_of_dots()
    {
        var plan = PlanSurface.HeightMap(new GrayImage(2, 2, [0, 1, 0.5, 0.25]), new Bounds(new Vec3(10, 20, 5), new Vec3(30, 40, 9)));
        Assert.That(plan.Height(15, 35), Is.EqualTo(5).Within(1e-12));
        Assert.That(plan.Height(25, 35), Is.EqualTo(9).Within(1e-12));
        Assert.That(plan.Height(15, 25), Is.EqualTo(7).Within(1e-12));
        Assert.That(plan.Height(20, 30), Is.EqualTo(5 + 4 * 0.4375).Within(1e-12));
        Assert.That(plan.Covers(9, 30), Is.False);
        // Details are dots, and no finer than a tenth of a millimeter.
        Assert.That(plan.Detail, Is.EqualTo(10));
        Assert.That(PlanSurface.HeightMap(new GrayImage(4, 1, new double[4]), new Bounds(Vec3.Zero, new Vec3(1, 1, 1))).Detail, Is.EqualTo(0.25));
        Assert.That(PlanSurface.HeightMap(new GrayImage(1, 40, new double[40]), new Bounds(Vec3.Zero, new Vec3(1, 1, 1))).Detail, Is.EqualTo(0.1));
        foreach (var (x, y) in new[] { (0, 1), (1, 0) })
            Assert.That(() => PlanSurface.HeightMap(new GrayImage(1, 1, [0]), new Bounds(Vec3.Zero, new Vec3(x, y, 1))), Throws.ArgumentException);
    }

    [Test]
    public void A_deformation_keeps_the_volume_of_the_part()
    {
        var field = LayerField.Deformed("x * 1.2 + 0.1 * z", "y - 0.05 * x", "z + 0.1 * x").OrThrow();
        var block = Solids.Block(-10, -8, 0, 10, 8, 5);
        var layers = CurvedSolids.Slice(field, CurvedSolids.Massive with { LayerHeight = 0.25, FirstLayerHeight = 0.25 }, block);
        // Where layers leave through the bed and the top their last extrusions are wedges.
        Assert.That(layers.Sum(CurvedSolids.Volume), Is.EqualTo(block.Volume).Within(2).Percent);
        foreach (var p in layers.SelectMany(CurvedSolids.Points)) Assert.That(Math.Abs(p.X), Is.LessThan(10));
    }

    // Around a cylinder of 10 mm that goes on below its middle: beside its middle, layers are upright.
    [TestCase(-1, true)]
    [TestCase(1, false)]
    public void Layers_around_a_surface_are_refused_where_they_overhang(double bottom, bool overhangs)
    {
        var problems = new DiagnosticList();
        var field = LayerField.Offset(CurvedSolids.Sheet(10, -30, 210, 20, 96));
        field.FitTo(PartColumns.Of([Solids.Block(11, 2, bottom, 14, 6, 5)]), CurvedSolids.Massive, problems);
        Assert.That(problems.ToList().Select(d => d.Code), Is.EqualTo(overhangs ? new[] { "curved.overhanging_layers" } : []));
    }

    // Folded from 4 to 6 mm, or above 8, 9.5 or 12 mm, of a part of 10 mm at its middle.
    [TestCase("x * ((z - 5) ^ 2 - 1)", "z", true)]
    [TestCase("x * ((z - 5) ^ 2 + 1)", "z", false)]
    [TestCase("x", "z - (z - 3) ^ 2 / 10", true)]
    [TestCase("x", "z - (z - 5) ^ 2 / 20", false)]
    [TestCase("x", "z - z ^ 2 / 19", true)]
    [TestCase("x", "z - z ^ 2 / 24", false)]
    public void A_deformation_may_fold_the_part_nowhere(string x, string z, bool isFolded)
    {
        var field = LayerField.Deformed(x, "y", z).OrThrow();
        var problems = new DiagnosticList();
        field.FitTo(PartColumns.Of([Solids.Block(-5, -5, 0, 5, 5, 10)]), CurvedSolids.Massive, problems);
        Assert.That(problems.ToList().Select(d => d.Code).Distinct(), Is.EqualTo(isFolded ? new[] { "curved.folded_deformation" } : []));
    }

    [Test]
    public void Overhangs_get_layers_that_descend_from_where_the_part_stands()
    {
        // A stem with a hat whose underside rises 20 degrees: 70 degrees of overhang.
        var hat = 4 + 10 * Math.Tan(Math.PI / 9);
        var part = CurvedSolids.Lathe(96, (5, 0), (5, 4), (15, hat), (15, hat + 3));
        var setup = new PrintSetup { Settings = CurvedSolids.Massive };
        var plan = PlanSurface.AgainstOverhangs([new NamedMesh("hat", part)], setup).OrThrow();
        // tan a = tan 45 − tan 20: the underside is then 45 degrees steep.
        var slope = 1 - Math.Tan(Math.PI / 9);
        Assert.That(plan.Height(0, 3), Is.EqualTo(0).Within(1e-9));
        Assert.That(plan.Height(12, 0), Is.EqualTo(-7 * slope).Within(0.05));
        Assert.That(plan.Height(-9, -9), Is.EqualTo(-(Math.Sqrt(162) - 5) * slope).Within(0.05));
        var layers = CurvedSolids.Slice(LayerField.Vertical(plan), CurvedSolids.Massive, part);
        var volume = Math.PI * (25 * 4 + (25 + 75 + 225) / 3.0 * (hat - 4) + 225 * 3);
        Assert.That(layers.Sum(CurvedSolids.Volume), Is.EqualTo(volume).Within(3).Percent);
    }

    [Test]
    public void Layers_too_thick_somewhere_are_divided()
    {
        var field = LayerField.Between(PlanSurface.Level(0), PlanSurface.Of((x, _) => 6 + 0.1 * x));
        var layers = CurvedSolids.Slice(field, CurvedSolids.Massive with { CurvedMaxGap = 0.2, LineWidth = 1 }, Part);
        Assert.That(Gaps(layers).Max(), Is.LessThan(0.2 * 1.02));
        Assert.That(layers.Sum(CurvedSolids.Volume), Is.EqualTo(Part.Volume).Within(2).Percent);
    }

    [Test]
    public void Layers_too_thin_somewhere_are_printed_several_at_once()
    {
        var part = CurvedSolids.Between(CurvedSolids.Plan(-10, -10, 10, 10), 10, (_, _) => 0, (x, _) => 5 + 0.35 * x);
        var field = LayerField.Between(PlanSurface.Level(0), PlanSurface.Of((x, _) => 5 + 0.35 * x));
        var all = CurvedSolids.Slice(field, CurvedSolids.Massive, part);
        var merged = CurvedSolids.Slice(field, CurvedSolids.Massive with { CurvedMinGap = 0.25 }, part);
        Assert.That(Gaps(all).Min(), Is.LessThan(0.12));
        // At the top a group may end early.
        Assert.That(merged.Take(merged.Count - 4).SelectMany(l => Gaps([l])).Count(g => g < 0.24), Is.LessThan(Gaps(all).Length / 100));
        Assert.That(merged.Sum(CurvedSolids.Volume), Is.EqualTo(part.Volume).Within(2).Percent);
    }

    private static double[] Gaps(System.Collections.Generic.IReadOnlyList<SlicedLayer> layers)
        => layers.SelectMany(l => l.Steps).SelectMany(s => Enumerable.Range(0, s.Path.SegmentCount).Select(i => s.Path.BeadOf(i).Height)).ToArray();

    [Test]
    public void Paths_put_onto_an_object_keep_their_height_above_it_and_their_volume()
    {
        static double Hill(double x, double y) => 10 + 2 * Angle.Cos(10 * x);
        var path = new PrintPath([new(-15, 0, 0.3), new(15, 0, 0.3), new(15, 5, 0.3)], Bead.FromWidth(0.5, 0.3));
        var setup = new PrintSetup { Settings = CurvedSolids.Massive };
        var steps = SurfaceProjection.Project([path, new TravelStep(new Vec3(0, 0, 5))], PlanSurface.Of(Hill, 2), setup, squeeze: 0.05).OrThrow();
        var onto = ((PathStep)steps[0]).Path;
        foreach (var p in onto.Points) Assert.That(p.Z, Is.EqualTo(Hill(p.X, p.Y) + 0.25).Within(1e-9));
        Assert.That(onto.Points, Has.Count.GreaterThan(20));
        Assert.That(onto.Volume, Is.EqualTo(path.Volume).Within(1e-6));
        Assert.That(((TravelStep)steps[1]).Points[0].Z, Is.EqualTo(Hill(0, 0) + 4.95).Within(1e-9));
    }

    [Test]
    public void Paths_beside_the_object_are_an_error()
    {
        var onto = PlanSurface.Of(Solids.Block(-5, -5, 0, 5, 5, 8));
        var path = new PrintPath([new(-10, 0, 0.3), new(3, 0, 0.3)], Bead.FromWidth(0.5, 0.3));
        var refused = SurfaceProjection.Project([path], onto, new PrintSetup());
        Assert.That(refused.Value, Is.Null);
        Assert.That(refused.Diagnostics.Single().Code, Is.EqualTo("curved.outside_surface"));
        var partial = SurfaceProjection.Project([path], onto, new PrintSetup(), partial: true).OrThrow();
        Assert.That(((PathStep)partial.Single()).Path.Start.X, Is.EqualTo(-5).Within(0.1));
    }
}

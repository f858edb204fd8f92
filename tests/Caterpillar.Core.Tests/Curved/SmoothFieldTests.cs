using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Tests.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>Level layers that bend so that gently sloped tops lie in a layer.</summary>
public class SmoothFieldTests
{
    private static readonly PrintSetup Setup = new()
    {
        Settings = new PrintSettings { LayerHeight = 0.2, FirstLayerHeight = 0.2, CurvedMinGap = 0.08, CurvedMaxGap = 0.3, CurvedMaxSlope = 30.1 },
    };

    private static TriMesh Roof(Func<double, double, double> top, int steps = 1)
        => CurvedSolids.Between(CurvedSolids.Plan(0, 0, 20, 10), steps, (_, _) => 0, top);

    private static Result<LayerField> Smooth(params TriMesh[] meshes)
        => LayerField.Smooth(meshes.Select((m, i) => new NamedMesh($"part {i}", m)).ToArray(), Setup);

    // Of a strip of 2 columns and a plane of 8 columns 3 mm above or below it, the plane stays.
    [TestCase(5, 2)]
    [TestCase(2, 5)]
    public void Of_tops_that_contradict_each_other_the_larger_ones_stay_in_a_layer(double plane, double strip)
    {
        var grid = new SlopeGrid(Vec3.Zero, 0.5, 10, 10);
        var places = Enumerable.Range(0, 100).Select(n => (n, n % 10 < 2 ? strip : plane)).ToArray();
        var layer = FixedLayer.Of(7, places, grid, 0.5);
        Assert.That(layer.Places.All(p => p.Height == plane), Is.True);
        // All of the strip is within 1 mm of the plane, which lets the layer change by half of that.
        Assert.That(layer.Places, Has.Count.EqualTo(80));
        Assert.That(layer.Upper[0], Is.EqualTo(plane + 0.5).Within(0.03));
        Assert.That(layer.Lower[0], Is.EqualTo(plane - 0.5).Within(0.03));
    }

    [Test]
    public void The_top_of_a_wedge_is_the_layer_of_its_mean_height_and_the_first_layer_is_level()
    {
        // From 4 to 6 mm: layer 25 is at 5 mm where it is level.
        var smooth = Smooth(Roof((x, _) => 4 + 0.1 * x));
        Assert.That(smooth.Diagnostics, Is.Empty);
        var field = smooth.Value!;
        for (var x = 0.0; x <= 20; x += 0.7)
        {
            for (var y = 0.0; y <= 10; y += 0.7)
            {
                Assert.That(field.Value(new Vec3(x, y, 4 + 0.1 * x)), Is.EqualTo(5).Within(1e-9));
                Assert.That(field.Height(x, y, 5), Is.EqualTo(4 + 0.1 * x).Within(1e-9));
                Assert.That(field.Height(x, y, 0.2), Is.EqualTo(0.2));
            }
        }
        Assert.That(field.Value(new Vec3(3, 3, 0)), Is.Zero);
        Assert.That(field.StartsLevel, Is.True);
        // Layers share what is to be bent: 3.8 mm in 24 layers at the low end, 5.8 mm at the high one, for which 0.45 of their freedom is enough.
        Assert.That(field.Height(0, 5, 3) - field.Height(0, 5, 2.8), Is.EqualTo(0.2 - 0.45 * (0.2 - 0.08 / Angle.Cos(28.6))).Within(1e-9));
        Assert.That(field.Height(20, 5, 5) - field.Height(20, 5, 4.8), Is.EqualTo(0.2 + 0.45 * 0.1).Within(1e-9));
        // Beyond the nodes around the part, they turn back no faster than they must.
        Assert.That(field.Height(-0.6, 5, 5), Is.EqualTo(3.98 + 1.05 * 0.1 * 0.4).Within(1e-9));
        Assert.That(field.Normal(new Vec3(10, 5, 5)).X / field.Normal(new Vec3(10, 5, 5)).Z, Is.EqualTo(-0.1).Within(1e-9));
    }

    [Test]
    public void Layers_rise_keep_their_thickness_and_stay_below_the_slope_on_any_part()
    {
        var random = new Random(7);
        for (var round = Rounds.Of(4, 60); round > 0; round--)
        {
            var waves = Enumerable.Range(0, 4)
                .Select(_ => (A: random.NextDouble() * 1.5, U: random.Next(40) - 20, V: random.Next(40) - 20, P: random.Next(360))).ToArray();
            var step = random.NextDouble() * 4;
            var field = Smooth(Roof((x, y) => 6 + (x > 12 ? step : 0) + waves.Sum(w => w.A * Angle.Sin(w.U * x + w.V * y + w.P)), 25)).Value!;
            var least = 0.08 / Angle.Cos(28.6);
            for (var i = 0; i < 300; i++)
            {
                double x = random.NextDouble() * 20, y = random.NextDouble() * 10;
                var layer = random.Next(1, 70);
                double low = field.Height(x, y, 0.2 * layer), high = field.Height(x, y, 0.2 * (layer + 1));
                Assert.That(high - low, Is.InRange(least - 1e-3, 0.3 + 1e-9), $"Layer {layer} at {x}, {y}");
                var point = new Vec3(x, y, low + random.NextDouble() * (high - low));
                var normal = field.Normal(point);
                Assert.That(Angle.Atan2(normal.LengthXY, normal.Z), Is.LessThan(30.2));
                Assert.That(field.Height(x, y, field.Value(point)), Is.EqualTo(point.Z).Within(1e-9));
                Assert.That(field.Height(x, y, 0.2), Is.EqualTo(0.2));
            }
        }
    }

    [Test]
    public void What_is_level_beside_a_slope_stays_level()
    {
        // A step that is level, at a height that is no border of layers, beside a ramp.
        double Top(double x, double y) => x < 8 ? 3.05 : x < 9 ? 3.05 + (x - 8) * 2 : 5.05 + 0.15 * (x - 9);
        var field = Smooth(Roof(Top, 20)).Value!;
        var level = field.Value(new Vec3(4, 4, 3.05));
        Assert.That(level / 0.2, Is.EqualTo(Math.Round(level / 0.2)).Within(1e-6));
        for (var x = 0.0; x <= 7.9; x += 0.3) Assert.That(field.Value(new Vec3(x, 5, 3.05)), Is.EqualTo(level).Within(1e-9));
        var ramp = field.Value(new Vec3(12, 4, Top(12, 4)));
        for (var x = 9.5; x <= 20; x += 0.3) Assert.That(field.Value(new Vec3(x, 5, Top(x, 5))), Is.EqualTo(ramp).Within(1e-3));
    }

    [Test]
    public void A_level_plate_is_sliced_as_in_planar_slicing()
    {
        var plate = new[] { new NamedMesh("plate", Solids.Block(0, 0, 0, 20, 10, 4)) };
        var smooth = LayerField.Smooth(plate, Setup);
        Assert.That(smooth.Diagnostics.Select(d => (d.Severity, d.Code)), Is.EqualTo(new[] { (Severity.Note, "curved.smooth_level") }));
        var planar = PlanarSlicer.Slice(plate, Setup.Settings).OrThrow();
        var curved = CurvedSlicer.Slice(plate, smooth.Value!, Setup).OrThrow();
        Assert.That(curved.Layers.Select(Text), Is.EqualTo(planar.Layers.Select(Text)));

        static string Text(SlicedLayer layer)
            => string.Join("\n", layer.Steps.Select(s => s.Path.Role + " " + string.Join(" ", s.Path.Points.Select(p => p.ToString()))));
    }

    [Test]
    public void A_slope_down_to_the_bed_keeps_steps_where_layers_would_be_too_thin_and_tells_where()
    {
        var smooth = Smooth(Roof((x, _) => 0.3 + 0.5 * x));
        var note = smooth.Diagnostics.Single();
        Assert.That((note.Severity, note.Code), Is.EqualTo((Severity.Note, "curved.smooth_left_out")));
        Assert.That(note.Message, Does.Match(@"^\d+ mm² of sloped tops keep their steps, for example at \("));
        // Most of the higher half is in one layer.
        var value = smooth.Value!.Value(new Vec3(14, 5, 7.3));
        for (var x = 9.5; x <= 18.9; x += 0.3) Assert.That(smooth.Value.Value(new Vec3(x, 5, 0.3 + 0.5 * x)), Is.EqualTo(value).Within(1e-6));
    }

    // Thickness is measured across layers, which slope by 1.5° less than they may, and by 45° at most.
    [TestCase(30.1, 0, 0.091)]
    [TestCase(80, 0, 0.113)]
    [TestCase(30.1, 2, 0.171)]
    [TestCase(30.1, 3, 0.114)]
    public void Layers_are_as_thin_as_their_slope_and_the_ratio_of_gaps_allow(double slope, double ratio, double least)
    {
        var setup = Setup with { Settings = Setup.Settings with { CurvedMaxSlope = slope, CurvedMaxGapRatio = ratio } };
        var note = LayerField.Smooth([new NamedMesh("slope", Roof((x, _) => 0.25 + 0.05 * x))], setup).Diagnostics.Single();
        Assert.That(note.Message, Does.EndWith($"there layers would be thinner than {NumberFormatter.Format(least, 3)} mm, thicker than 0.3 mm or too steep."));
    }

    [Test]
    public void The_beads_of_a_smooth_top_end_on_its_surface_and_hold_its_volume()
    {
        var part = Roof((x, _) => 4 + 0.1 * x);
        var setup = Setup with { Settings = CurvedSolids.Massive with { LayerHeight = 0.2, FirstLayerHeight = 0.2, CurvedMaxGap = 0.3 } };
        var models = new[] { new NamedMesh("wedge", part) };
        var field = LayerField.Smooth(models, setup).OrThrow();
        var result = CurvedSlicer.Slice(models, field, setup).OrThrow();
        var paths = result.Layers.SelectMany(l => l.Steps).Select(s => s.Path).ToArray();
        var volume = paths.Sum(p => Enumerable.Range(0, p.SegmentCount).Sum(i => p.BeadOf(i).Area * p.LengthOf(i)));
        Assert.That(volume, Is.EqualTo(1000).Within(2).Percent);
        var top = result.Layers[result.Layers.Count - 1].Steps.SelectMany(s => s.Path.Points).ToArray();
        Assert.That(top, Is.Not.Empty);
        Assert.That(top.Max(p => Math.Abs(p.Z - 4 - 0.1 * p.X)), Is.LessThan(0.02));
    }

    // Nozzle of 0.4 mm, lines of 0.45 mm. A wall of 0.4 mm rises by 0.08 mm across a slope of 0.2; on steeper ones it has its least width.
    [TestCase(0.1, 0, 0)]
    [TestCase(0.2, 0, 0.4)]
    [TestCase(0.4, 0, 0.35)]
    [TestCase(0.4, 0.5, 0.5)]
    public void Outer_walls_across_steeper_tops_are_narrower_unless_their_width_is_set(double slope, double set, double width)
    {
        var field = Smooth(Roof((x, _) => 4 + slope * x)).Value!;
        Assert.That(field.Suited(Setup.Settings with { OuterWallLineWidth = set }).OuterWallLineWidth, Is.EqualTo(width).Within(1e-9));
    }

    [Test]
    public void Samples_of_a_top_go_on_beyond_its_edges_by_one_node_on_all_sides()
    {
        // A roof of 4 × 2 mm that rises by 0.25, on nodes 0.5 mm apart that begin 1 mm outside of it.
        var grid = new SlopeGrid(new Vec3(-1, -1), 0.5, 13, 9);
        var part = CurvedSolids.Between(CurvedSolids.Plan(0.01, 0.01, 3.99, 1.99), 1, (_, _) => 0, (x, _) => 3 + 0.25 * x);
        var samples = new TopSamples([part], grid, 0.5);
        var tops = Enumerable.Range(0, samples.All.Count).Where(i => samples.All[i].Visible).ToArray();
        Assert.That(tops, Has.Length.EqualTo(7 * 3), "the nodes inside");
        Assert.That(tops.Select(samples.PieceOf).Distinct().Count(), Is.EqualTo(1));
        var edges = samples.WithEdges(tops).ToArray();
        Assert.That(edges.Select(e => e.Node).Distinct().Count(), Is.EqualTo(edges.Length));
        Assert.That(edges, Has.Length.EqualTo(9 * 5));
        foreach (var (node, height) in edges) Assert.That(height, Is.EqualTo(3 + 0.25 * grid.At(node).X).Within(1e-9));
        Assert.That(edges.Min(e => grid.At(e.Node).X), Is.Zero);
        Assert.That(edges.Max(e => grid.At(e.Node).X), Is.EqualTo(4));
        // Its bottom is level, unseen, and a piece of its own.
        var bottoms = Enumerable.Range(0, samples.All.Count).Except(tops).ToArray();
        Assert.That(bottoms.Select(i => (samples.All[i].Height, samples.All[i].Slope)).Distinct(), Is.EqualTo(new[] { (0.0, 0.0) }));
        Assert.That(bottoms.Select(samples.PieceOf).Intersect(tops.Select(samples.PieceOf)), Is.Empty);
    }

    [TestCase(1, 0, 0)]
    [TestCase(0, 1, 90)]
    [TestCase(1, 1, 45)]
    public void Solid_infill_runs_down_the_slope_of_a_smooth_top(double byX, double byY, double degrees)
    {
        var models = new[] { new NamedMesh("roof", Roof((x, y) => 4 + 0.05 * (byX * x + byY * y))) };
        var field = LayerField.Smooth(models, Setup).OrThrow();
        var layers = CurvedSlicer.Slice(models, field, Setup).OrThrow().Layers;
        var top = layers[layers.Count - 1].Steps.Select(s => s.Path).Where(p => p.Role == Role.TopSurface)
            .SelectMany(p => p.Points.Zip(p.Points.Skip(1), (a, b) => b - a)).Where(d => d.LengthXY > 3).ToArray();
        Assert.That(top, Is.Not.Empty);
        foreach (var d in top) Assert.That(Math.Abs(Vec3.Cross(d.WithZ(0).Unit(), new Vec3(Angle.Cos(degrees), Angle.Sin(degrees))).Z), Is.LessThan(0.02));
    }

    [Test]
    public void Steep_tops_and_nothing_at_all_have_level_layers()
    {
        Assert.That(Smooth(Roof((x, _) => 1 + x)).Diagnostics.Single().Code, Is.EqualTo("curved.smooth_level"));
        Assert.That(Smooth().Value!.Value(new Vec3(1, 2, 3)), Is.EqualTo(3));
        Assert.That(Smooth(TriMesh.Create([], [])).Value!.Value(new Vec3(1, 2, 3)), Is.EqualTo(3));
        Assert.That(() => LayerField.Smooth(null!, Setup), Throws.ArgumentNullException);
        Assert.That(() => LayerField.Smooth([], null!), Throws.ArgumentNullException);
    }

    [Test]
    public void Surfaces_below_given_heights_are_those_of_all_pairs_of_nodes()
    {
        var grid = SlopeGrid.Over(new Bounds(Vec3.Zero, new Vec3(8, 5, 1)), 1e9);
        var random = new Random(3);
        var given = Enumerable.Range(0, grid.Count).Select(_ => random.NextDouble() < 0.1 ? random.NextDouble() * 3 : double.PositiveInfinity).ToArray();
        var heights = (double[])given.Clone();
        grid.Lower(heights, 0.5);
        for (var node = 0; node < grid.Count; node++)
        {
            double straight = double.PositiveInfinity, detour = double.PositiveInfinity;
            for (var from = 0; from < grid.Count; from++)
            {
                var distance = grid.At(node).DistanceTo(grid.At(from));
                straight = Math.Min(straight, given[from] + 0.5 * distance);
                detour = Math.Min(detour, given[from] + 0.5 * distance * SlopeGrid.Detour);
            }
            Assert.That(heights[node], Is.InRange(straight - 1e-9, detour + 1e-9));
        }
    }
}

using System;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>How far layers may bend, which tops lie in one, and what becomes of the others.</summary>
[Category("Arithmetic")]
public class SmoothLayerTests
{
    // The first layer is 0.2 mm, the others 0.1 to 0.3 mm.
    private static readonly LayerRules Rules = new(0.2, 0.2, 0.1, 0.3, 0.1);

    [Test]
    public void Numbers_of_layers_follow_from_heights_and_thickness()
    {
        var rules = Rules with { First = 0.3 };
        Assert.That(new[] { rules.Height(0), rules.Height(1), rules.Height(4) }, Is.EqualTo(new[] { 0, 0.3, 0.9 }).Within(1e-12));
        Assert.That(new[] { rules.Upper(3), rules.Upper(-2), rules.Lower(3), rules.Lower(-2) }, Is.EqualTo(new[] { 0.9, -0.2, 0.3, -0.6 }).Within(1e-12));
        int[] Fewest(params double[] heights) => Array.ConvertAll(heights, rules.Fewest);
        int[] Most(params double[] heights) => Array.ConvertAll(heights, rules.MostLayers);
        Assert.That(Fewest(0.9, 0.91, 0.01, 0, -0.2, -0.55), Is.EqualTo(new[] { 3, 4, 1, 0, -2, -5 }));
        Assert.That(Most(0.3, 0.29, 0.01, 0, -0.6, -0.55), Is.EqualTo(new[] { 3, 2, 0, 0, -2, -2 }));
        var half = rules.With(0.5);
        Assert.That(new[] { half.Least, half.Most, half.Usual }, Is.EqualTo(new[] { 0.15, 0.25, 0.2 }).Within(1e-12));
    }

    [TestCase(0.4, 0.2, 0, 0, 0.06, 0.3)]
    [TestCase(0.4, 0.1, 0, 0, 0.05, 0.3)]
    [TestCase(0.8, 0.7, 0, 0, 0.12, 0.7)]
    [TestCase(0.4, 0.2, 0.03, 0.9, 0.03, 0.9)]
    public void The_thinnest_and_the_thickest_layer_are_shares_of_the_nozzle_unless_they_are_set(
        double nozzle, double height, double leastGap, double mostGap, double least, double most)
    {
        var setup = new PrintSetup
        {
            Printer = new Printer { NozzleDiameter = nozzle },
            Settings = new PrintSettings { LayerHeight = height, FirstLayerHeight = height, CurvedMinGap = leastGap, CurvedMaxGap = mostGap },
        };
        Assert.That(new[] { LayerRules.LeastGap(setup), LayerRules.GreatestGap(setup) }, Is.EqualTo(new[] { least, most }).Within(1e-12));
    }

    // Layer 3 as high as it can be at one node, or layer 4 as low; around it, they come back by 0.1 mm per mm.
    [TestCase(3, 0.8, 0, new[] { 0.2, 0.5, 0.8, 0.9, 1, 1.2, 1.4 })]
    [TestCase(3, 0.8, 1, new[] { 0.2, 0.4, 0.7, 0.8, 1, 1.2, 1.4 })]
    [TestCase(3, 0.8, 2, new[] { 0.2, 0.4, 0.6, 0.8, 1, 1.2, 1.4 })]
    [TestCase(4, 0.5, 0, new[] { 0.2, 0.3, 0.4, 0.5, 0.8, 1.1, 1.4 })]
    [TestCase(4, 0.5, 1, new[] { 0.2, 0.4, 0.5, 0.6, 0.9, 1.2, 1.4 })]
    [TestCase(4, 0.5, 2, new[] { 0.2, 0.4, 0.6, 0.7, 1, 1.2, 1.4 })]
    public void A_layer_at_a_given_height_moves_the_others_no_more_than_it_must(int layer, double height, double distance, double[] heights)
    {
        var field = Bent(layer, height);
        for (var k = 0; k < heights.Length; k++)
        {
            var level = 0.2 * (k + 1);
            Assert.That(field.Height(2 + distance, 2, level), Is.EqualTo(heights[k]).Within(1e-9), $"layer {k + 1}");
            Assert.That(field.Value(new Vec3(2, 2 - distance, heights[k])), Is.EqualTo(level).Within(1e-9), $"layer {k + 1}");
            var (first, second) = field.Heights(2 - distance, 2, level, level + 5);
            Assert.That((first, second), Is.EqualTo((heights[k], heights[6] + level + 5 - 1.4)).Within(1e-9));
        }
    }

    [Test]
    public void Between_nodes_and_layers_heights_are_linear_and_go_on_evenly_above_and_below()
    {
        var field = Bent(3, 0.8);
        Assert.That(field.Height(2.5, 2, 0.6), Is.EqualTo(0.75).Within(1e-9));
        Assert.That(field.Height(2.5, 2.5, 0.6), Is.EqualTo((0.8 + 0.7 + 0.7 + 0.8 - 0.1 * Math.Sqrt(2)) / 4).Within(1e-9));
        Assert.That(field.Height(2, 2, 0.5), Is.EqualTo(0.65).Within(1e-9));
        Assert.That(field.Value(new Vec3(2, 2, 0.65)), Is.EqualTo(0.5).Within(1e-9));
        Assert.That(field.Spread(new Vec3(2, 2, 0.65)), Is.EqualTo(1.5).Within(1e-9));
        Assert.That(new[] { field.Height(2, 2, 2.4), field.Height(2, 2, 0.1), field.Height(2, 2, -1) }, Is.EqualTo(new[] { 2.4, 0.1, -1 }).Within(1e-9));
        Assert.That(new[] { 2.4, 0.1, -1 }.Select(z => field.Value(new Vec3(2, 2, z))), Is.EqualTo(new[] { 2.4, 0.1, -1 }).Within(1e-9));
        // Down by 0.2 mm over 2 mm.
        var normal = field.Normal(new Vec3(3, 2, 0.7));
        Assert.That(new[] { normal.X / normal.Z, normal.Y }, Is.EqualTo(new[] { 0.1, 0 }).Within(1e-9));
        Assert.That((field.Detail, field.StartsLevel), Is.EqualTo((2.0, true)));
    }

    [Test]
    public void Settings_for_a_slope_have_one_wall_on_top_lines_down_the_slope_and_narrow_walls()
    {
        var usual = new PrintSettings { LineWidth = 0.45 };
        var suited = Bent(3, 0.8).Suited(usual);
        Assert.That((suited.OnlyOneWallTop, suited.SolidInfillAngle, suited.OuterWallLineWidth), Is.EqualTo((true, 12.0, 0.4)));
        suited = Bent(3, 0.8).Suited(usual with { SolidInfillAngle = 7, LineWidth = 0.4 });
        Assert.That((suited.SolidInfillAngle, suited.OuterWallLineWidth), Is.EqualTo((7.0, 0.0)));
    }

    // Two tops that rise by 0.01, one 0.05 mm above the other: too near for two layers, too steep for one. From the edge of the larger one on, a layer can
    // differ from it by 0.02 mm per mm, so that there is room for the next layer after 1.67 mm: four columns of 20 nodes are in none.
    [TestCase(14, 10, 11, 14.25, 15.75, -90)]
    [TestCase(6, 11, 10, 4.25, 5.75, 0)]
    public void Of_two_tops_too_near_for_their_layers_the_smaller_one_keeps_steps_beside_the_larger(
        double border, int larger, int smaller, double from, double to, double angle)
    {
        var (plan, samples, grid) = Plan(Rules with { Slope = 0.02 }, (0, border, x => 2 + 0.01 * x), (border, 20, x => 2.05 + 0.01 * x));
        Assert.That(plan.Layers.Select(l => l.Number), Is.EqualTo(new[] { 10, 11 }));
        Assert.That(plan.Layers.Single(l => l.Number == larger).Places, Has.Count.GreaterThan(plan.Layers.Single(l => l.Number == smaller).Places.Count));
        Assert.That(plan.LeftOut.Select(s => grid.At(samples.All[s].Node).X), Is.All.InRange(from, to));
        Assert.That(plan.LeftOut, Has.Count.EqualTo(4 * 20));
        Assert.That((plan.Steepest, plan.Angle), Is.EqualTo((0.01, angle)).Within(1e-9));
    }

    [TestCase(30)]
    [TestCase(70)]
    public void Lines_run_down_or_across_a_slope_whatever_its_direction(double degrees)
    {
        var (sin, cos) = Angle.SinCos(degrees);
        var mesh = CurvedSolids.Between(CurvedSolids.Plan(0, 0, 20, 10), 1, (_, _) => 0, (x, y) => 2 + 0.02 * (cos * x + sin * y));
        var grid = new SlopeGrid(new Vec3(-0.75, -0.75), 0.5, 43, 23);
        var plan = new SmoothPlan(new TopSamples([mesh], grid, Rules.Slope), grid, Rules);
        plan.Run(CancellationToken.None);
        Assert.That((plan.Angle + 180) % 90, Is.EqualTo(degrees).Within(1e-6));
    }

    // A slope from the bed up: layer 3 is 0.4 to 0.8 mm high and has most of it. Of the rest, layer 2 is at least 0.3 mm high, and stays 0.1 mm below layer 3.
    [Test]
    public void Where_layers_would_be_too_thin_a_slope_is_in_none()
    {
        var (plan, samples, grid) = Plan(Rules with { Slope = 0.05 }, (0, 20, x => 0.2 + 0.03 * x));
        Assert.That(plan.Layers.Select(l => l.Number), Is.EqualTo(new[] { 2, 3 }));
        var columns = plan.LeftOut.Select(s => grid.At(samples.All[s].Node).X).Distinct().OrderBy(x => x);
        Assert.That(columns, Is.EqualTo(new[] { 0.25, 0.75, 1.25, 1.75, 2.25, 2.75, 3.25, 5.75, 6.25 }));
        Assert.That(plan.LeftOut, Has.Count.EqualTo(9 * 20));
        Assert.That(plan.Layers.All(l => l.Places.All(p => l.Lower[p.Node] <= p.Height && p.Height <= l.Upper[p.Node])));
    }

    [Test]
    public void A_top_of_less_than_a_square_millimeter_is_left_alone()
    {
        // 3 × 20 nodes of 0.25 mm², and 3.
        Assert.That(Plan(Rules, (0, 1.5, x => 2 + 0.05 * x)).Plan.Layers, Has.Count.EqualTo(1));
        var (plan, _, _) = Plan(Rules, 0.5, (0, 1.5, x => 2 + 0.05 * x));
        Assert.That((plan.Layers.Count, plan.Steepest, plan.LeftOut.Count), Is.EqualTo((0, 0.0, 3)));
    }

    [Test]
    public void A_canceled_plan_stops()
    {
        using var source = new CancellationTokenSource();
        source.Cancel();
        var (grid, samples) = Samples(Rules, 10, (0, 20, x => 2 + 0.01 * x));
        Assert.That(() => new SmoothPlan(samples, grid, Rules).Run(source.Token), Throws.InstanceOf<OperationCanceledException>());
    }

    private static SmoothField Bent(int layer, double height)
    {
        var grid = new SlopeGrid(Vec3.Zero, 1, 6, 6);
        return new SmoothField(grid, Rules, [FixedLayer.Of(layer, [(14, height)], grid, 0.1)], 7, 12, 0.4);
    }

    private static (SmoothPlan Plan, TopSamples Samples, SlopeGrid Grid) Plan(
        LayerRules rules, params (double From, double To, Func<double, double> Top)[] parts)
        => Plan(rules, 10, parts);

    private static (SmoothPlan Plan, TopSamples Samples, SlopeGrid Grid) Plan(
        LayerRules rules, double depth, params (double From, double To, Func<double, double> Top)[] parts)
    {
        var (grid, samples) = Samples(rules, depth, parts);
        var plan = new SmoothPlan(samples, grid, rules);
        plan.Run(CancellationToken.None);
        return (plan, samples, grid);
    }

    // Nodes 0.5 mm apart, a quarter of a millimeter inside of the edges.
    private static (SlopeGrid Grid, TopSamples Samples) Samples(
        LayerRules rules, double depth, params (double From, double To, Func<double, double> Top)[] parts)
    {
        var meshes = parts.Select(p => CurvedSolids.Between(CurvedSolids.Plan(p.From, 0, p.To, depth), 1, (_, _) => 0, (x, _) => p.Top(x))).ToArray();
        var grid = new SlopeGrid(new Vec3(-0.75, -0.75), 0.5, 43, 23);
        return (grid, new TopSamples(meshes, grid, rules.Slope));
    }
}

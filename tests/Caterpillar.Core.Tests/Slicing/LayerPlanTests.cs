using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class LayerPlanTests
{
    private static readonly PrintSettings Plain = new() { LayerHeight = 0.2, FirstLayerHeight = 0.3 };

    [Test]
    public void Layers_follow_the_first_one_without_drifting()
    {
        var layers = Plan(Plain, Solids.Block(0, 0, 0, 5, 5, 100));
        Assert.That(layers, Has.Length.EqualTo(499));
        Assert.That(layers[0], Is.EqualTo(new PlannedLayer(0.3, 0.3, 0.15)));
        Assert.That(layers[498].Top, Is.EqualTo(0.3 + 498 * 0.2).Within(1e-12));
        var low = Plan(Plain with { SlicingPlane = SlicingPlane.Bottom }, Solids.Block(0, 0, 0, 5, 5, 1));
        Assert.That(low.Select(l => l.Cut), Is.EqualTo(new[] { 0.01, 0.31, 0.51, 0.71, 0.91 }).Within(1e-9));
    }

    [Test]
    public void Ranges_of_heights_have_their_own_thickness()
    {
        var settings = Plain with { FirstLayerHeight = 0.2, LayerRanges = new ValueList<LayerRange>(new LayerRange(1, 2, 0.1)) };
        var layers = Plan(settings, Solids.Block(0, 0, 0, 5, 5, 3));
        var wanted = Enumerable.Range(0, 20).Select(i => i is >= 5 and < 15 ? 0.1 : 0.2);
        Assert.That(layers.Select(l => l.Thickness), Is.EqualTo(wanted));
        Assert.That(layers.Last().Top, Is.EqualTo(3).Within(1e-9));
    }

    [Test]
    public void A_formula_gives_the_thickness_at_each_height()
    {
        var layers = Plan(Plain with { FirstLayerHeight = 0.1, LayerFormula = "0.1 + 0.1 * z" }, Solids.Block(0, 0, 0, 5, 5, 2));
        for (var i = 1; i < layers.Length; i++) Assert.That(layers[i].Thickness, Is.EqualTo(0.1 + 0.1 * layers[i - 1].Top).Within(1e-9));
        var wrong = new LayerPlan(Solids.Block(0, 0, 0, 5, 5, 2), Plain with { LayerFormula = "1 - z" }).Layers();
        Assert.That(wrong.Diagnostics.Single().Code, Is.EqualTo("slice.layer_formula"));
        Assert.That(() => new PrintSettings { LayerFormula = "1 +" }, Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void Adaptive_layers_keep_the_cusp_and_end_at_level_facets()
    {
        // A cone of 45° on a block 3.05 mm high: upright walls, then cosines of 0.707.
        var settings = Plain with { FirstLayerHeight = 0.2, AdaptiveLayers = true, AdaptiveMinHeight = 0.05, AdaptiveMaxHeight = 0.3,
            AdaptiveCuspHeight = 0.1 };
        var mesh = TriMesh.Merge([Solids.Block(-20, -20, 0, 20, 20, 3.05), Solids.Cone(3.05, 10, 8.05, 5)]);
        var layers = Plan(settings, mesh);
        var slope = 0.1 / Math.Sqrt(0.5);
        Assert.That(layers.Where(l => l.Top < 2.5).Skip(1).Select(l => l.Thickness), Is.All.EqualTo(0.3).Within(1e-9));
        Assert.That(layers.Any(l => Math.Abs(l.Top - 3.05) < 1e-4), Is.True);
        Assert.That(layers.Where(l => l.Top > 3.1).Select(l => l.Thickness), Is.All.LessThan(slope + 1e-3));
        Assert.That(layers.Where(l => l.Top > 3.4 && l.Top < 7.5).Select(l => l.Thickness), Is.All.GreaterThan(slope - 0.003));
        Assert.That(layers.Last().Top, Is.EqualTo(8.05).Within(1e-3));
        var post = Plan(settings, TriMesh.Merge([Solids.Cone(0, 20, 3, 11), Solids.Cone(3, 10, 9, 10)]));
        Assert.That(post.Where(l => l.Top > 0.3 && l.Top < 2.5).Select(l => l.Thickness), Is.All.LessThan(0.12));
        Assert.That(post.Where(l => l.Top > 3.5 && l.Top < 8.4).Select(l => l.Thickness), Is.All.EqualTo(0.3).Within(1e-9), "what is below does not count");
    }

    [Test]
    public void Too_many_layers_are_an_error()
    {
        var plan = new LayerPlan(Solids.Block(0, 0, 0, 1, 1, 2000), Plain with { LayerHeight = 0.001 }).Layers();
        Assert.That((plan.Value, plan.Diagnostics.Single().Code), Is.EqualTo(((PlannedLayer[]?)null, "slice.too_many_layers")));
    }

    private static PlannedLayer[] Plan(PrintSettings settings, TriMesh mesh) => new LayerPlan(mesh, settings).Layers().Value!;
}

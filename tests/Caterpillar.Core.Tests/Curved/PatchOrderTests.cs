using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>
/// The order of pieces of layers beside each other, with the head of the generic printer: its cone reaches 4 mm at 6 mm, the head 20 mm at 12 mm.
/// </summary>
public class PatchOrderTests
{
    private static readonly PrintSetup Setup = new()
    {
        Settings = CurvedSolids.Massive with { InfillDensityPercent = 20, WallCount = 2, ZHopType = ZHopType.AbovePath },
    };

    [Test]
    public void Branches_whose_layers_rise_unevenly_are_printed_so_that_the_head_meets_neither()
    {
        var sliced = Towers(20, 8);
        Assert.That(sliced.Diagnostics.Select(d => d.Code), Does.Contain("curved.order"));
        Assert.That(Findings(sliced.Value!.ToSteps(), "collision."), Is.Empty);
        Assert.That(Findings(sliced.Value.ToSteps(), CheckCodes.Unsupported), Is.Empty, "no piece is printed before what it lies on");
        // By layers the higher tower would block the head over the lower one.
        var byLayer = sliced.Value.Layers.OrderBy(l => l.Layer.Z).SelectMany(l => l.Steps).ToArray();
        Assert.That(Findings(byLayer, "collision."), Is.Not.Empty);
        Assert.That(sliced.Value.Layers.Select(l => l.Layer.Index), Is.EqualTo(Enumerable.Range(0, sliced.Value.Layers.Count)));
        Assert.That(sliced.Value.Layers.SelectMany(l => l.Steps).All(s => s.Path.Layer!.Index == s.Group!.Value.Layer));
        foreach (var layer in sliced.Value.Layers)
        {
            Assert.That(layer.Steps.All(s => layer.Region.Contains(s.Path.Start.X, s.Path.Start.Y)), "a piece covers what it prints");
            Assert.That(layer.Region.Contours.Select(c => c.Points[0].X < 15).Distinct(),
                Is.EquivalentTo(layer.Steps.Select(s => s.Path.Start.X < 15).Distinct()), "and nothing else");
        }
        // 40 layers in order are 40 changes from one tower to the other at least.
        var sides = sliced.Value.ToSteps().OfType<PathStep>().Select(s => s.Path.Start.X < 15).ToArray();
        Assert.That(sides.Zip(sides.Skip(1), (a, b) => a != b).Count(c => c), Is.LessThan(20));
    }

    [Test]
    public void Nothing_is_lost_or_printed_twice()
    {
        var sliced = Towers(20, 8).Value!;
        double Volume(bool left) => sliced.ToSteps().OfType<PathStep>().Where(s => s.Path.Start.X < 15 == left)
            .Sum(s => Enumerable.Range(0, s.Path.SegmentCount).Sum(i => s.Path.LengthOf(i) * s.Path.BeadOf(i).Area));
        Assert.That(Volume(false) / Volume(true), Is.EqualTo(8.0 / 20).Within(0.02));
    }

    [Test]
    public void Layers_that_do_not_collide_keep_their_order()
    {
        var sliced = Towers(20, 17);
        Assert.That(sliced.Diagnostics.Select(d => d.Code), Has.None.EqualTo("curved.order"));
        Assert.That(sliced.Value!.Layers.Select(l => l.Layer.Z), Is.Ordered);
        Assert.That(sliced.Value.Layers, Has.Count.EqualTo(40));
    }

    [Test]
    public void Pieces_that_block_each_other_are_named()
    {
        // Two ramps beside each other, one up, one down: each has an end high above the other.
        static double Rise(double x, double y) => y < 10 ? 0.5 * x : 20 - 0.5 * x;
        var ramps = new[] { 0.0, 12 }.Select(y => CurvedSolids.Between(new Bounds(new Vec3(0, y), new Vec3(40, y + 6)), 8, Rise,
            (a, b) => Rise(a, b) + 1)).ToArray();
        var sliced = CurvedSlicer.Slice([new NamedMesh("ramps", TriMesh.Merge(ramps))], LayerField.Of(p => p.Z - Rise(p.X, p.Y)),
            Setup with { Settings = Setup.Settings with { CurvedMaxSlope = 60 } });
        var found = sliced.Diagnostics.Single(d => d.Code == "curved.blocked_pieces");
        Assert.That(found.Severity, Is.EqualTo(Severity.Warning));
        Assert.That(found.Message, Does.Contain("layer 1 at ").And.Contain("block each other"));
        Assert.That(sliced.Value!.Layers.Select(l => l.Layer.Z), Is.Ordered);
    }

    [Test]
    public void Boxes_of_the_head_and_the_gantry_count_too()
    {
        var boxed = Setup with { Printer = Setup.Printer with
        {
            HeadOutline = new(new HeadPoint(0.5, 0), new(1, 6)), HeadBoxes = new(new Bounds(new Vec3(-30, -5, 7), new Vec3(30, 5, 40))),
        } };
        var aside = boxed with { Printer = boxed.Printer with { HeadBoxes = new(new Bounds(new Vec3(-5, 15, 7), new Vec3(5, 30, 40))) } };
        var beam = boxed with { Printer =
            boxed.Printer with { HeadBoxes = ValueList<Bounds>.Empty, Gantry = new(new Bounds(new Vec3(0, -3, 7), new Vec3(0, 3, 40))) } };
        bool IsReordered(PrintSetup setup) => Towers(20, 8, setup).Diagnostics.Any(d => d.Code == "curved.order");
        Assert.That((IsReordered(boxed), IsReordered(aside), IsReordered(beam)), Is.EqualTo((true, false, true)));
    }

    // Two towers 10 mm apart with as many layers each, 0.5 mm thick in the left one.
    private static Result<CurvedResult> Towers(double left, double right, PrintSetup? setup = null)
    {
        var towers = TriMesh.Merge([
            CurvedSolids.Between(new Bounds(new Vec3(0, 0), new Vec3(10, 10)), 4, (_, _) => 0, (_, _) => left),
            CurvedSolids.Between(new Bounds(new Vec3(20, 0), new Vec3(30, 10)), 4, (_, _) => 0, (_, _) => right)]);
        return CurvedSlicer.Slice([new NamedMesh("towers", towers)], LayerField.Of(p => p.X < 15 ? p.Z : p.Z * left / right), setup ?? Setup);
    }

    private static IEnumerable<Diagnostic> Findings(IReadOnlyList<Step> steps, string code)
    {
        var setup = Setup with { Settings = Setup.Settings with { SortPaths = false } };
        return PrintCheck.Run(Planner.Plan(steps, setup).OrThrow(), setup).Where(d => d.Code.StartsWith(code, StringComparison.Ordinal));
    }
}

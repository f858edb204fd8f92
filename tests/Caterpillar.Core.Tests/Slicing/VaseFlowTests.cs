using System.Linq;
using System.Threading;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

/// <summary>The turns of a vase are one wall: compensation of the pressure lag holds for its two ends.</summary>
[TestFixture]
public class VaseFlowTests
{
    private static readonly PrintSetup Setup = new PrintSetup().With(
        "spiral_vase=true bottom_layers=0 bottom_thickness_mm=0 coasting_distance_mm=2 start_distance_mm=1 skirt_loops=0 min_layer_time_s=0".Split(' ')).Value!;

    [Test]
    public void Material_flows_from_turn_to_turn([Values] bool layerByLayer)
    {
        var plan = Plan(Setup, layerByLayer, 0);
        Assert.That(plan.Report.LaggedPaths, Is.EqualTo(2), "the first turn and the last one");
        Assert.That(Primes(plan), Is.EqualTo(1));
        Assert.That(Coasts(plan), Is.EqualTo(1));
    }

    [Test]
    public void One_vase_after_the_other_begins_and_ends_once_each()
    {
        var plan = Plan(Setup with { Settings = Setup.Settings with { PrintSequence = PrintSequence.ByObject } }, false, 0, 40);
        Assert.That(plan.Report.LaggedPaths, Is.EqualTo(4));
        Assert.That((Primes(plan), Coasts(plan)), Is.EqualTo((2, 2)));
    }

    [Test]
    public void Turns_between_which_the_head_leaves_are_compensated_each([Values] bool layerByLayer)
    {
        var plan = Plan(Setup, layerByLayer, 0, 40);
        var turns = plan.Report.Paths;
        Assert.That(turns, Is.GreaterThan(20));
        Assert.That(plan.Report.LaggedPaths, Is.EqualTo(turns));
        Assert.That(Coasts(plan), Is.EqualTo(turns));
    }

    private static Plan Plan(PrintSetup setup, bool layerByLayer, params double[] places)
    {
        var cups = places.Select((x, i) => new NamedMesh($"cup {i}", Solids.Cone(0, 6, 4, 10, 24).Moved(new Vec3(x, 0, 0)))).ToArray();
        var sliced = PlanarSlicer.Slice(cups, setup.Settings).Value!;
        if (!layerByLayer) return Planner.PlanWithReport(sliced.ToSteps(), setup).Value!;
        var run = Planner.Begin(setup, null, _ => { }, CancellationToken.None);
        foreach (var level in sliced.Layers.GroupBy(l => l.Layer.Z)) run.Add(level.SelectMany(l => l.Steps).ToArray(), null);
        return run.Finish().Value!;
    }

    private static int Primes(Plan plan) => plan.Toolpath.Moves().Count(m => m.Kind == MoveKind.Prime);

    // Moves without material on from an extrusion, in its direction.
    private static int Coasts(Plan plan)
    {
        var moves = plan.Toolpath.Moves().ToArray();
        return Enumerable.Range(1, moves.Length - 1).Count(i => moves[i].Kind == MoveKind.Travel && moves[i - 1].Kind == MoveKind.Print
            && moves[i].Speed == moves[i - 1].Speed);
    }
}

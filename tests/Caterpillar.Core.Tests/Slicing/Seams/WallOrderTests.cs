using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

public class WallOrderTests
{
    private static readonly PrintSettings Bare = new()
    {
        LineWidth = 0.4, BeadShape = BeadShape.Rectangle, Resolution = 0, TopLayers = 0, BottomLayers = 0, InfillDensityPercent = 0,
        WallCount = 3, MinLayerTime = 0, SeamGap = 0,
    };

    // A square frame of 30 mm with a hole of 10 mm.
    private static TriMesh[] Ring =>
        [Solids.Block(0, 0, 0, 30, 10, 1), Solids.Block(0, 20, 0, 30, 30, 1), Solids.Block(0, 0, 0, 10, 30, 1), Solids.Block(20, 0, 0, 30, 30, 1)];

    // Lengths of the loops in planned order: 4 · (30 − 0.4, 1.2, 2) outside, 4 · (10 + 0.4) around the hole. The inner ones have round corners there: two
    // chords of 45° at 0.4 mm, and what touches those 0.4 mm farther out.
    private static double[] PlannedLoops(PrintSettings settings, int layer)
    {
        var layers = Solids.Slice(settings, Ring);
        var plan = Planner.Plan(layers[layer].Steps.Cast<Step>().ToArray(), new PrintSetup { Settings = settings }).Value!;
        var printed = plan.Moves().Where(m => m.Kind == MoveKind.Print).ToArray();
        return printed.Select(m => m.Source).Distinct().Select(s => printed.Where(m => m.Source == s).Sum(m => m.Length)).ToArray();
    }

    private static readonly double[] Outside = [118.4, 115.2, 112];
    private static readonly double[] Hole = [41.6, 41.6 + RoundCorners, 41.6 + RoundCorners + 3.2 * (2 * Math.Tan(Math.PI / 16) + Math.Tan(Math.PI / 8))];
    private static double RoundCorners => 6.4 * Math.Sin(Math.PI / 8);

    [TestCase(WallOrder.InsideOut, 0, false)]
    [TestCase(WallOrder.InsideOut, 1, false)]
    [TestCase(WallOrder.OutsideIn, 0, true)]
    [TestCase(WallOrder.OutsideIn, 1, true)]
    [TestCase(WallOrder.Alternating, 2, false)]
    [TestCase(WallOrder.Alternating, 3, true)]
    public void The_walls_of_a_contour_follow_each_other(WallOrder order, int layer, bool outerFirst)
    {
        var (a, b) = outerFirst ? (Outside, Hole) : (Outside.AsEnumerable().Reverse().ToArray(), Hole.AsEnumerable().Reverse().ToArray());
        var loops = PlannedLoops(Bare with { WallOrder = order }, layer);
        Assert.That(loops, Is.EqualTo(a.Concat(b)).Within(0.01).Or.EqualTo(b.Concat(a)).Within(0.01));
        // Also where planning chooses the starts.
        Assert.That(PlannedLoops(Bare with { WallOrder = order, SeamPosition = SeamPosition.Nearest }, layer),
            Is.EqualTo(a.Concat(b)).Within(0.01).Or.EqualTo(b.Concat(a)).Within(0.01));
    }

    [TestCase(OverhangWallOrder.Same, false)]
    [TestCase(OverhangWallOrder.OutsideIn, true)]
    public void Contours_that_hang_over_have_an_order_of_their_own(OverhangWallOrder order, bool outerFirst)
    {
        var layers = Solids.Slice(Bare with { OverhangWallOrder = order }, Solids.Block(0, 0, 0, 10, 10, 1), Solids.Block(0, 0, 1, 15, 10, 2));
        Role First(int layer) => layers[layer].Steps[0].Path.Role;
        Assert.That(First(4), Is.EqualTo(Role.InnerWall));
        Assert.That(First(5) == Role.InnerWall, Is.EqualTo(!outerFirst));
        Assert.That(First(6), Is.EqualTo(Role.InnerWall));
    }

    [Test]
    public void Each_inner_loop_belongs_to_the_contour_around_it()
    {
        WallPath Loop(double x, double y, double half, int index)
            => new([new(x - half, y - half), new(x + half, y - half), new(x + half, y + half), new(x - half, y + half)], [0.4, 0.4, 0.4, 0.4], true, index,
                false);
        WallPath[] walls = [Loop(0, 0, 4, 1), Loop(20, 0, 5, 0), Loop(0, 0, 5, 0), Loop(20, 0, 3, 2), Loop(20, 0, 4, 1)];
        Assert.That(WallChains.Find(walls), Is.EqualTo(new[] { new[] { 1, 4, 3 }, [2, 0] }));
        // A loop without a parent stays alone.
        Assert.That(WallChains.Find([Loop(0, 0, 3, 2), Loop(0, 0, 5, 0)]), Is.EqualTo(new[] { new[] { 1 }, [0] }));
    }
}

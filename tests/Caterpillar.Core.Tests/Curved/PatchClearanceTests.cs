using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>Pieces of layers in cells of 1 mm, and which of them a head meets while it prints another.</summary>
[Category("Arithmetic")]
public class PatchClearanceTests
{
    // A needle that widens to 2 mm at 5 mm: what is beside it is met by boxes only.
    private static readonly Printer Needle = new() { HeadOutline = new(new HeadPoint(0.2, 0), new HeadPoint(2, 5)) };

    private static LayerPatch[] Patches(Vec3[][] paths)
    {
        var steps = paths.Select(p => new PathStep(new PrintPath(p, new Bead(0.1, 0.2)))).ToArray();
        return [.. LayerPatch.Of(new SlicedLayer(new Layer(0, 1), Region.Empty, steps), 3, 1)];
    }

    // In the middle of one cell and a little beyond.
    private static LayerPatch At(double x, double y, double z) => Patches([[new(x, y, z), new(x + 0.1, y, z)]]).Single();

    private static bool Blocks(Printer printer, double x, double y, double height, double slack = 0)
        => new PatchClearance(printer, 1, slack).IsBlocked(At(50.5 + x, 50.5 + y, 1 + height), At(50.5, 50.5, 1));

    // A box from 4 to 8 mm to the right and from 10 to 20 mm in front, 6 mm above the tip; 0.1 mm may stick out.
    [TestCase(5, -15, 6.2, true)]
    [TestCase(5, -15, 6.05, false)]
    [TestCase(4, -15, 9, false)]
    [TestCase(8, -15, 9, false)]
    [TestCase(7, -15, 9, true)]
    [TestCase(5, -10, 9, false)]
    [TestCase(5, -20, 9, false)]
    [TestCase(5, -11, 9, true)]
    [TestCase(5, -19, 9, true)]
    [TestCase(-5, -15, 9, false)]
    [TestCase(5, 15, 9, false)]
    public void A_box_of_the_head_meets_what_is_higher_than_its_bottom_beside_the_nozzle(double x, double y, double height, bool meets)
    {
        var far = new Bounds(new Vec3(50, 50, 90), new Vec3(60, 60, 99));
        var printer = Needle with { HeadBoxes = new(far, new Bounds(new Vec3(4, -20, 6), new Vec3(8, -10, 30))) };
        Assert.That(Blocks(printer, x, y, height), Is.EqualTo(meets));
        Assert.That(Blocks(Needle, x, y, height), Is.False, "Without the box.");
    }

    [TestCase(4, -15, true)]
    [TestCase(3, -15, false)]
    [TestCase(9, -15, false)]
    [TestCase(8, -10, true)]
    [TestCase(5, -9, false)]
    [TestCase(5, -20, true)]
    [TestCase(5, -21, false)]
    public void Slack_makes_boxes_wider(double x, double y, bool meets)
        => Assert.That(Blocks(Needle with { HeadBoxes = new(new Bounds(new Vec3(4, -20, 6), new Vec3(8, -10, 30))) }, x, y, 9, 0.9), Is.EqualTo(meets));

    // A beam is as long as the machine: it goes on for 100 mm at least.
    [TestCase(90, 11, 6.2, 0, true)]
    [TestCase(-90, 11, 6.2, 0, true)]
    [TestCase(90, 11, 6.05, 0, false)]
    [TestCase(90, 10, 9, 0, false)]
    [TestCase(90, 14, 9, 0, false)]
    [TestCase(90, 10, 9, 0.5, true)]
    [TestCase(90, 14, 9, 0.5, true)]
    [TestCase(90, 15, 9, 0.5, false)]
    [TestCase(90, 9, 9, 0.5, false)]
    public void A_beam_of_the_gantry_meets_what_is_in_front_or_behind_at_any_x(double x, double y, double height, double slack, bool meets)
        => Assert.That(Blocks(Needle with { Gantry = new(new Bounds(new Vec3(0, 10, 6), new Vec3(0, 14, 30))) }, x, y, height, slack), Is.EqualTo(meets));

    // At 1 mm from its axis the nozzle is 5 · 0.8 / 1.8 = 2.22 mm high, at 0.5 mm 0.83 mm.
    [TestCase(1, 2.3, 0, false)]
    [TestCase(1, 2.4, 0, true)]
    [TestCase(1, 0.9, 0.5, false)]
    [TestCase(1, 1, 0.5, true)]
    [TestCase(0, 0.05, 0, false)]
    [TestCase(0, 0.15, 0, true)]
    [TestCase(3, 99, 0, false)]
    public void The_nozzle_meets_what_is_higher_than_its_outline(double x, double height, double slack, bool meets)
    {
        Assert.That(Blocks(Needle, x, 0, height, slack), Is.EqualTo(meets));
        Assert.That(Blocks(Needle, 0, -x, height, slack), Is.EqualTo(meets));
    }

    [Test]
    public void A_patch_blocks_another_by_any_of_its_cells()
    {
        var clearance = new PatchClearance(Needle, 1, 0);
        // Low beside the nozzle, high 6 mm away; and the other way round.
        var slope = Patches([[new(1.5, 0.5, 1), new(6.5, 0.5, 9)]]).Single();
        Assert.That(clearance.IsBlocked(slope, At(0.5, 0.5, 1)), Is.False);
        Assert.That(clearance.IsBlocked(slope, At(7.5, 0.5, 1)), Is.True);
        var row = Patches([[new(0.5, 0.5, 1), new(7.5, 0.5, 1)]]).Single();
        Assert.That(clearance.IsBlocked(slope, row), Is.True);
        Assert.That(clearance.IsBlocked(row, slope), Is.False);
    }

    [Test]
    public void Paths_in_cells_that_touch_are_one_patch_with_the_heights_in_each_cell()
    {
        // 1 and 2 touch over a corner, 3 and 4 along a side; the last is two cells away from all.
        var patches = Patches([[new(0.5, 0.5, 1), new(2.5, 0.5, 3)], [new(3.5, 1.5, 2), new(3.6, 1.5, 5)], [new(-0.5, -5.5, 0), new(-0.5, -5.4, 0)],
            [new(0.5, -5.5, 7), new(0.5, -5.4, 7)], [new(5.5, 0.5, 4), new(5.5, 0.6, 4)]]);
        Assert.That(patches.Select(p => p.Steps.Count), Is.EqualTo(new[] { 2, 2, 1 }));
        Assert.That(patches.Select(p => (p.Layer, p.Box)), Is.EqualTo(new[]
        {
            (3, new Bounds(new(0, 0, 1), new(3, 1, 5))), (3, new Bounds(new(-1, -6, 0), new(0, -6, 7))), (3, new Bounds(new(5, 0, 4), new(5, 0, 4))),
        }));
        var cells = patches[0].Cells.Select(c => (c.Column, c.Row, Low: System.Math.Round(c.Low, 9), Top: System.Math.Round(c.Top, 9)));
        Assert.That(cells, Is.EqualTo(new[] { (0, 0, 1.0, 1.0), (1, 0, 1.5, 2.0), (2, 0, 2.5, 3.0), (3, 1, 2.0, 5.0) }));
    }
}

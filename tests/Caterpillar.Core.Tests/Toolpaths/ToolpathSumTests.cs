using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>What a toolpath amounts to, worked out by hand.</summary>
public class ToolpathSumTests
{
    [Test]
    public void Totals_tell_extrusions_travels_and_retractions_apart()
    {
        var totals = ToolpathTotals.Of(Sample());
        Assert.That((totals.PrintMoves, totals.TravelMoves, totals.Retractions), Is.EqualTo((4, 3, 2)));
        Assert.That(totals.PrintLength, Is.EqualTo(10 + 5 * Math.PI + 4 + 2).Within(1e-12));
        Assert.That(totals.TravelLength, Is.EqualTo(5 + 5 + 7).Within(1e-12), "the wipe moves as well");
        Assert.That(totals.DepositedE, Is.EqualTo(1 + 2 + 3 + 4 + 0.5));
        Assert.That(totals.DepositedVolume, Is.EqualTo(2 * 10.5));
        Assert.That(totals.PrintBounds, Is.EqualTo(new Bounds(new Vec3(5, 0, 0), new Vec3(20, 14, 0))), "the arc reaches to x = 20");
        Assert.That(totals.AllBounds, Is.EqualTo(new Bounds(new Vec3(15, 0, 0), new Vec3(17, 21, 0))), "ends of moves alone");
        var unknown = ToolpathTotals.Of(Sample(null));
        Assert.That(unknown.DepositedVolume, Is.Null);
        var still = new ToolpathBuilder(MoveSource.Steps, null);
        still.Add(Vec3.Zero, -1, 0, 1, MoveKind.Retract, Role.Unspecified, -1, 0, 0);
        Assert.That(ToolpathTotals.Of(still.Build([new ToolpathTool(null)])).DepositedVolume, Is.EqualTo(0), "nothing is deposited");
        Assert.That(ToolpathTotals.Of(still.Build([])).AllBounds.IsEmpty, Is.True);
    }

    [Test]
    public void Extrusions_are_summed_up_with_their_arcs_and_the_skirt_is_no_part()
    {
        var totals = ToolpathTotals.Of(Sample());
        Assert.That(totals.PrintLength, Is.EqualTo(16 + 5 * Math.PI).Within(1e-12));
        Assert.That((totals.DepositedE, totals.DepositedVolume, totals.InPlaceVolume), Is.EqualTo((10.5, 21.0, 1.0)), "with what is primed in place");
        Assert.That(totals.PartBounds, Is.EqualTo(new Bounds(new Vec3(15, 0, 0), new Vec3(20, 14, 0))));
    }

    [TestCase(Role.Skirt, true)]
    [TestCase(Role.Purge, true)]
    [TestCase(Role.PrimeTower, true)]
    [TestCase(Role.Brim, false)]
    [TestCase(Role.Support, false)]
    public void What_stands_beside_the_part_is_not_in_its_box(Role role, bool beside)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(1, 0), 1, 1, 1, MoveKind.Print, role, -1, 0, 0);
        Assert.That(ToolpathTotals.Of(builder.Build([])).PartBounds.IsEmpty, Is.EqualTo(beside));
    }

    [Test]
    public void A_part_that_begins_where_the_skirt_ends_reaches_to_there()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(10, 0), 1, 1, 1, MoveKind.Print, Role.Skirt, -1, 0, 0);
        builder.Add(new Vec3(4, 3), 1, 1, 1, MoveKind.Print, Role.OuterWall, -1, 0, 0);
        Assert.That(ToolpathTotals.Of(builder.Build([])).PartBounds, Is.EqualTo(new Bounds(new Vec3(4, 0), new Vec3(10, 3))));
        builder.Add(new Vec3(30, 5), 0, 0, 1, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(20, 5), 1, 1, 1, MoveKind.Print, Role.OuterWall, -1, 0, 0);
        Assert.That(ToolpathTotals.Of(builder.Build([])).PartBounds, Is.EqualTo(new Bounds(new Vec3(4, 0), new Vec3(30, 5))), "and after a travel too");
    }

    [Test]
    public void Areas_and_widths_are_means_over_the_length_of_each_role()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.AddLayer(new Layer(0, 0.2, 0.2));
        void Add(double x, double e, Role role, int tool = 0, MoveKind kind = MoveKind.Print)
            => builder.Add(new Vec3(x, 0), e, e, 10, kind, role, 0, tool, 0);
        Add(10, 1, Role.Infill);
        Add(40, 6, Role.Infill);
        Add(50, 9, Role.Infill, kind: MoveKind.Wipe);
        Add(60, 1, Role.Bridge, tool: 1);
        Add(70, 1, Role.Bridge);
        Add(70, 1, Role.Skirt);
        Add(80, -1, Role.Support);
        var totals = RoleTotals.Of(builder.Build([new ToolpathTool(1), new ToolpathTool(null)]));
        Assert.That(totals.Select(t => (t.Role, t.Length)), Is.EqualTo(new[] { (Role.Infill, 40.0), (Role.Bridge, 20.0), (Role.Support, 10.0) }));
        // 7 mm³ over 40 mm; 10 mm of 0.1 mm² and 30 mm of 0.2 mm², 0.2 mm high: each is wider than its rectangle by 0.2 (1 - π/4).
        Assert.That(totals[0].Area, Is.EqualTo(7 / 40.0).Within(1e-12));
        Assert.That(totals[0].Width, Is.EqualTo((10 * 0.5 + 30 * 1.0) / 40 + 0.2 * (1 - Math.PI / 4)).Within(1e-12));
        Assert.That((totals[1].Area, totals[1].Width), Is.EqualTo(((double?)null, (double?)null)), "one tool is unknown");
        Assert.That(totals[2].Area, Is.Null);
    }

    [Test]
    public void The_width_of_a_role_counts_the_length_of_arcs()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(5, 0));
        builder.Add(new Vec3(-5, 0), 5 * Math.PI, 5 * Math.PI, 10, MoveKind.Print, Role.Infill, -1, 0, 0, new Arc(Vec3.Zero, 180));
        var totals = RoleTotals.Of(builder.Build([new ToolpathTool(2)])).Single();
        Assert.That((totals.Length, totals.Area), Is.EqualTo((5 * Math.PI, (double?)2)));
        // Without a layer its height is unknown: a circle.
        Assert.That(totals.Width, Is.EqualTo(2 * Math.Sqrt(2 / Math.PI)).Within(1e-12));
    }

    [TestCase(9e-10, 0)]
    [TestCase(1.1e-9, 1)]
    public void Ends_differ_beyond_a_billionth_of_a_millimeter(double shift, int shifted)
        => Assert.That(ToolpathDifference.Of(One(0, 10, 1), One(shift, 10, 1)), Is.EqualTo(new ToolpathDifference(shifted, 0, 0, 1, 1)));

    [TestCase(9e-10, 0)]
    [TestCase(1.1e-9, 1)]
    public void Speeds_differ_beyond_a_billionth(double more, int speeds)
        => Assert.That(ToolpathDifference.Of(One(0, 1, 1), One(0, 1 + more, 1)), Is.EqualTo(new ToolpathDifference(0, speeds, 0, 1, 1)));

    [TestCase(9e-13, 0)]
    [TestCase(1.2e-12, 1)]
    public void Amounts_differ_beyond_the_rounding_of_sums(double more, int amounts)
        => Assert.That(ToolpathDifference.Of(One(0, 1, 1), One(0, 1, 1 + more)), Is.EqualTo(new ToolpathDifference(0, 0, amounts, 1, 1)));

    [Test]
    public void Toolpaths_in_other_blocks_are_compared_move_by_move()
    {
        // The same moves in blocks of 3, 4, 3 and of 5, 5; some blocks are shared but stand at other numbers.
        var moves = Enumerable.Range(0, 10).ToArray();
        var a = Blocks(moves, 3, 4, 3);
        var b = Blocks(moves, 5, 5);
        Assert.That(ToolpathDifference.Of(a, b), Is.EqualTo(new ToolpathDifference(0, 0, 0, 10, 10)));
        Assert.That(ToolpathDifference.Of(b, a), Is.EqualTo(new ToolpathDifference(0, 0, 0, 10, 10)));
        var c = Blocks([0, 1, 2, 3, 99, 5, 6, 7, 8, 98], 5, 5);
        Assert.That(ToolpathDifference.Of(a, c), Is.EqualTo(new ToolpathDifference(2, 2, 2, 10, 10)));
        var (one, two) = (Blocks([0, 1, 2], 3), Blocks([5, 6], 2));
        var twice = one.With([one.Blocks[0], two.Blocks[0], one.Blocks[0]]);
        var turned = one.With([two.Blocks[0], one.Blocks[0], one.Blocks[0]]);
        // 0 1 2 5 6 0 1 2 against 5 6 0 1 2 0 1 2.
        Assert.That(ToolpathDifference.Of(twice, turned), Is.EqualTo(new ToolpathDifference(5, 5, 5, 8, 8)));
    }

    private static Toolpath Blocks(int[] numbers, params int[] sizes)
    {
        var next = 0;
        var parts = sizes.Select(size =>
        {
            var builder = new ToolpathBuilder(MoveSource.Steps, null);
            for (var i = 0; i < size; i++, next++)
                builder.Add(new Vec3(numbers[next], 0), numbers[next], numbers[next], numbers[next], MoveKind.Print, Role.Infill, -1, 0, 0);
            return builder.Build([]);
        }).ToArray();
        return parts[0].With(parts.SelectMany(p => p.Blocks));
    }

    private static Toolpath One(double x, double speed, double amount)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        builder.Add(new Vec3(x, 0), amount, amount, speed, MoveKind.Print, Role.Infill, -1, 0, 0);
        return builder.Build([]);
    }

    // A skirt, a travel, a wipe with a retraction, a half circle, two lines, a prime in place and a travel; 2 mm³ per E.
    private static Toolpath Sample(double? volumePerE = 2)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(5, 0));
        void Add(double x, double y, double e, double deposited, MoveKind kind, Role role = Role.Unspecified, Arc? arc = null)
            => builder.Add(new Vec3(x, y), e, deposited, 10, kind, role, -1, 0, 0, arc);
        Add(15, 0, 1, 1, MoveKind.Print, Role.Skirt);
        Add(15, 5, 0, 0, MoveKind.Travel);
        Add(15, 0, -1, 0, MoveKind.Wipe);
        Add(15, 0, -1, 0, MoveKind.Retract);
        Add(15, 0, 2, 0, MoveKind.Deretract);
        // A half circle around (15, 5), which reaches to x = 20.
        Add(15, 10, 2, 2, MoveKind.Print, Role.OuterWall, new Arc(new Vec3(15, 5), 180));
        Add(15, 14, 3, 3, MoveKind.Print, Role.OuterWall);
        Add(17, 14, 4, 4, MoveKind.Print, Role.Infill);
        Add(17, 14, 0.5, 0.5, MoveKind.Prime);
        Add(17, 21, 0, 0, MoveKind.Travel);
        return builder.Build([new ToolpathTool(volumePerE)]);
    }
}

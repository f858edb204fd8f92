using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>Cells, bins and extrusions of a deposit, seen from above.</summary>
public class DepositPlaceTests
{
    // An extrusion along x over 10 mm at the height 1, 0.4 mm wide; asked for 0.2 mm high ones.
    [TestCase(5, 0.099, 1, 0, 0.2, true, TestName = "{m}(a little less than a quarter of both halves beside)")]
    [TestCase(5, 0.101, 1, 0, 0.2, false)]
    [TestCase(5, 0, 1, 18.0, 0.2, true)]
    [TestCase(5, 0, 1, 18.4, 0.2, false)]
    [TestCase(5, 0, 1, 180, 0.2, true)]
    [TestCase(5, 0, 1, 162, 0.2, true)]
    [TestCase(5, 0, 1, 0, 0.121, true)]
    [TestCase(5, 0, 1, 0, 0.119, false)]
    [TestCase(5, 0, 1, 0, 0.333, true)]
    [TestCase(5, 0, 1, 0, 0.334, false)]
    [TestCase(5, 0, 1.099, 0, 0.2, true)]
    [TestCase(5, 0, 1.101, 0, 0.2, false)]
    [TestCase(5, 0, 0.901, 0, 0.2, true)]
    [TestCase(5, 0, 0.899, 0, 0.2, false)]
    [TestCase(0, 0, 1, 0, 0.2, true)]
    [TestCase(10, 0, 1, 0, 0.2, true)]
    [TestCase(-0.05, 0, 1, 0, 0.2, false)]
    [TestCase(10.05, 0, 1, 0, 0.2, false)]
    [TestCase(500, 0, 1, 0, 0.2, false)]
    [TestCase(5000, 0, 1, 0, 0.2, false)]
    public void An_extrusion_runs_in_the_place_of_another(double x, double y, double z, double degrees, double half, bool runs)
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(30, 50, 1), new Vec3(40, 50, 1), 0.2, 3);
        var (sin, cos) = Angle.SinCos(degrees);
        var overlap = deposit.Overlaps.At(new Vec3(30 + x, 50 + y, z), new Vec3(7 * cos, 7 * sin), half, 0.2, default, 0, out var tag);
        Assert.That(overlap, Is.EqualTo(runs ? DepositOverlap.Parallel : DepositOverlap.None));
        Assert.That(tag, Is.EqualTo(runs ? 3 : -1));
    }

    [Test]
    public void Tops_between_two_heights_are_found_as_by_looking_at_all()
    {
        var random = new Random(7);
        double Next(double most) => random.NextDouble() * most;
        var deposit = new Deposit();
        var all = new Extrusion[300];
        for (var k = 0; k < all.Length; k++)
        {
            // Layers, some of them sloped.
            var (a, z) = (new Vec3(Next(9), Next(9)), 0.2 * (1 + k / 20));
            var (dx, dy, rise) = (Next(4) - 2, Next(4) - 2, k % 3 == 0 ? Next(0.3) : 0);
            all[k] = new Extrusion { Ax = a.X, Ay = a.Y, Az = z, Bx = a.X + dx, By = a.Y + dy, Bz = z + rise, Half = 0.2 };
            deposit.Add(new Vec3(a.X, a.Y, z), new Vec3(a.X + dx, a.Y + dy, z + rise), 0.2, k);
        }
        var found = 0;
        for (var k = 0; k < 2000; k++)
        {
            var (p, low, radius) = (new Vec3(Next(12) - 1, Next(12) - 1), Next(3), Next(0.5));
            var high = low + Next(0.4);
            var expected = all.Any(e => e.TopAt(p, radius) is var top && top >= low && top <= high);
            Assert.That(deposit.TopUnder(p, high, radius, least: low) >= low, Is.EqualTo(expected), $"{p} {low} {high} {radius}");
            Assert.That(deposit.TopUnder(p, high, radius) >= low, Is.EqualTo(expected), "the same without a lower bound");
            if (expected) found++;
        }
        Assert.That(found, Is.InRange(300, 1700));
    }

    [TestCase(0.61, true)]
    [TestCase(0.59, false)]
    public void Extrusions_older_than_one_of_two_layers_below_are_not_looked_at(double z, bool found)
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(0, 0, 1), new Vec3(10, 0, 1), 0.2, 3);
        deposit.Add(new Vec3(0, 0, z), new Vec3(10, 0, z), 0.2, 4);
        Assert.That(deposit.Overlaps.At(new Vec3(5, 0, 1), Vec3.UnitX, 0.2, 0.2, default, 0, out _),
            Is.EqualTo(found ? DepositOverlap.Parallel : DepositOverlap.None));
        Assert.That(deposit.Overlaps.At(new Vec3(5, 0, 1), Vec3.UnitZ, 0.2, 0.2, default, 0, out _), Is.EqualTo(DepositOverlap.None),
            "straight up runs nowhere");
    }

    [TestCase(127, true)]
    [TestCase(128, false)]
    public void Only_the_last_extrusions_of_a_place_are_looked_at(int after, bool found)
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(0, 0, 1), new Vec3(1, 0, 1), 0.2, 3);
        for (var i = 0; i < after; i++) deposit.Add(new Vec3(0.5, 0.1, 1), new Vec3(0.5, 1, 1), 0.2, 4);
        Assert.That(deposit.Overlaps.At(new Vec3(0.5, 0, 1), Vec3.UnitX, 0.2, 0.2, default, 0, out _),
            Is.EqualTo(found ? DepositOverlap.Parallel : DepositOverlap.None));
    }

    [Test]
    public void An_extrusion_on_a_slope_runs_in_a_place_at_its_height_there()
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(0, 0, 1), new Vec3(10, 0, 2), 0.2, 3);
        Assert.That(deposit.Overlaps.At(new Vec3(5, 0, 1.55), Vec3.UnitX, 0.2, 0.2, default, 0, out _), Is.EqualTo(DepositOverlap.Parallel));
        Assert.That(deposit.Overlaps.At(new Vec3(5, 0, 1.65), Vec3.UnitX, 0.2, 0.2, default, 0, out _), Is.EqualTo(DepositOverlap.None));
        Assert.That(deposit.Overlaps.At(new Vec3(5, 0, 1.35), Vec3.UnitX, 0.2, 0.2, default, 0, out _), Is.EqualTo(DepositOverlap.None));
    }

    [Test]
    public void A_cell_knows_its_top_and_what_is_clearly_below_it()
    {
        var cell = new DepositCell { Top = double.NegativeInfinity, Under = double.NegativeInfinity };
        void Lay(double top, double highest, double under)
        {
            cell.Lay(top);
            Assert.That((cell.Top, cell.Under), Is.EqualTo((highest, under)), $"after {top}");
        }
        Lay(1, 1, double.NegativeInfinity);
        Lay(1.019, 1.019, double.NegativeInfinity);
        Lay(1.05, 1.05, 1.019);
        Lay(1.04, 1.05, 1.019);
        Lay(1.025, 1.05, 1.025);
        Lay(0.5, 1.05, 1.025);
        Lay(2, 2, 1.05);
    }

    [Test]
    public void Cells_answer_for_the_extrusions_that_touch_them_on_both_sides_of_the_origin()
    {
        var deposit = new Deposit();
        foreach (var (x, y) in new[] { (1, 1), (-1, 1), (-1, -1), (1, -1), (300, -400), (-400, 300) })
            deposit.Add(new Vec3(x, y, 5 + x / 100.0), new Vec3(x, y, 5 + x / 100.0), 0.1);
        foreach (var (x, y) in new[] { (1, 1), (-1, 1), (-1, -1), (1, -1), (300, -400), (-400, 300) })
        {
            Assert.That(deposit.CellAt(x + 0.05, y + 0.05).Top, Is.EqualTo(5 + x / 100.0));
            Assert.That(deposit.CellAt(x + 0.55, y + 0.05).Top, Is.EqualTo(double.NegativeInfinity));
            Assert.That(deposit.TopUnder(new Vec3(x, y), 99), Is.EqualTo(5 + x / 100.0));
            Assert.That(deposit.TopAlong(new Vec3(x - 1, y), new Vec3(x - 0.5, y), 0.41), Is.EqualTo(5 + x / 100.0));
            Assert.That(deposit.TopAlong(new Vec3(x, y - 1), new Vec3(x, y - 0.5), 0.39), Is.EqualTo(double.NegativeInfinity));
        }
        Assert.That(deposit.CellAt(77, 1).Top, Is.EqualTo(double.NegativeInfinity));
        Assert.That(deposit.CellAt(2500, 1).Top, Is.EqualTo(double.NegativeInfinity), "nothing was printed so far out");
        deposit.Add(new Vec3(2500, 9, 4), new Vec3(2600, 9, 4), 0.2);
        Assert.That(deposit.CellAt(-3000, 1), Is.EqualTo((4, double.NegativeInfinity)), "everything outside has one height");
    }

    [Test]
    public void Cells_are_touched_up_to_half_their_diagonal_beyond_the_extrusion()
    {
        // Diagonal, 1 mm wide: the second cell beside its axis is 1.41 mm off, and half a width and half a diagonal are 1.21 mm.
        var deposit = new Deposit(1);
        deposit.Add(new Vec3(0.5, 0.5, 2), new Vec3(9.5, 9.5, 2), 0.5);
        for (var i = 2; i < 8; i++)
        {
            Assert.That(deposit.CellAt(i + 0.5, i + 0.5).Top, Is.EqualTo(2));
            Assert.That((deposit.CellAt(i + 1.5, i + 0.5).Top, deposit.CellAt(i - 0.5, i + 0.5).Top), Is.EqualTo((2.0, 2.0)));
            Assert.That(deposit.CellAt(i + 2.5, i + 0.5).Top, Is.EqualTo(double.NegativeInfinity));
            Assert.That(deposit.CellAt(i - 1.5, i + 0.5).Top, Is.EqualTo(double.NegativeInfinity));
        }
    }

    // Over 20 mm, 10 mm up. A cell of 0.5 mm is as high as the extrusion at its middle and 0.7072 · 0.5 mm farther up, but no higher than its end.
    [TestCase(-0.5, 0.1768)]
    [TestCase(0.5, 0.5518)]
    [TestCase(8.5, 4.5518)]
    [TestCase(19, 9.8018)]
    [TestCase(19.5, 10)]
    [TestCase(20.1, 10)]
    public void Cells_under_a_slope_are_as_high_as_it_is_there(double x, double top)
    {
        // The ends lie in two tiles of 32 mm.
        Vec3 low = new(25, 0, 0), high = new(45, 0, 10);
        var (up, down) = (new Deposit(0.5), new Deposit(0.5));
        up.Add(low, high, 0.6);
        down.Add(high, low, 0.6);
        foreach (var y in new[] { -0.4, 0.1, 0.4 })
        {
            Assert.That(up.CellAt(25 + x, y).Top, Is.EqualTo(top).Within(1e-9));
            Assert.That(down.CellAt(25 + x, y).Top, Is.EqualTo(top).Within(1e-9));
        }
    }

    [Test]
    public void Cells_under_a_slope_across_the_grid_are_as_high_as_it_is_there()
    {
        var deposit = new Deposit(0.5);
        deposit.Add(new Vec3(0, 0, 0), new Vec3(12, 16, 10), 0.6);
        // The middle of the cell is at (6.25, 8.25), where 0.5175 of the height is reached.
        Assert.That(deposit.CellAt(6, 8).Top, Is.EqualTo(5.175 + 0.1768).Within(1e-9));
    }

    [TestCase(1, 1, true)]
    [TestCase(3, 3, true)]
    [TestCase(0.999, 0.999, false)]
    [TestCase(3.001, 3.001, false)]
    [TestCase(0, 1, true)]
    [TestCase(3, 5, true)]
    [TestCase(0, 0.999, false)]
    [TestCase(3.001, 5, false)]
    public void A_segment_meets_rows_that_it_touches(double from, double to, bool meets)
    {
        Assert.That(FlatSegment.RowSpan(new Vec3(2, from), new Vec3(6, to), 1, 3, out _, out _), Is.EqualTo(meets));
        Assert.That(FlatSegment.RowSpan(new Vec3(2, to), new Vec3(6, from), 1, 3, out _, out _), Is.EqualTo(meets));
    }

    // The cells reach 2048 mm far; what is nearer to their edge than its width counts as outside too.
    [TestCase(2047.7, false)]
    [TestCase(2047.9, true)]
    public void Extrusions_near_the_edge_of_the_cells_are_outside(double x, bool outside)
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(x, 0, 4), new Vec3(x, 1, 4), 0.2);
        Assert.That(deposit.TopAlong(new Vec3(-3000, 0), new Vec3(-3000, 1), 0.1), Is.EqualTo(outside ? 4 : double.NegativeInfinity));
    }

    [Test]
    public void An_extrusion_that_leaves_the_cells_is_drawn_up_to_their_edge()
    {
        var deposit = new Deposit();
        deposit.Add(new Vec3(-5000, 3, 1), new Vec3(5000, 3, 2), 0.2);
        foreach (var x in new[] { -2040.0, -500, 0, 700, 2040 })
            Assert.That(deposit.TopUnder(new Vec3(x, 3.1), 9), Is.EqualTo(1.5 + x / 10_000).Within(1e-9));
        deposit.Add(new Vec3(7, -5000, 3), new Vec3(7, 5000, 4), 0.2);
        Assert.That(deposit.TopUnder(new Vec3(7.1, -1000), 9), Is.EqualTo(3.4).Within(1e-9));
        Assert.That(deposit.Highest, Is.EqualTo(4));
        deposit.Add(new Vec3(-5000, 4000, 6), new Vec3(5000, 4000, 6), 0.2);
        Assert.That(deposit.TopAlong(new Vec3(-2000, 2000), new Vec3(2000, 2000), 1), Is.LessThan(5), "it passes far from the cells");
    }

    // Extrusions of one bin at the heights 1, 2, 3 and so on; 1 mm below the highest they are dropped, whenever there are 32.
    [TestCase(32, 32)]
    [TestCase(33, 3)]
    [TestCase(62, 32)]
    [TestCase(63, 3)]
    public void A_full_bin_drops_what_is_far_below(int extrusions, int kept)
    {
        var deposit = new Deposit(0.25, 1);
        for (var i = 1; i <= extrusions; i++) deposit.Add(new Vec3(1, 1, i), new Vec3(1.2, 1, i), 0.1, i);
        Assert.That(deposit.ExtrusionCount, Is.EqualTo(kept));
        Assert.That(deposit.TopUnder(new Vec3(1.1, 1), 1000), Is.EqualTo(extrusions));
        Assert.That(deposit.TopAlong(new Vec3(1.1, 0), new Vec3(1.1, 3), 0.1), Is.EqualTo(extrusions));
    }

    [TestCase(0.0)]
    [TestCase(-1.0)]
    [TestCase(double.NaN)]
    public void Lengths_of_a_deposit_are_positive(double wrong)
    {
        Assert.That(() => new Deposit(wrong), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new Deposit(1, wrong), Throws.InstanceOf<ArgumentOutOfRangeException>());
        if (wrong != 0) Assert.That(() => new Deposit().Add(Vec3.Zero, Vec3.UnitX, wrong), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new Deposit().Add(Vec3.Zero, Vec3.UnitX, double.PositiveInfinity), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => new Deposit().Add(Vec3.Zero, new Vec3(wrong / 0, 0), 1), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void An_extrusion_without_a_height_is_at_most_twenty_times_as_wide_as_round()
    {
        var deposit = new Deposit();
        // 0.01 mm² spread over 0.0001 mm would be 100 mm wide; 40 √(0.01 / π) are 2.257 mm.
        deposit.Add(new Vec3(0, 0, 1), new Vec3(10, 0, 1), new Bead(0.01, 0.0001));
        Assert.That(deposit.TopUnder(new Vec3(5, 1.128), 9), Is.EqualTo(1));
        Assert.That(deposit.TopUnder(new Vec3(5, 1.129), 9), Is.EqualTo(double.NegativeInfinity));
    }

    [Test]
    public void The_part_of_a_segment_between_two_rows_agrees_with_sampling()
    {
        var random = new Random(5);
        for (var round = 0; round < 300; round++)
        {
            Vec3 a = new(random.Next(-9, 10), random.Next(-9, 10)), b = new(random.Next(-9, 10), random.Next(-9, 10));
            var low = random.NextDouble() * 18 - 9;
            var high = low + random.NextDouble() * 6;
            var there = Enumerable.Range(0, 2001).Select(i => Vec3.Lerp(a, b, i / 2000.0)).Where(p => p.Y >= low && p.Y <= high).Select(p => p.X).ToArray();
            var meets = FlatSegment.RowSpan(a, b, low, high, out var x0, out var x1);
            if (there.Length == 0)
            {
                if (meets) Assert.That(x1 - x0, Is.LessThan(0.02));
                continue;
            }
            Assert.That(meets, Is.True);
            Assert.That((x0 - there.Min(), x1 - there.Max()), Is.EqualTo((0.0, 0.0)).Within(0.01));
        }
    }

    [Test]
    public void The_part_of_a_segment_in_a_stadium_agrees_with_sampling()
    {
        var random = new Random(6);
        for (var round = 0; round < 300; round++)
        {
            Vec3 a = new(random.Next(-5, 6), random.Next(-5, 6)), b = random.Next(6) == 0 ? a : new(random.Next(-5, 6), random.Next(-5, 6));
            double x = random.Next(-9, 10), y = random.Next(-9, 10), dx = random.Next(-9, 10), dy = random.Next(-9, 10), reach = 0.5 + random.NextDouble() * 3;
            var there = Enumerable.Range(0, 2001).Select(i => i / 2000.0)
                .Where(t => FlatSegment.SquareDistance(new Vec3(x + dx * t, y + dy * t), a, b) <= reach * reach).ToArray();
            var meets = StadiumClip.TryClip(x, y, dx, dy, a, b, reach, out var from, out var to);
            if (there.Length == 0)
            {
                if (meets) Assert.That(to - from, Is.LessThan(0.001));
                continue;
            }
            Assert.That(meets, Is.True);
            Assert.That(from, Is.EqualTo(there[0]).Within(0.001));
            Assert.That(to, Is.EqualTo(there[there.Length - 1]).Within(0.001));
        }
    }

    [Test]
    public void The_cells_of_a_extrusion_are_those_whose_middles_are_near_it()
    {
        var random = new Random(11);
        for (var round = 0; round < 400; round++)
        {
            var a = new Vec3(random.NextDouble() * 6 - 3, random.NextDouble() * 6 - 3, 1);
            var b = (round % 5) switch
            {
                0 => a,
                1 => new Vec3(a.X + random.NextDouble() * 30 - 15, a.Y, 1),
                2 => new Vec3(a.X, a.Y + random.NextDouble() * 30 - 15, 1),
                3 => a + new Vec3(random.NextDouble() - 0.5, random.NextDouble() - 0.5),
                _ => a + new Vec3(random.NextDouble() * 30 - 15, random.NextDouble() * 30 - 15),
            };
            var half = random.NextDouble() * (round % 3 == 0 ? 3 : 0.4);
            var deposit = new Deposit();
            deposit.Add(a, b, half);
            for (var row = -80; row < 80; row++)
            {
                for (var column = -80; column < 80; column++)
                {
                    var middle = new Vec3((column + 0.5) * 0.25, (row + 0.5) * 0.25);
                    var distance = Math.Sqrt(FlatSegment.SquareDistance(middle, a, b));
                    var isDrawn = deposit.CellAt(middle.X, middle.Y).Top == 1;
                    // Every cell that the extrusion touches, and none that is more than half a diagonal away.
                    if (!isDrawn && distance < half + 0.125) Assert.Fail($"{round}: {middle} touches the extrusion from {a} to {b}, {half} wide");
                    if (isDrawn && distance > half + 0.25 * 0.7073) Assert.Fail($"{round}: {middle} is beside the extrusion from {a} to {b}, {half} wide");
                }
            }
        }
    }
}

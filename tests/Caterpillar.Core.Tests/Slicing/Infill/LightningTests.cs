using System;
using System.Linq;
using System.Threading;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using NUnit.Framework;
using static Caterpillar.Tests.Slicing.Infill.InfillSamples;

namespace Caterpillar.Tests.Slicing.Infill;

public class LightningTests
{
    private const double Spacing = 3;
    private const double Thickness = 0.2;

    private static double[] Heights(int layers) => Enumerable.Range(1, layers).Select(i => i * Thickness).ToArray();

    private static double Distance(Region area, Polyline[] lines, Vec3 p)
    {
        double To(Polyline line) => Enumerable.Range(0, line.SegmentCount).Min(i =>
        {
            Vec3 a = line[i], d = line[i + 1 == line.Count ? 0 : i + 1] - a;
            var t = d.LengthSquared > 0 ? Math.Min(Math.Max(Vec3.Dot(p - a, d) / d.LengthSquared, 0), 1) : 0;
            return (a + d * t).DistanceTo(p);
        });
        return lines.Concat(area.Contours).Min(To);
    }

    [Test]
    public void Under_a_top_surface_no_place_is_farther_from_a_line_than_half_the_spacing()
    {
        var trees = Lightning.Grow([Holed], [Holed], Spacing, [0.2])[0].ToArray();
        var worst = 0.0;
        for (var x = 0.25; x < 20; x += 0.5)
        {
            for (var y = 0.25; y < 20; y += 0.5)
            {
                if (Holed.Contains(x, y)) worst = Math.Max(worst, Distance(Holed, trees, new Vec3(x, y)));
            }
        }
        // The places that are asked for lie a quarter of the spacing apart.
        Assert.That(worst, Is.LessThan(Spacing / 2 + Spacing / 4));
    }

    [Test]
    public void Each_layer_stands_on_the_one_below()
    {
        const int Layers = 40;
        // A body that gets wider towards the bed, with a top surface at the top and one halfway up.
        var areas = Enumerable.Range(0, Layers).Select(i => Holed.Offset((Layers - i) * 0.05, JoinStyle.Miter)).ToArray();
        var tops = areas.Select((area, i) => i == Layers - 1 ? area : i == 20 ? Region.Rectangle(1, 1, 6, 6) : Region.Empty).ToArray();
        var layers = Lightning.Grow(areas, tops, Spacing, Heights(Layers));
        var worst = 0.0;
        for (var i = 1; i < Layers; i++)
        {
            var below = layers[i - 1].ToArray();
            foreach (var p in layers[i].SelectMany(l => l.Points)) worst = Math.Max(worst, Distance(areas[i - 1], below, p));
        }
        Assert.That(worst, Is.LessThan(1.6 * Thickness), "branches lean by 45°; chords between nodes a little more");
    }

    [Test]
    public void Trees_withdraw_into_the_walls()
    {
        const int Layers = 80;
        var areas = Enumerable.Repeat(Holed, Layers).ToArray();
        var tops = areas.Select((area, i) => i == Layers - 1 ? area : Region.Empty).ToArray();
        var lengths = Lightning.Grow(areas, tops, Spacing, Heights(Layers)).Select(lines => lines.Sum(l => l.Length)).ToArray();
        Assert.That(lengths[Layers - 1], Is.GreaterThan(80));
        Assert.That(lengths[Layers / 2], Is.LessThan(0.4 * lengths[Layers - 1]));
        Assert.That(lengths[0], Is.LessThan(1));
    }

    [Test]
    public void Nothing_to_hold_up_gives_no_lines_and_narrow_areas_hold_themselves()
    {
        Assert.That(Lightning.Grow([Holed, Holed], [Region.Empty, Region.Empty], Spacing, [0.2, 0.4]), Is.All.Empty);
        var narrow = Region.Rectangle(0, 0, 30, 2.5);
        Assert.That(Lightning.Grow([narrow], [narrow], Spacing, [0.2])[0], Is.Empty);
        Assert.That(Lightning.Grow([Region.Empty], [Region.Empty], Spacing, [0.2])[0], Is.Empty);
    }

    [Test]
    public void Trees_are_filled_in_like_curves()
    {
        var trees = Lightning.Grow([Holed], [Holed], Spacing, [0.2])[0];
        var lines = Fill(new InfillRequest(Holed, InfillPattern.Lightning, Spacing, Width) { Curves = trees, Z = 0.2 });
        Assert.That(Length(lines), Is.InRange(0.95 * trees.Sum(t => t.Length), 1.6 * trees.Sum(t => t.Length)));
        Assert.That(lines, Has.Count.LessThanOrEqualTo(trees.Count));
    }

    [Test]
    public void The_nearest_node_is_found_on_the_farther_side_too()
    {
        Vec3[] places = [new Vec3(-10, 10), new Vec3(12, 0), new Vec3(-30, -30)];
        var cells = new NodeCells(1);
        for (var i = 0; i < 2; i++) cells.Add(places[i], i);
        Assert.That((cells.Nearest(Vec3.Zero, places, 50, out var distance), distance), Is.EqualTo((1, 12.0)));
        Assert.That(cells.Nearest(Vec3.Zero, places, 11, out _), Is.EqualTo(-1), "none within the limit");
        // Left of zero, where the nearer one is a cell farther away along X.
        Vec3[] right = [new Vec3(0.5, 5.5), new Vec3(1.5, 0.5)];
        var beside = new NodeCells(1);
        for (var i = 0; i < 2; i++) beside.Add(right[i], i);
        Assert.That((beside.Nearest(new Vec3(-4.5, 0.5), right, 50, out distance), distance), Is.EqualTo((1, 6.0)));
    }

    [Test]
    public void Growing_trees_stops_when_it_is_canceled()
    {
        Assert.That(() => Lightning.Grow([Holed], [Holed], Spacing, [0.2], new CancellationToken(true)), Throws.InstanceOf<OperationCanceledException>());
    }
}

using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Curved;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Curved;

/// <summary>The connected pieces of a layer, and the nodes of a grid that belong to them.</summary>
public class SpanIslandTests
{
    // A ring, a square within its hole, and a triangle beside it. Nodes every mm from (−3, −3).
    private static readonly SlopeGrid Grid = new(new Vec3(-3, -3), 1, 30, 20);

    private static readonly List<SpanIsland> Islands = SpanIsland.Of([
        [new(0, 0, 1), new(10.2, 0, 1), new(10.2, 10.2, 1), new(0, 10.2, 1)],
        [new(2, 2, 1), new(2, 8.2, 1), new(8.2, 8.2, 1), new(8.2, 2, 1)],
        [new(3.6, 3.6, 2), new(6.4, 3.6, 2), new(6.4, 6.4, 2), new(3.6, 6.4, 2)],
        [new(20, 0, 3), new(23, 0, 3), new(20, 3, 3)],
    ]);

    // From the smallest to the largest.
    [TestCase(1, 5, 2)]
    [TestCase(9, 9, 2)]
    [TestCase(10, 5, 2)]
    [TestCase(3, 5, -1)]
    [TestCase(5, 5, 1)]
    [TestCase(6, 4, 1)]
    [TestCase(21, 1, 0)]
    [TestCase(22, 2, -1)]
    [TestCase(11, 5, -1)]
    [TestCase(-1, 5, -1)]
    [TestCase(15, 5, -1)]
    public void A_node_belongs_to_the_island_inside_of_which_it_lies(int x, int y, int owner)
        => Assert.That(SpanIsland.Owners(Islands, Grid)[(y + 3) * 30 + x + 3], Is.EqualTo(owner));

    [Test]
    public void Nodes_along_outlines_lie_within_a_cell_of_them_and_miss_no_part()
    {
        var nodes = Islands[2].NodesAlong(Grid).Select(n => Grid.At(n)).ToArray();
        double Away(Vec3 p)
        {
            double Side(double low, double high) => Math.Max(Math.Abs(p.X - (low + high) / 2), Math.Abs(p.Y - (low + high) / 2)) - (high - low) / 2;
            return Math.Min(Math.Abs(Side(0, 10.2)), Math.Abs(Side(2, 8.2)));
        }
        Assert.That(nodes.Select(Away), Has.All.LessThan(1));
        for (var x = 0; x <= 10; x++) Assert.That(nodes, Has.Some.EqualTo(new Vec3(x, 0)));
        for (var y = 2; y <= 8; y++) Assert.That(nodes, Has.Some.EqualTo(new Vec3(8, y)));
    }

    // A wavy outline of 0.5 mm edges: from afar the coarser ones must not show.
    [TestCase(0, 0, 0, 1e-12)]
    [TestCase(12, 0, 6, 0.003)]
    [TestCase(0, -8, 16, 0.003)]
    [TestCase(0, 0, 40, 0.01)]
    public void From_afar_a_coarser_outline_spans_almost_the_same(double x, double y, int steps, double most)
    {
        Vec3 On(int i)
        {
            var (sin, cos) = Angle.SinCos(i * 1.5);
            return new Vec3(20 * cos, 20 * sin, 5 + 2 * sin + cos * cos);
        }
        var curve = Enumerable.Range(0, 240).Select(On).ToArray();
        var exact = new MeanValueSpan([curve]).Height(x, y);
        Assert.That(SpanIsland.Of([curve]).Single().Height(x, y, steps), Is.EqualTo(exact).Within(most));
    }
}

using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Planning;

/// <summary>Objects on the bed as travels see them, and the rings of a head.</summary>
public class ObstacleTests
{
    // A ramp over 40 × 6 mm that rises from 1 mm at X 10 to 9 mm at X 50.
    private static readonly TriMesh Ramp = TriMesh.Create(
        [new Vec3(10, 5, 1), new Vec3(50, 5, 9), new Vec3(50, 11, 9), new Vec3(10, 11, 1)], [0, 1, 2, 0, 2, 3]);

    [TestCase(40, 6)]
    [TestCase(6, 40)]
    public void No_place_of_an_object_is_lower_for_travels_than_it_is(double width, double depth)
    {
        var isWide = width > depth;
        var mesh = isWide ? Ramp : TriMesh.Create(Ramp.Vertices.Select(v => new Vec3(v.Y, v.X, v.Z)).ToArray(), [0, 2, 1, 0, 3, 2]);
        var deposit = new Deposit();
        Obstacle.AddTo(deposit, mesh);
        for (var along = 0.0; along <= 40; along += 0.37)
        {
            for (var across = 0.0; across <= 6; across += 0.37)
            {
                var (x, y) = isWide ? (10 + along, 5 + across) : (5 + across, 10 + along);
                var top = deposit.TopUnder(new Vec3(x, y), 100);
                // Squares of 0.5 mm take their highest corner, in discs that reach half a diagonal beyond.
                Assert.That(top, Is.InRange(1 + 0.2 * along - 1e-9, 1 + 0.2 * (along + 1.5)), $"{x}, {y}");
            }
        }
        Assert.That(double.IsNegativeInfinity(deposit.TopUnder(new Vec3(100, 100), 100)), Is.True);
    }

    [Test]
    public void Beside_a_spire_travels_are_as_low_as_the_spire_is_there()
    {
        var spire = TriMesh.Create([new(9, 9, 0), new(11, 9, 0), new(11, 11, 0), new(9, 11, 0), new(10.1, 10.1, 20)], [0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4]);
        var deposit = new Deposit();
        Obstacle.AddTo(deposit, spire);
        Assert.That(deposit.TopUnder(new Vec3(10.1, 10.1), 100), Is.EqualTo(20).Within(1e-9));
        Assert.That(deposit.TopUnder(new Vec3(11, 10.1), 100), Is.InRange(0, 15));
    }

    [Test]
    public void A_cone_is_several_rings_each_as_low_as_its_inner_edge_and_a_flat_is_one()
    {
        var rings = HeadCorridor.Rings([(0.5, 0), (4.5, 8), (20, 8)]).ToArray();
        Assert.That(rings, Is.EqualTo(new[] { (0.5, 0.0), (1.5, 0), (2.5, 2), (3.5, 4), (4.5, 6), (20, 8) }));
    }

    [Test]
    public void The_first_path_stays_first_where_the_head_is_unknown()
    {
        PrintPath Line(double from, double to) => new([new Vec3(from, 0, 0), new Vec3(to, 0, 0)], new Bead(0.1, 0.2, 20));
        PrintPath[] paths = [Line(50, 60), Line(0, 10), Line(62, 70), Line(12, 20)];
        var order = PathSorter.Order(paths, new SortOptions(SortRule.Nearest));
        Assert.That(order.Select(p => p.Index), Is.EqualTo(new[] { 0, 2, 3, 1 }));
        Assert.That(PathSorter.Order(paths, new SortOptions(SortRule.Nearest, Start: Vec3.Zero)).Select(p => p.Index), Is.EqualTo(new[] { 1, 3, 0, 2 }));
    }
}

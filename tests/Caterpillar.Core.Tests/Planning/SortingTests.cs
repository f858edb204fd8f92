using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Planning;

public class SortingTests
{
    private static readonly Bead Bead = new(0.08, 0.2);

    [Test]
    public void Nearest_goes_from_end_to_start_and_reverses_open_paths()
    {
        PrintPath[] paths = [Line(0, 0, 10, 0), Line(30, 0, 20, 0), Line(11, 0, 18, 0)];
        var order = PathSorter.Order(paths);
        Assert.That(order, Is.EqualTo(new[] { new PathPlacement(0), new PathPlacement(2), new PathPlacement(1, true) }));
        var sorted = PathSorter.Sort(paths);
        Assert.That(sorted[2].Start, Is.EqualTo(new Vec3(20, 0)));
        Assert.That(PathSorter.TravelBetween(sorted), Is.EqualTo(3).Within(1e-12));
    }

    [Test]
    public void Nearest_without_reversal_keeps_directions()
    {
        PrintPath[] paths = [Line(0, 0, 10, 0), Line(30, 0, 11, 0), Line(12, 0, 28, 0)];
        var order = PathSorter.Order(paths, new SortOptions(Reverse: false));
        Assert.That(order, Is.EqualTo(new[] { new PathPlacement(0), new PathPlacement(2), new PathPlacement(1) }));
    }

    [Test]
    public void Loops_start_at_the_vertex_nearest_to_the_head()
    {
        PrintPath[] paths = [Line(0, 0, 10, 0), Loop(20, 10, 30, 10, 30, 20, 12, 1)];
        Assert.That(PathSorter.Order(paths)[1], Is.EqualTo(new PathPlacement(1, false, 3)));
        Assert.That(PathSorter.Sort(paths)[1].Start, Is.EqualTo(new Vec3(12, 1)));
        Assert.That(PathSorter.Order(paths, new SortOptions(Rotate: false))[1], Is.EqualTo(new PathPlacement(1)));
    }

    [Test]
    public void A_loop_between_two_paths_starts_at_its_first_vertex_with_the_shortest_way_from_one_to_the_other()
    {
        var loop = new SortItem(Loop(4, 9, 4, 3, 16, 3, 16, 9), true, true);
        Assert.That(loop.Between(7, new Vec3(0, 0), new Vec3(10, 0)), Is.EqualTo(new PathPlacement(7, false, 1)));
        Assert.That(loop.Between(7, new Vec3(10, 0), new Vec3(20, 0)), Is.EqualTo(new PathPlacement(7, false, 2)));
        Assert.That(loop.Between(7, new Vec3(10, 20), new Vec3(10, 20)), Is.EqualTo(new PathPlacement(7)), "of equals the first");
    }

    [Test]
    public void Loops_of_many_vertices_still_start_at_the_nearest()
    {
        var circle = new PrintPath(Enumerable.Range(0, 1000).Select(i => new Vec3(100 + 50 * Math.Cos(i * 0.00628), 50 * Math.Sin(i * 0.00628))), Bead,
            closed: true);
        PrintPath[] paths = [Line(0, 0, 10, 20), circle];
        var vertex = PathSorter.Order(paths)[1].Vertex;
        var nearest = Enumerable.Range(0, 1000).OrderBy(i => circle.Points[i].DistanceTo(new Vec3(10, 20))).First();
        Assert.That(vertex, Is.EqualTo(nearest));
    }

    [Test]
    public void Orient_keeps_the_order()
    {
        PrintPath[] paths = [Line(0, 0, 10, 0), Line(30, 0, 20, 0), Line(11, 0, 18, 0)];
        var order = PathSorter.Order(paths, new SortOptions(SortRule.Orient));
        Assert.That(order, Is.EqualTo(new[] { new PathPlacement(0), new PathPlacement(1, true), new PathPlacement(2, true) }));
    }

    [Test]
    public void None_changes_nothing()
    {
        var paths = Random(20, new Random(3));
        Assert.That(PathSorter.Sort(paths, new SortOptions(SortRule.None)), Is.EqualTo(paths));
    }

    [Test]
    public void By_layer_and_by_height_keep_what_is_below_first()
    {
        PrintPath[] paths = [At(2, 5), At(1, 0), At(2, 1), At(0, 9), At(1, 8)];
        var byLayer = PathSorter.Sort(paths, new SortOptions(SortRule.Layer));
        Assert.That(byLayer.Select(p => p.Layer!.Index), Is.EqualTo(new[] { 0, 1, 1, 2, 2 }));
        Assert.That(byLayer.Select(p => Math.Min(p.Start.X, p.End.X)), Is.EqualTo(new[] { 9.0, 8, 0, 1, 5 }));
        var byHeight = PathSorter.Sort(paths, new SortOptions(SortRule.Z));
        Assert.That(byHeight, Is.EqualTo(byLayer).Using<PrintPath>((a, b) => a.Start == b.Start && a.End == b.End));

        static PrintPath At(int layer, double x) => new([new Vec3(x, 0, layer), new Vec3(x + 0.5, 0, layer)], Bead) { Layer = new Layer(layer, layer) };
    }

    [TestCase(0.00015, 1)]
    [TestCase(0.00005, 0)]
    public void Paths_are_as_high_as_others_within_a_ten_thousandth_of_a_millimeter(double z, int first)
    {
        PrintPath[] paths = [new([new Vec3(0, 0, z), new Vec3(1, 0, z)], Bead), Line(9, 0, 10, 0)];
        Assert.That(PathSorter.Order(paths, new SortOptions(SortRule.Z))[0].Index, Is.EqualTo(first));
    }

    [Test]
    public void A_tour_improves_what_nearest_gets_wrong()
    {
        // From 0 the nearest neighbor goes back and forth: 1, -1.5, 4, -8.
        PrintPath[] paths = [Dot(0), Dot(4), Dot(-8), Dot(1), Dot(-1.5)];
        var nearest = PathSorter.TravelBetween(PathSorter.Sort(paths));
        var tour = PathSorter.TravelBetween(PathSorter.Sort(paths, new SortOptions(SortRule.Tour)));
        Assert.That(nearest, Is.EqualTo(1 + 2.5 + 5.5 + 12).Within(0.1));
        Assert.That(tour, Is.EqualTo(4 + 12).Within(0.1));

        static PrintPath Dot(double x) => Line(x, 0, x, 0.001);
    }

    [Test]
    public void In_a_tour_a_loop_starts_where_the_way_through_it_is_shortest()
    {
        PrintPath[] paths = [Line(0, 0, 10, 0), Loop(12, 0, 20, 5, 12, 10), Line(30, 10, 40, 10)];
        Assert.That(PathSorter.Order(paths), Is.EqualTo(new[] { new PathPlacement(0), new PathPlacement(1), new PathPlacement(2) }));
        Assert.That(PathSorter.Order(paths, new SortOptions(SortRule.Tour))[1], Is.EqualTo(new PathPlacement(1, false, 1)));
    }

    [Test]
    public void A_tour_of_few_paths_is_near_the_best_of_all_orders()
    {
        var random = new Random(5);
        double sum = 0, best = 0;
        for (var round = 0; round < 20; round++)
        {
            var paths = Random(6, random);
            sum += PathSorter.TravelBetween(PathSorter.Sort(paths, new SortOptions(SortRule.Tour)));
            best += Shortest(paths);
        }
        Assert.That(sum, Is.GreaterThanOrEqualTo(best - 1e-9));
        Assert.That(sum, Is.LessThan(best * 1.12));
    }

    [TestCase(SortRule.Orient)]
    [TestCase(SortRule.Nearest)]
    [TestCase(SortRule.Layer)]
    [TestCase(SortRule.Z)]
    [TestCase(SortRule.Tour)]
    public void No_path_is_lost_or_duplicated_and_runs_agree(SortRule rule)
    {
        var random = new Random(7);
        foreach (var count in new[] { 0, 1, 2, 3, 17, 150 })
        {
            var paths = Random(count, random);
            foreach (var start in new Vec3?[] { null, new Vec3(5, 5) })
            {
                var options = new SortOptions(rule, Start: start);
                var order = PathSorter.Order(paths, options);
                Assert.That(order.Select(o => o.Index).OrderBy(i => i), Is.EqualTo(Enumerable.Range(0, count)));
                Assert.That(PathSorter.Order(paths, options), Is.EqualTo(order));
                foreach (var place in order)
                {
                    if (paths[place.Index].IsClosed) Assert.That(place.Reversed, Is.False);
                    else Assert.That(place.Vertex, Is.Zero);
                }
                if (count > 0 && start is null && rule is SortRule.Orient or SortRule.Nearest or SortRule.Tour) Assert.That(order[0].Index, Is.Zero);
            }
        }
    }

    [Test]
    public void Nearest_is_never_worse_than_the_input_and_a_tour_never_worse_than_nearest()
    {
        var random = new Random(11);
        for (var round = 0; round < 200; round++)
        {
            var paths = Random(random.Next(2, 40), random);
            var nearest = PathSorter.TravelBetween(PathSorter.Sort(paths));
            Assert.That(nearest, Is.LessThanOrEqualTo(PathSorter.TravelBetween(paths) + 1e-9));
            Assert.That(PathSorter.TravelBetween(PathSorter.Sort(paths, new SortOptions(SortRule.Tour))), Is.LessThanOrEqualTo(nearest + 1e-9));
        }
    }

    [Test]
    public void Nearest_equals_a_search_over_all_remaining_paths()
    {
        var random = new Random(13);
        for (var round = 0; round < 50; round++)
        {
            // On a coarse lattice, so that many distances tie: of two layers, or of many.
            var layers = round % 2 == 0 ? 2 : 30;
            var points = Enumerable.Range(0, random.Next(1, 200)).Select(_ => new Vec3(random.Next(6), random.Next(6), random.Next(layers))).ToArray();
            var tree = new EntryTree(points);
            var left = Enumerable.Range(0, points.Length).ToList();
            while (left.Count > 0)
            {
                var from = new Vec3(random.Next(7), random.Next(7), random.Next(layers + 1));
                var expected = left.OrderBy(i => (points[i] - from).LengthSquared).ThenBy(i => i).First();
                Assert.That(tree.Nearest(from), Is.EqualTo(expected));
                var remove = left[random.Next(left.Count)];
                left.Remove(remove);
                tree.Remove(remove);
            }
            Assert.That(tree.Nearest(default), Is.EqualTo(-1));
        }
    }

    [Test]
    public void Infinite_distances_are_sorted_too()
    {
        PrintPath[] paths = [Line(-1e300, 0, -9e299, 0), Line(1e300, 0, 9e299, 0), Line(0, 1e300, 0, 9e299)];
        Assert.That(PathSorter.Order(paths, new SortOptions(SortRule.Tour)).Select(o => o.Index), Is.EquivalentTo(new[] { 0, 1, 2 }));
    }

    [Test]
    public void Paths_that_may_not_be_reversed_keep_their_direction_in_a_tour()
    {
        var random = new Random(17);
        var paths = Random(60, random);
        var order = PathSorter.Order(paths, new SortOptions(SortRule.Tour, Reverse: false, Rotate: false));
        Assert.That(order, Has.All.Matches<PathPlacement>(p => !p.Reversed && p.Vertex == 0));
    }

    private static double Shortest(PrintPath[] paths)
    {
        var best = double.PositiveInfinity;
        var used = new bool[paths.Length];
        used[0] = true;
        Visit(paths[0].End, 1, 0);
        return best;

        void Visit(Vec3 at, int done, double length)
        {
            if (done == paths.Length) best = Math.Min(best, length);
            for (var i = 1; i < paths.Length; i++)
            {
                if (used[i]) continue;
                used[i] = true;
                if (paths[i].IsClosed)
                {
                    foreach (var vertex in paths[i].Points) Visit(vertex, done + 1, length + at.DistanceTo(vertex));
                }
                else
                {
                    Visit(paths[i].End, done + 1, length + at.DistanceTo(paths[i].Start));
                    Visit(paths[i].Start, done + 1, length + at.DistanceTo(paths[i].End));
                }
                used[i] = false;
            }
        }
    }

    private static PrintPath Line(double x0, double y0, double x1, double y1) => new([new Vec3(x0, y0), new Vec3(x1, y1)], Bead);

    private static PrintPath Loop(params double[] xy)
        => new(Enumerable.Range(0, xy.Length / 2).Select(i => new Vec3(xy[2 * i], xy[2 * i + 1])), Bead, closed: true);

    internal static PrintPath[] Random(int count, Random random)
    {
        var paths = new PrintPath[count];
        for (var i = 0; i < count; i++)
        {
            var closed = random.Next(3) == 0;
            var at = new Vec3(random.NextDouble() * 100, random.NextDouble() * 100, random.Next(3));
            var points = new List<Vec3>();
            for (var n = random.Next(3, 6); n > 0; n--) points.Add(at + new Vec3(random.NextDouble() * 10, random.NextDouble() * 10));
            paths[i] = new PrintPath(points, Bead, closed) { Layer = new Layer((int)at.Z, at.Z) };
        }
        return paths;
    }
}

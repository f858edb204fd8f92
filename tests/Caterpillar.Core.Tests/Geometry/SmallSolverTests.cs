using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Files;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Tests.Geometry.Meshes;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry;

/// <summary>Systems of equations, spans, distances on meshes, and other parts with exact answers.</summary>
public class SmallSolverTests
{
    [Test]
    public void A_sparse_system_has_the_solution_of_elimination()
    {
        var random = new Random(3);
        const int Size = 30;
        var full = new double[Size, Size + 1];
        var entries = new List<(int, int, double)>();
        for (var k = 0; k < 80; k++)
        {
            var (i, j, value) = (random.Next(Size), random.Next(Size), -random.NextDouble());
            if (i == j) continue;
            entries.Add((i, j, value));
            foreach (var (a, b) in new[] { (i, j), (j, i) })
            {
                full[a, b] += value;
                full[a, a] -= value;
            }
        }
        for (var i = 0; i < Size; i++) (full[i, i], full[i, Size]) = (full[i, i] + 0.5, random.NextDouble() - 0.5);
        var diagonal = Enumerable.Range(0, Size).Select(i => full[i, i]).ToArray();
        var right = Enumerable.Range(0, Size).Select(i => full[i, Size]).ToArray();
        var x = new double[Size];
        Assert.That(new SparseSystem(entries, diagonal).Solve(right, x, 1e-12, default), Is.True);
        for (var i = 0; i < Size; i++)
        {
            for (var k = 0; k < Size; k++)
            {
                if (k == i) continue;
                var factor = full[k, i] / full[i, i];
                for (var c = i; c <= Size; c++) full[k, c] -= factor * full[i, c];
            }
        }
        Assert.That(x, Is.EqualTo(Enumerable.Range(0, Size).Select(i => full[i, Size] / full[i, i])).Within(1e-9));
        var same = (double[])x.Clone();
        Assert.That(new SparseSystem(entries, diagonal).Solve(right, same, 1e-6, new CancellationToken(true)), Is.True, "Done.");
        Assert.That(same, Is.EqualTo(x));
        Assert.That(new SparseSystem([(0, 1, 2.0)], [1, 1]).Solve([1, -1], new double[2], 1e-9, default), Is.False, "Not positive definite.");
    }

    private static readonly Vec3[] Outline = [new(0, 0), new(10, 0), new(10, 10), new(0, 10)];
    private static readonly Vec3[] Hole = [new(4, 4), new(4, 6), new(6, 6), new(6, 4)];

    [TestCase(5, 2)]
    [TestCase(1, 9)]
    [TestCase(-3, 4)]
    [TestCase(10, 10)]
    [TestCase(5, 0)]
    [TestCase(4, 5)]
    [TestCase(20, 20)]
    public void Curves_of_a_plane_are_spanned_by_that_plane(double x, double y)
    {
        Vec3[] On(Vec3[] curve) => Array.ConvertAll(curve, p => p.WithZ(1 + 0.5 * p.X - 0.2 * p.Y));
        Assert.That(new MeanValueSpan([On(Outline), On(Hole)]).Height(x, y), Is.EqualTo(1 + 0.5 * x - 0.2 * y).Within(1e-9));
        Assert.That(new MeanValueSpan([On(Outline)]).Height(x, y), Is.EqualTo(1 + 0.5 * x - 0.2 * y).Within(1e-9));
    }

    [Test]
    public void Sets_grow_together_and_have_their_lowest_number()
    {
        var sets = new DisjointSets(3);
        for (var i = 3; i < 40; i++) sets.Add();
        Assert.That((sets.Of(39), sets.Join(39, 7), sets.Join(7, 39), sets.Of(39)), Is.EqualTo((39, true, false, 7)));
        Assert.That((sets.Join(2, 30), sets.Join(30, 39), sets.Of(7), sets.Of(30), sets.Of(8)), Is.EqualTo((true, true, 2, 2, 8)));
    }

    [TestCase("abcdef", "a b c d e f")]
    [TestCase("abcabcab", "a b c 5:3")]
    [TestCase("aaaaaaaa", "a 7:1")]
    [TestCase("abab", "a b a b")]
    [TestCase("abcdeXabcYabcde", "a b c d e X 3:6 Y 5:10")]
    [TestCase("abc-bcd-abcd", "a b c - b c d - 3:8 d")]
    public void Repeats_of_three_bytes_and_more_are_found(string text, string expected)
        => Assert.That(Pieces(text, 100, 100, 100), Is.EqualTo(expected));

    [TestCase(3, 100, 100, "a b c - - a b c - a b c")]
    [TestCase(4, 100, 100, "a b c - - a b c 4:4")]
    [TestCase(5, 100, 100, "a b c - - 4:5 3:4")]
    [TestCase(100, 100, 0, "a b c - - a b c - a b c")]
    [TestCase(100, 3, 100, "a b c - - 3:5 3:4 c")]
    public void Repeats_are_no_farther_no_longer_and_looked_for_no_more_than_allowed(int farthest, int longest, int tries, string expected)
        => Assert.That(Pieces("abc--abc-abc", farthest, longest, tries), Is.EqualTo(expected));

    private static string Pieces(string text, int farthest, int longest, int tries)
    {
        var bytes = Encoding.ASCII.GetBytes(text);
        return string.Join(" ", RepeatFinder.Pieces(bytes, farthest, longest, tries).Select(p => p.Length == 1 ? $"{text[p.At]}" : $"{p.Length}:{p.Back}"));
    }

    [Test]
    public void A_growing_box_holds_points_boxes_and_the_sides_of_arcs()
    {
        var box = new GrowingBox();
        Assert.That((box.IsEmpty, box.ToBounds().IsEmpty), Is.EqualTo((true, true)));
        box.Include(1, 2, 3);
        box.Include(0, 5, 4);
        var other = new GrowingBox();
        other.Include(new GrowingBox());
        Assert.That(other.IsEmpty, Is.True);
        other.Include(box);
        Assert.That(other.ToBounds(), Is.EqualTo(new Bounds(new Vec3(0, 2, 3), new Vec3(1, 5, 4))));
    }

    [Test]
    public void Distances_along_a_flat_mesh_are_straight_and_around_edges_they_unfold()
    {
        const int N = 12;
        var points = Enumerable.Range(0, N * N).Select(i => new Vec3(i % N, i / N)).ToArray();
        var faces = Enumerable.Range(0, (N - 1) * (N - 1)).Select(i => i / (N - 1) * N + i % (N - 1))
            .SelectMany(i => new[] { i, i + 1, i + N + 1, i, i + N + 1, i + N }).ToArray();
        var flat = TriMesh.Create(points, faces);
        var line = GeodesicDistance.From(flat, Enumerable.Range(0, N).Select(i => i * N), default);
        for (var i = 0; i < line.Length; i++) Assert.That(line[i], Is.EqualTo(i % N).Within(1e-9), "From a straight side the front is straight.");
        var corner = GeodesicDistance.From(flat, [0], default);
        for (var i = 0; i < corner.Length; i++) Assert.That(corner[i], Is.EqualTo(points[i].Length).Within(0.35));
        Assert.That(corner[N - 1], Is.EqualTo(N - 1).Within(1e-9));
        var bent = TriMesh.Create(points.Select(p => p.X <= 5 ? p : new Vec3(5, p.Y, p.X - 5)).ToArray(), faces);
        Assert.That(GeodesicDistance.From(bent, Enumerable.Range(0, N).Select(i => i * N), default), Is.EqualTo(line).Within(1e-9));
        var apart = TriMesh.Create([.. points, new Vec3(99, 0), new Vec3(99, 1), new Vec3(98, 0)], [.. faces, N * N, N * N + 1, N * N + 2]);
        Assert.That(GeodesicDistance.From(apart, [0], default)[N * N], Is.EqualTo(double.PositiveInfinity));
        // Obtuse at the top: its front comes through the triangle below.
        var obtuse = TriMesh.Create([new Vec3(-4, 0), new Vec3(4, 0), new Vec3(0, 1), new Vec3(0, -3)], [0, 1, 2, 1, 0, 3]);
        Assert.That(GeodesicDistance.From(obtuse, [3], default)[2], Is.EqualTo(4).Within(1e-9));
    }

    [TestCase(0.25, 1)]
    [TestCase(0.5, 2)]
    [TestCase(0.999, 3.996)]
    public void Level_curves_of_a_box_are_its_outlines_to_the_left(double level, double height)
    {
        var box = MeshMaker.Box(0, 0, 0, 10, 20, 4);
        var curves = new LevelCurves(box, box.Vertices.Select(p => p.Z / 4).ToArray(), [0.1, level]).Trace(1, 0.001);
        Assert.That(curves, Has.Count.EqualTo(1));
        Assert.That(curves[0].IsClosed, Is.True);
        Assert.That(curves[0].Points.Select(p => p.Z), Is.All.EqualTo(height).Within(1e-9));
        Assert.That(curves[0].SignedAreaXY, Is.EqualTo(200).Within(1e-6), "Counterclockwise.");
        Assert.That(curves[0].Points, Has.Count.LessThanOrEqualTo(5), "Straight lines need no points between their ends.");
        var none = new LevelCurves(box, new double[8], [0.5]);
        Assert.That(none.Trace(0, 0.001), Is.Empty);
    }

    [Test]
    public void Level_curves_end_where_they_are_not_wanted()
    {
        var box = MeshMaker.Box(0, 0, 0, 10, 20, 4);
        var heights = box.Vertices.Select(p => p.Z).ToArray();
        bool InFront(int corner, int level) => Enumerable.Range(corner, 3).All(c => box.Vertices[box.RawTriangles[c]].Y == 0);
        var line = new LevelCurves(box, heights, [1], InFront).Trace(0, 0.001).Single();
        Assert.That(line.IsClosed, Is.False);
        Assert.That(line.Points, Is.EqualTo(new[] { new Vec3(0, 0, 1), new Vec3(10, 0, 1) }).Using<Vec3>((p, q) => p.DistanceTo(q) < 1e-9));
        Assert.That(new LevelCurves(box, heights, [1], (_, _) => false).Trace(0, 0.001), Is.Empty);
    }

    [Test]
    public void Edges_near_a_box_are_among_those_of_its_cells()
    {
        var random = new Random(8);
        var contour = Enumerable.Range(0, 40).Select(_ => new GridPoint(random.Next(-4000, 4000), random.Next(-4000, 4000))).ToArray();
        var hole = Enumerable.Range(0, 5).Select(_ => new GridPoint(random.Next(-900, 900), random.Next(-900, 900))).ToArray();
        var within = Bounds.Of([.. contour.Concat(hole).Select(Grid.ToMm)]);
        var (grid, fresh) = (new SegmentGrid(), new SegmentGrid());
        grid.Take([hole, contour], within, within.Size.X / 20);
        grid.Take([contour, hole], within, within.Size.X / 15);
        fresh.Take([contour, hole], within, within.Size.X / 15);
        Assert.That((grid.ContourStart[2], grid.Next[39], grid.Previous[0], grid.Next[44], grid.Previous[40], grid.Contour[39], grid.Contour[40]),
            Is.EqualTo((45, 0, 39, 40, 44, 0, 1)));
        for (var i = 0; i < 45; i++)
        {
            var d = grid.Points[grid.Next[i]] - grid.Points[i];
            Assert.That((grid.Length[i], grid.Normal[i].X * d.X + grid.Normal[i].Y * d.Y), Is.EqualTo((d.Length, 0.0)).Within(1e-9));
            Assert.That(grid.Normal[i].X * -d.Y + grid.Normal[i].Y * d.X, Is.EqualTo(d.Length).Within(1e-9), "To the left.");
        }
        var (found, same, reach) = (new List<int>(), new List<int>(), within.Size.X / 100);
        for (var k = 0; k < 60; k++)
        {
            var at = within.Min + new Vec3(random.NextDouble() * within.Size.X, random.NextDouble() * within.Size.Y);
            grid.Near(at.X - reach, at.Y - reach, at.X + reach, at.Y + reach, found);
            fresh.Near(at.X - reach, at.Y - reach, at.X + reach, at.Y + reach, same);
            Assert.That(found, Is.Unique.And.EqualTo(same), "Nothing is left of what was taken before.");
            for (var i = 0; i < 45; i++)
                if (at.WithZ(0).DistanceToSegment(grid.Points[i], grid.Points[grid.Next[i]]) < reach) Assert.That(found, Does.Contain(i));
        }
        Assert.That(found.Count, Is.LessThan(45), "Not all of them.");
    }
}

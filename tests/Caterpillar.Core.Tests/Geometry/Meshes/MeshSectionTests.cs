using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Meshes;

[TestFixture]
public class MeshSectionTests
{
    [Test]
    public void A_box_gives_a_counterclockwise_rectangle()
    {
        var section = MeshSections.At(MeshBytes.Box, [1.5]).Value!.Single();
        Assert.That(section.Z, Is.EqualTo(1.5));
        Assert.That(section.OpenEnds, Is.EqualTo(0));
        var loop = section.Loops.Single();
        // Points on straight lines stay.
        Assert.That((loop.IsClosed, loop.Count, loop.SignedAreaXY, loop.Length), Is.EqualTo((true, 8, 2.0, 6.0)));
        Assert.That(loop.Points, Is.SupersetOf(new Vec3[] { new(0, 0, 1.5), new(1, 0, 1.5), new(1, 2, 1.5), new(0, 2, 1.5) }));
    }

    [Test]
    public void Flat_faces_give_the_limit_from_below()
    {
        var sections = MeshSections.At(MeshBytes.Box, [0, 3, 3.0000001, -1]).Value!;
        Assert.That(sections.Select(s => s.Loops.Count), Is.EqualTo(new[] { 0, 1, 0, 0 }));
        Assert.That(sections[1].Loops[0].SignedAreaXY, Is.EqualTo(2));
    }

    [Test]
    public void Heights_may_come_in_any_order_and_twice()
    {
        var torus = MeshMaker.BumpySphere(24, 12);
        double[] heights = [40, 3, 79, 3, 40.5, 200, -7, 12.25];
        var sections = MeshSections.At(torus, heights).Value!;
        Assert.That(sections.Select(s => s.Z), Is.EqualTo(heights));
        for (var i = 0; i < heights.Length; i++) Assert.That(Text(sections[i]), Is.EqualTo(Text(MeshSections.At(torus, [heights[i]]).Value![0])));
        Assert.That(Text(sections[1]), Is.EqualTo(Text(sections[3])));
    }

    [Test]
    public void Tips_edges_and_vertices_on_the_plane_leave_no_artifacts()
    {
        var octahedron = TriMesh.Create(
            [new(1, 0), new(0, 1), new(-1, 0), new(0, -1), new(0, 0, 1), new(0, 0, -1)],
            [0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 1, 0, 5, 2, 1, 5, 3, 2, 5, 0, 3, 5]);
        var sections = MeshSections.At(octahedron, [-1, 0, 1]).Value!;
        Assert.That(sections[0].Loops, Is.Empty);
        Assert.That(sections[1].Loops.Single().Points, Is.EquivalentTo(new Vec3[] { new(1, 0), new(0, 1), new(-1, 0), new(0, -1) }));
        Assert.That(sections[2].Loops, Is.Empty, "a tip has no area");
        // A roof whose ridge lies on the plane.
        var roof = TriMesh.Create(
            [new(0, 0), new(4, 0), new(4, 2), new(0, 2), new(0, 1, 1), new(4, 1, 1)], [0, 2, 1, 0, 3, 2, 0, 1, 5, 0, 5, 4, 2, 3, 4, 2, 4, 5, 1, 2, 5, 3, 0, 4]);
        Assert.That(roof.IsWatertight);
        Assert.That(MeshSections.At(roof, [1]).Value![0].Loops, Is.Empty, "a ridge has no area");
        Assert.That(MeshSections.At(roof, [0.5]).Value![0].Loops.Single().SignedAreaXY, Is.EqualTo(4));
    }

    [Test]
    public void Spikes_are_removed_wherever_the_contour_starts()
    {
        Vec3 a = new(0, 0), b = new(4, 0), c = new(4, 4), x = new(6, 0), y = new(8, 0);
        Vec3[] spiky = [a, b, x, y, x, b, b, c, c];
        for (var first = 0; first < spiky.Length; first++)
        {
            var points = spiky.Skip(first).Concat(spiky.Take(first)).ToArray();
            var count = points.Length;
            var start = PolylineCleaning.DropSpikes(points, ref count);
            Assert.That(points.Skip(start).Take(count), Is.EquivalentTo(new[] { a, b, c }), $"from {first}");
        }
    }

    [Test]
    public void Cut_points_do_not_depend_on_the_direction_of_an_edge()
    {
        var mesh = MeshMaker.BumpySphere(60, 30).Rotated(new Vec3(1, 2, 3), 20);
        double[] heights = [11.1, 22.2, 33.3, 44.4, 55.5];
        var plain = MeshSections.At(mesh, heights).Value!;
        var turned = MeshSections.At(MeshMaker.InsideOut(mesh), heights).Value!;
        for (var i = 0; i < heights.Length; i++)
        {
            Assert.That(turned[i].Loops.Single().Points, Is.EquivalentTo(plain[i].Loops.Single().Points));
            Assert.That(turned[i].Loops.Single().SignedAreaXY, Is.EqualTo(-plain[i].Loops.Single().SignedAreaXY).Within(1e-9));
        }
    }

    [Test]
    public void Holes_run_clockwise()
    {
        var hollow = TriMesh.Merge([MeshMaker.Box(0, 0, 0, 10, 10, 10), MeshMaker.InsideOut(MeshMaker.Box(3, 3, 3, 5, 5, 5))]);
        Assert.That(MeshSections.At(hollow, [4]).Value![0].Loops.Select(l => l.SignedAreaXY), Is.EqualTo(new[] { 100.0, -4.0 }));
    }

    [Test]
    public void Open_surfaces_give_open_lines_and_a_warning()
    {
        var box = MeshBytes.Box;
        var cup = TriMesh.Create(box.Vertices, box.Indices.Skip(12).Take(18).ToArray());
        var result = MeshSections.At(cup, [1, 2]);
        Assert.That(result.Value!.Select(s => (s.Loops.Count, s.OpenLines.Count, s.OpenEnds)), Is.EqualTo(new[] { (0, 1, 2), (0, 1, 2) }));
        // Three sides of the rectangle, with the outside on the right.
        Assert.That(result.Value![0].OpenLines[0].Length, Is.EqualTo(4));
        Assert.That(result.Value![0].OpenLines[0][0], Is.EqualTo(new Vec3(0, 0, 1)));
        Assert.That(result.Diagnostics.Single().ToString(),
            Is.EqualTo("warning mesh.naked_edges: The mesh is open: a contour has a loose end, first at z = 1 mm. (4 times)"));
    }

    [TestCase(0.05, 0.1, true)]
    [TestCase(0.2, 0.1, false)]
    [TestCase(0.2, 0.3, true)]
    [TestCase(0.05, 0, false)]
    public void Gaps_are_closed_up_to_the_stated_distance(double gap, double limit, bool closes)
    {
        // A box with a slit along one of its edges.
        var box = MeshBytes.Box;
        var soup = box.Indices.Select(i => box.Vertices[i]).ToArray();
        for (var i = 12; i < 18; i++)
        {
            if (soup[i].X == 1) soup[i] = new Vec3(1 - gap, 0, soup[i].Z);
        }
        var mesh = TriMesh.Create(soup, Enumerable.Range(0, soup.Length).ToArray());
        Assert.That(mesh.NakedEdgeCount, Is.GreaterThan(0));
        var result = MeshSections.At(mesh, [1.5], new SectionOptions { GapMm = limit });
        Assert.That(result.Value![0].Loops.Count, Is.EqualTo(closes ? 1 : 0));
        Assert.That(result.Diagnostics.Single().Code, Is.EqualTo(closes ? "mesh.gap_closed" : "mesh.naked_edges"));
        if (closes)
        {
            Assert.That(result.Value[0].Loops[0].SignedAreaXY, Is.EqualTo(2).Within(1e-12));
            Assert.That(result.Diagnostics[0].Message, Does.Contain(NumberFormatter.Format(gap, 6) + " mm"));
        }
    }

    [Test]
    public void Triangles_that_are_inside_out_are_still_chained()
    {
        var sphere = MeshMaker.BumpySphere(24, 12);
        var indices = sphere.Indices.ToArray();
        for (var t = 90; t < 96; t += 3) (indices[t], indices[t + 1]) = (indices[t + 1], indices[t]);
        var mesh = TriMesh.Create(sphere.Vertices, indices);
        Assert.That(mesh.WindingConflictCount, Is.GreaterThan(0));
        double[] heights = [10, 20, 30, 41, 50, 60, 70, 75];
        var good = MeshSections.At(sphere, heights).Value!;
        var repaired = MeshSections.At(mesh, heights);
        Assert.That(repaired.Diagnostics.Single().Code, Is.EqualTo("mesh.gap_closed"));
        for (var i = 0; i < heights.Length; i++)
        {
            Assert.That(repaired.Value![i].OpenLines, Is.Empty);
            Assert.That(repaired.Value[i].Loops.Single().SignedAreaXY, Is.EqualTo(good[i].Loops.Single().SignedAreaXY).Within(1e-9));
        }
    }

    [Test]
    public void A_soup_of_loose_triangles_is_chained_by_distance()
    {
        var sphere = MeshMaker.BumpySphere(60, 30);
        var random = new Random(11);
        double Shake() => (random.NextDouble() - 0.5) * 0.01;
        var soup = sphere.Indices.Select(i => sphere.Vertices[i] + new Vec3(Shake(), Shake(), Shake())).ToArray();
        var mesh = TriMesh.Create(soup, Enumerable.Range(0, soup.Length).ToArray());
        var heights = Enumerable.Range(1, 15).Select(i => i * 5.0 + 0.1).ToArray();
        var result = MeshSections.At(mesh, heights, new SectionOptions { GapMm = 0.1 });
        var good = MeshSections.At(sphere, heights).Value!;
        for (var i = 0; i < heights.Length; i++)
        {
            Assert.That(result.Value![i].OpenLines, Is.Empty);
            Assert.That(result.Value[i].Loops.Sum(l => l.SignedAreaXY), Is.EqualTo(good[i].Loops.Sum(l => l.SignedAreaXY)).Within(1).Percent);
        }
    }

    [Test]
    public void Threads_never_change_the_result()
    {
        var mesh = MeshMaker.BumpySphere(90, 45).Rotated(new Vec3(1, 2, 3), 20);
        var heights = Enumerable.Range(0, 200).Select(i => i * 0.4 + 0.2).ToArray();
        var one = MeshSections.At(mesh, heights, new SectionOptions { Threads = 1 }).Value!.Select(Text).ToArray();
        for (var threads = 2; threads < 5; threads++)
        {
            Assert.That(MeshSections.At(mesh, heights, new SectionOptions { Threads = threads }).Value!.Select(Text), Is.EqualTo(one));
        }
    }

    [Test]
    public void Progress_ends_at_one_and_canceling_stops()
    {
        var last = 0.0;
        var progress = new Watch(p =>
        {
            Assert.That(p, Is.InRange(last, 1.0));
            last = p;
        });
        MeshSections.At(MeshBytes.Box, Enumerable.Range(0, 50).Select(i => i * 0.1).ToArray(), null, progress);
        Assert.That(last, Is.EqualTo(1));
        using var cancel = new CancellationTokenSource();
        cancel.Cancel();
        Assert.That(() => MeshSections.At(MeshBytes.Box, [1], null, null, cancel.Token), Throws.InstanceOf<OperationCanceledException>());
        Assert.That(() => MeshReader.Read(MeshBytes.Obj(), "x.obj", cancel: cancel.Token), Throws.InstanceOf<OperationCanceledException>());
        Assert.That(() => MeshSections.At(MeshBytes.Box, [double.NaN]), Throws.ArgumentException);
        Assert.That(MeshSections.At(MeshBytes.Box, []).Value, Is.Empty);
        Assert.That(MeshSections.At(TriMesh.Empty, [1]).Value!.Single().Loops, Is.Empty);
    }

    [Test]
    public void Section_areas_of_random_prisms_are_exact_at_every_height()
    {
        var random = new Random(5);
        for (var round = 0; round < 60; round++)
        {
            var polygon = RandomPolygon(random);
            var area = new Polyline(polygon, true).SignedAreaXY;
            var lean = new Vec3(random.NextDouble() * 8 - 4, random.NextDouble() * 8 - 4);
            var mesh = MeshMaker.Prism(polygon, -2, 5, lean);
            Assert.That(mesh.IsWatertight);
            Assert.That(mesh.Volume, Is.EqualTo(7 * area).Within(1e-9));
            foreach (var section in MeshSections.At(mesh, [-1.9, 0, 1.2345, 4.99, 5]).Value!)
            {
                Assert.That(section.Loops.Single().SignedAreaXY, Is.EqualTo(area).Within(1e-9));
            }
        }
    }

    [Test]
    public void Section_areas_of_turned_meshes_integrate_to_the_volume()
    {
        var random = new Random(6);
        for (var round = 0; round < 10; round++)
        {
            var mesh = MeshMaker.Prism(RandomPolygon(random), -2, 5, new Vec3(1, 2)).Rotated(RandomAxis(random), random.NextDouble() * 360);
            var (low, high) = (mesh.Bounds.Min.Z, mesh.Bounds.Max.Z);
            const int N = 2000;
            var h = (high - low) / N;
            var sections = MeshSections.At(mesh, Enumerable.Range(0, N).Select(i => low + (i + 0.5) * h).ToArray());
            Assert.That(sections.Diagnostics, Is.Empty);
            var sum = sections.Value!.SelectMany(s => s.Loops).Sum(l => l.SignedAreaXY) * h;
            Assert.That(sum, Is.EqualTo(mesh.Volume).Within(0.01).Percent);
        }
    }

    [Test]
    public void Turning_about_Z_turns_the_sections()
    {
        var mesh = MeshMaker.BumpySphere(60, 30);
        var heights = Enumerable.Range(0, 20).Select(i => i * 4 + 0.7).ToArray();
        var plain = MeshSections.At(mesh, heights).Value!;
        var turned = MeshSections.At(mesh.Rotated(Vec3.UnitZ, 33).Moved(new Vec3(7, 8, 9)), heights.Select(z => z + 9).ToArray()).Value!;
        for (var i = 0; i < heights.Length; i++)
        {
            Assert.That(turned[i].Loops.Sum(l => l.SignedAreaXY), Is.EqualTo(plain[i].Loops.Sum(l => l.SignedAreaXY)).Within(1e-9));
            Assert.That(turned[i].Loops.Sum(l => l.Length), Is.EqualTo(plain[i].Loops.Sum(l => l.Length)).Within(1e-9));
        }
    }

    [TestCase(0.0, "mesh.naked_edges", 2, 0, 1)]
    [TestCase(0.1, "mesh.naked_edges", 2, 0, 1)]
    [TestCase(1.5, "mesh.gap_closed", 1, 1, 0)]
    public void One_open_contour_is_reported_once_as_what_became_of_it(double gap, string code, int count, int loops, int open)
    {
        // Three walls of a box, whose fourth, 1 mm wide, is missing.
        Vec3[] corners = [new(1, 0), new(1, 2), new(0, 2), new(0, 0)];
        var walls = TriMesh.Create([.. corners, .. corners.Select(c => c.WithZ(3))], [0, 1, 5, 0, 5, 4, 1, 2, 6, 1, 6, 5, 2, 3, 7, 2, 7, 6]);
        var cut = MeshSections.At(walls, [1.5], new SectionOptions { GapMm = gap });
        Assert.That(cut.Diagnostics.Select(d => (d.Code, d.Severity, d.Count)), Is.EqualTo(new[] { (code, Severity.Warning, count) }));
        Assert.That((cut.Value!.Single().Loops.Count, cut.Value!.Single().OpenLines.Count), Is.EqualTo((loops, open)));
    }

    private static Vec3[] RandomPolygon(Random random)
    {
        var n = 3 + random.Next(40);
        return Enumerable.Range(0, n).Select(i =>
        {
            var (sin, cos) = Angle.SinCos(360.0 * i / n);
            var r = 2 + 8 * random.NextDouble();
            return new Vec3(r * cos, r * sin);
        }).ToArray();
    }

    private static Vec3 RandomAxis(Random random) => new(random.NextDouble() - 0.5, random.NextDouble() - 0.5, random.NextDouble() - 0.5);

    private static string Text(Section section)
        => string.Join("|", section.Loops.Concat(section.OpenLines).Select(l => string.Join(" ", l.Points.Select(Bits))));

    private static string Bits(Vec3 p) => $"{BitConverter.DoubleToInt64Bits(p.X):x},{BitConverter.DoubleToInt64Bits(p.Y):x}";

    private sealed class Watch(Action<double> action) : IProgress<double>
    {
        public void Report(double value) => action(value);
    }
}

using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;
using Caterpillar.Tests.Geometry.Meshes;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Slicing;

[TestFixture]
public class BrokenModelTests
{
    private static readonly PrintSettings Plain = new()
    {
        LayerHeight = 0.5, FirstLayerHeight = 0.5, InfillDensityPercent = 0, WallCount = 1, BeadShape = BeadShape.Rectangle, Resolution = 0, MinLayerTime = 0,
    };

    [Test]
    public void Repairs_are_one_diagnostic_for_each_model()
    {
        var box = MeshMaker.Box(0, 0, 0, 10, 10, 2);
        var broken = TriMesh.Create(box.Vertices, box.Indices.Take(33).ToArray());
        var others = new[] { new NamedMesh("b", broken.Moved(new Vec3(20, 0, 0))), new NamedMesh("c", box.Moved(new Vec3(40, 0, 0))) };
        var result = PlanarSlicer.Slice([new NamedMesh("a", broken), .. others], Plain);
        Assert.That(result.Diagnostics.Select(d => d.ToString()), Is.EqualTo(new[]
        {
            "a: warning slice.broken_mesh: The mesh is broken. Repaired: 1 hole filled (z 0 to 2 mm, up to 10.2 mm wide).",
            "b: warning slice.broken_mesh: The mesh is broken. Repaired: 1 hole filled (z 0 to 2 mm, up to 10.2 mm wide).",
        }));
        Assert.That(result.Value!.Layers.Select(l => l.Region.Area), Is.All.EqualTo(100).Within(1e-6));
    }

    [Test]
    public void A_sheet_is_told_how_it_can_be_printed()
    {
        var sheet = new NamedMesh("sheet", TriMesh.Create([new(0, 0, 0), new(30, 0, 0), new(30, 0, 5), new(0, 0, 5)], [0, 1, 2, 0, 2, 3]));
        var result = PlanarSlicer.Slice([sheet], Plain);
        Assert.That(result.Diagnostics.Single(d => d.Code == "slice.empty").Message, Does.Contain("open_contours=walls"));
        Assert.That(PlanarSlicer.Slice([sheet], Plain with { OpenContours = OpenContours.Walls }).Value!.Layers, Has.Count.EqualTo(10));
    }

    [Test]
    public void Closed_gaps_and_what_is_left_out_are_reported_with_heights()
    {
        var result = PlanarSlicer.Slice([new NamedMesh("slit", Slit(1, 4, 2))], Plain with { RepairMeshes = false });
        Assert.That(result.Diagnostics.Single().Message, Is.EqualTo(
            "The mesh is broken. 8 gaps in contours closed on 8 layers (z 0.25 to 3.75 mm): 16 mm in total, the widest 2 mm."));
        var open = PlanarSlicer.Slice([new NamedMesh("slit", Slit(1, 4, 2))],
            Plain with { RepairMeshes = false, SliceGapClosing = 1, MaxAreaLossPercent = 100 });
        Assert.That(open.Diagnostics.Single(d => d.Code == "slice.broken_mesh").Message, Is.EqualTo(
            "The mesh is broken. 8 open contours left out on 8 layers (z 0.25 to 3.75 mm): 304 mm in total."));
    }

    [Test]
    public void A_layer_that_loses_too_much_is_an_error_unless_it_is_allowed()
    {
        var settings = Plain with { SliceGapClosing = 1, RepairMeshes = false };
        // A tower of three boxes; the one in the middle has a slit that does not close.
        var tower = TriMesh.Merge([MeshMaker.Box(0, 0, 0, 10, 10, 4), Slit(1, 4, 2).Moved(new Vec3(0, 0, 4)), MeshMaker.Box(0, 0, 8, 10, 10, 12)]);
        var lost = PlanarSlicer.Slice([new NamedMesh("tower", tower)], settings);
        Assert.That(lost.Value, Is.Null);
        var error = lost.Diagnostics.Single(d => d.Severity == Severity.Error);
        Assert.That((error.Code, error.Source!.File), Is.EqualTo(("slice.lost_layers", "tower")));
        Assert.That(error.Message, Does.StartWith(
            "More than 25 % of the area is missing on 8 layers (z 4.25 to 7.75 mm) because contours do not close. At z 4.25 mm, 0 %"));
        var allowed = PlanarSlicer.Slice([new NamedMesh("tower", tower)], settings with { MaxAreaLossPercent = 100 });
        Assert.That((allowed.Value is not null, allowed.Diagnostics.Count), Is.EqualTo((true, 1)));
        var closed = PlanarSlicer.Slice([new NamedMesh("tower", tower)], settings with { SliceGapClosing = 2.5 });
        Assert.That(closed.Value!.Layers.Select(l => l.Region.Area), Is.All.EqualTo(100).Within(1e-6));
    }

    [Test]
    public void Layers_of_a_closed_mesh_may_shrink_as_they_like()
    {
        var hourglass = TriMesh.Merge([MeshMaker.Box(0, 0, 0, 10, 10, 2), MeshMaker.Box(4, 4, 2, 6, 6, 4), MeshMaker.Box(0, 0, 4, 10, 10, 6)]);
        Assert.That(PlanarSlicer.Slice([new NamedMesh("hourglass", hourglass)], Plain).Diagnostics, Is.Empty);
    }

    [TestCase("beetle_open.obj", true)]
    [TestCase("ogre_bodies.ply", false)]
    [TestCase("bowl_open.ply", true)]
    [TestCase("terrain.obj", true)]
    [TestCase("saddle.obj", true)]
    public void Dirty_meshes_are_printed_whole_or_refused(string file, bool refused)
    {
        var models = MeshReader.Read(TestData.Shared("meshes/" + file)).Value!;
        var result = PlanarSlicer.Slice(models, Plain with { LayerHeight = 1, FirstLayerHeight = 1 });
        Assert.That(result.Diagnostics.Select(d => d.Code), Is.SubsetOf(new[] { "slice.broken_mesh", "slice.lost_layers", "slice.empty", "slice.too_thin" }));
        Assert.That(result.Diagnostics.Any(d => d.Severity == Severity.Error), Is.EqualTo(refused), string.Join("\n", result.Diagnostics));
        Assert.That(result.Value is null, Is.EqualTo(refused));
    }

    // A box 10 × 10 mm whose wall at x = 10 has a slit from y = from, as wide as stated.
    private static TriMesh Slit(double from, double height, double width)
    {
        var box = MeshMaker.Box(0, 0, 0, 10, 10, height);
        var points = box.Vertices.ToList();
        var indices = box.Indices.Where((_, i) => !IsRight(box, i / 3)).ToList();
        void Wall(double y0, double y1)
        {
            var n = points.Count;
            points.AddRange([new(10, y0, 0), new(10, y1, 0), new(10, y1, height), new(10, y0, height)]);
            indices.AddRange([n, n + 1, n + 2, n, n + 2, n + 3]);
        }
        Wall(0, from);
        Wall(from + width, 10);
        return TriMesh.Create(points, indices);
    }

    private static bool IsRight(TriMesh box, int t)
    {
        var (a, b, c) = box.Triangle(t);
        return box.Vertices[a].X == 10 && box.Vertices[b].X == 10 && box.Vertices[c].X == 10;
    }
}

using System;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Display;
using Caterpillar.Drawings;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Slicing;
using Caterpillar.Tests.Geometry.Meshes;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.EndToEnd;

/// <summary>Small inputs that ask for much: every stage refuses them within its limit, and does the same work within a larger one.</summary>
public class MemoryLimitTests
{
    private static readonly MemoryLimit Small = new(4 << 20);

    private static void Refused<T>(Result<T> small, Result<T> large)
        where T : class
    {
        Assert.That(small.Value, Is.Null);
        Assert.That(small.Diagnostics.Where(d => d.Severity == Severity.Error).Select(d => d.Code), Is.EqualTo(new[] { MemoryLimit.Code }));
        Assert.That(large.Value, Is.Not.Null);
        Assert.That(large.Diagnostics.Select(d => d.Code), Does.Not.Contain(MemoryLimit.Code));
    }

    private static void RefusesMesh(byte[] bytes, string name)
        => Refused(MeshReader.Read(bytes, name, new MeshReadOptions { Memory = Small }), MeshReader.Read(bytes, name));

    [Test]
    public void Many_items_of_one_object()
    {
        var model = new StringBuilder("<model unit=\"millimeter\"><resources><object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/>"
            + "<vertex x=\"9\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"9\" z=\"0\"/><vertex x=\"0\" y=\"0\" z=\"9\"/></vertices><triangles>"
            + "<triangle v1=\"0\" v2=\"2\" v3=\"1\"/><triangle v1=\"0\" v2=\"1\" v3=\"3\"/><triangle v1=\"1\" v2=\"2\" v3=\"3\"/>"
            + "<triangle v1=\"2\" v2=\"0\" v3=\"3\"/></triangles></mesh></object></resources><build>");
        for (var i = 0; i < 4000; i++) model.Append("<item objectid=\"1\"/>");
        RefusesMesh(MeshBytes.ThreeMf(model.Append("</build></model>").ToString()), "items.3mf");
    }

    [Test]
    public void A_face_of_many_vertices()
    {
        var text = new StringBuilder("v 0 0 0\nv 1 0 0\nv 0 1 0\nf");
        for (var i = 0; i < 150_000; i++) text.Append(" 1 2 3");
        RefusesMesh(Encoding.ASCII.GetBytes(text.ToString()), "face.obj");
    }

    [Test]
    public void Many_facets()
    {
        var mesh = TriMesh.Merge(Enumerable.Range(0, 2500).Select(i => MeshMaker.Box(2 * i, 0, 0, 2 * i + 1, 1, 1)));
        RefusesMesh(StlWriter.ToBytes(mesh), "many.stl");
    }

    [Test]
    public void A_packed_file_that_grows()
    {
        var text = new string('#', 8 << 20) + "\nx,y\n0,0\n1,0\n";
        var bytes = Gzip.Packed(Encoding.ASCII.GetBytes(text));
        Assert.That(bytes, Has.Length.LessThan(20_000));
        Refused(CurveReader.Read(bytes, "c.csv.gz", new CurveReadOptions { Memory = Small }), CurveReader.Read(bytes, "c.csv.gz"));
    }

    [Test]
    public void A_fine_division()
    {
        var circle = new UserCurve(ArcCurve.Circle(new Vec3(50, 50, 0.2), 20));
        var options = new CurveOptions { Subdivision = SubdivisionOptions.ByDistance(0.005) };
        Refused(CurvePaths.ToPaths([circle], options with { Memory = Small }), CurvePaths.ToPaths([circle], options));
    }

    [Test]
    public void Thin_layers_and_much_infill()
    {
        var models = new[] { new SliceModel(new NamedMesh("block", MeshMaker.Box(0, 0, 0, 20, 20, 3)), new PrintSettings()) };
        Result<SliceResult> Slice(PrintSettings settings, MemoryLimit memory)
            => PlanarSlicer.SliceEach([new SliceModel(models[0].Mesh, settings)], settings, new SliceOptions { Memory = memory });
        var thin = new PrintSettings { LayerHeight = 0.002, FirstLayerHeight = 0.002, InfillDensityPercent = 0 };
        Refused(Slice(thin, Small), Slice(thin, MemoryLimit.Default));
        Assert.That(Slice(thin, Small).Diagnostics.Single(d => d.Code == MemoryLimit.Code).Message, Does.Contain("1500 layers"));
        var filled = new PrintSettings { InfillDensityPercent = 90, InfillPattern = InfillPattern.Gyroid };
        Refused(Slice(filled, new MemoryLimit(1 << 20)), Slice(filled, MemoryLimit.Default));
    }

    [Test]
    [Category("Arithmetic")]
    public void Long_plans_and_large_images()
    {
        var points = Enumerable.Range(0, 80_000).Select(i => new Vec3(10 + i % 2, 10 + i * 1e-3, 0.2)).ToArray();
        var path = new PrintPath(points, new Bead(0.08, 0.2, 30));
        var setup = new PrintSetup();
        var drawn = new PlanOptions { Policy = PlanPolicy.AsDrawn };
        Refused(Planner.Plan([path], setup, drawn with { Memory = Small }), Planner.Plan([path], setup, drawn));
        var toolpath = Planner.Plan([new PrintPath(points.Take(10), new Bead(0.08, 0.2, 30))], setup, drawn).Value!;
        var options = new ToolpathImageOptions { Width = 1000, Height = 1000, Memory = Small };
        Assert.That(() => ToolpathImage.Draw(toolpath, options), Throws.TypeOf<DiagnosticException>().With.Message.Contains("1000 × 1000 pixels"));
        Assert.That(ToolpathImage.Draw(toolpath, options with { Memory = MemoryLimit.Default }).Width, Is.EqualTo(1000));
    }

    [Test]
    public void Too_many_models_are_refused_before_they_are_compared()
    {
        var model = new SliceModel(new NamedMesh("block", MeshMaker.Box(0, 0, 0, 1, 1, 1)), new PrintSettings());
        var models = Enumerable.Repeat(model, PlanarSlicer.MaxModels + 1).ToArray();
        Assert.That(PlanarSlicer.SliceEach(models, model.Settings).Diagnostics.Single().Code, Is.EqualTo("slice.too_many_models"));
    }
}

using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Meshes;

[TestFixture]
public class ThreeMfTests
{
    private const string Start = MeshBytes.ModelStart;

    [Test]
    public void Items_are_placed_by_their_transforms_and_their_units()
    {
        var model = Start.Replace("millimeter", "inch") + "<resources>" + MeshBytes.ModelObject(7, null, "name=\"brick\"")
            + "</resources><build><item objectid=\"7\" transform=\"0 1 0 -1 0 0 0 0 1 10 0 0\"/><item objectid=\"7\"/></build></model>";
        var read = MeshReader.Read(MeshBytes.ThreeMf(model), "x.3mf");
        Assert.That(read.Diagnostics, Is.Empty);
        Assert.That(read.Value!.Select(m => m.Name), Is.EqualTo(new[] { "brick", "brick" }));
        // A quarter turn about Z, then 10 inches along X.
        var bounds = read.Value![0].Mesh.Bounds;
        Assert.That(bounds.Min.DistanceTo(new Vec3(8 * 25.4, 0, 0)), Is.LessThan(1e-12));
        Assert.That(bounds.Max.DistanceTo(new Vec3(254, 25.4, 76.2)), Is.LessThan(1e-12));
        Assert.That(read.Value[1].Mesh.Volume, Is.EqualTo(6 * 25.4 * 25.4 * 25.4).Within(1e-6));
    }

    [Test]
    public void A_unit_length_holds_for_files_that_state_no_unit()
    {
        var inches = new MeshReadOptions { UnitLength = 25.4 };
        var model = Start + "<resources>" + MeshBytes.ModelObject(7, null, "name=\"brick\"") + "</resources><build><item objectid=\"7\"/></build></model>";
        Assert.That(MeshReader.Read(MeshBytes.ThreeMf(model), "x.3mf", inches).Value![0].Mesh.Volume, Is.EqualTo(6).Within(1e-9), "millimeters");
        var triangle = System.Text.Encoding.ASCII.GetBytes("v 0 0 0\nv 2 0 0\nv 0 3 1\nf 1 2 3\n");
        Assert.That(MeshReader.Read(triangle, "x.obj", inches).Value![0].Mesh.Bounds.Max.DistanceTo(new Vec3(50.8, 76.2, 25.4)), Is.LessThan(1e-12));
        Assert.That(MeshReader.Read(triangle, "x.obj").Value![0].Mesh.Bounds.Max, Is.EqualTo(new Vec3(2, 3, 1)));
    }

    [Test]
    public void Components_are_composed_and_mirrored_ones_face_outward()
    {
        var model = Start + "<resources>" + MeshBytes.ModelObject(1)
            + "<object id=\"2\"><components><component objectid=\"1\"/><component objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 -5 0 "
                + "0\"/></components></object>"
            + "<object id=\"3\"><components><component objectid=\"2\" transform=\"2 0 0 0 2 0 0 0 2 0 0 1\"/></components></object>"
            + "</resources><build><item objectid=\"3\" transform=\"1 0 0 0 1 0 0 0 1 0 0 -1\"/></build></model>";
        var mesh = MeshReader.Read(MeshBytes.ThreeMf(model), "x.3mf").Value!.Single().Mesh;
        Assert.That((mesh.TriangleCount, mesh.BodyCount(), mesh.IsWatertight), Is.EqualTo((24, 2, true)));
        Assert.That(mesh.Volume, Is.EqualTo(96).Within(1e-9));
        Assert.That(mesh.Bounds, Is.EqualTo(new Bounds(new Vec3(-12, 0, 0), new Vec3(2, 4, 6))));
    }

    [Test]
    public void Objects_may_lie_in_other_parts_of_the_package()
    {
        var model = Start + "<resources><object id=\"5\"><components><component p:path=\"/3D/Objects/a.model\" "
            + "objectid=\"9\"/></components></object></resources><build><item objectid=\"5\"/></build></model>";
        var part = Start + "<resources>" + MeshBytes.ModelObject(9) + "</resources><build/></model>";
        var read = MeshReader.Read(MeshBytes.ThreeMf(model, ("3D/Objects/a.model", part)), "x.3mf");
        Assert.That(read.Diagnostics, Is.Empty);
        Assert.That(read.Value!.Single().Mesh.Volume, Is.EqualTo(6).Within(1e-12));
    }

    [Test]
    public void Support_and_unprintable_items_are_ignored()
    {
        var model = Start + "<resources>" + MeshBytes.ModelObject(1) + MeshBytes.ModelObject(2, null, "type=\"support\"")
            + "</resources><build><item objectid=\"1\"/><item objectid=\"2\"/><item objectid=\"1\" printable=\"0\"/></build></model>";
        var read = MeshReader.Read(MeshBytes.ThreeMf(model), "x.3mf");
        Assert.That(read.Value!, Has.Count.EqualTo(1));
        Assert.That(read.Diagnostics.Select(d => (d.Code, d.Count)), Is.EqualTo(new[] { ("mesh.ignored", 2) }));
    }

    [TestCase("<resources/><build><item objectid=\"1\"/></build>", "mesh.index", "Object 1 does not exist.")]
    [TestCase("<resources/><build><item objectid=\"x\"/></build>", "mesh.syntax", "<item> needs an integer \"objectid\".")]
    [TestCase("<resources/><build><item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 0 0 0 0\"/></build>", "mesh.syntax",
        "A transform must have twelve numbers and must not be singular.")]
    [TestCase("<resources><object id=\"1\"><components><component objectid=\"1\"/></components></object></resources><build><item objectid=\"1\"/></build>",
        "mesh.syntax", "Components contain each other, or the file has too many.")]
    [TestCase("<resources><object id=\"1\"><mesh><vertices><vertex x=\"0\" y=\"nan\" z=\"0\"/></vertices></mesh></object></resources>", "mesh.syntax",
        "<vertex> needs a number \"y\".")]
    [TestCase("<resources><object id=\"1\"><mesh><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh></object></resources>", "mesh.index",
        "A triangle uses a vertex that does not exist.")]
    [TestCase("<resources><object id=\"1\"><mesh>", "mesh.syntax", "The XML of the model is damaged.")]
    public void Errors_state_what_is_wrong(string body, string code, string message)
    {
        var read = MeshReader.Read(MeshBytes.ThreeMf(Start + body + "</model>"), "x.3mf");
        Assert.That(read.Value, Is.Null);
        var error = read.Diagnostics.First(d => d.Severity == Severity.Error);
        Assert.That((error.Code, error.Message), Is.EqualTo((code, message)));
        Assert.That(error.Source!.Line, Is.GreaterThan(0));
    }

    [Category("Arithmetic")]
    [Test]
    public void Components_that_multiply_are_stopped()
    {
        var objects = MeshBytes.ModelObject(1);
        for (var id = 2; id < 40; id++) objects += $"<object id=\"{id}\"><components><component objectid=\"{id - 1}\"/><component "
            + $"objectid=\"{id - 1}\"/></components></object>";
        var read = MeshReader.Read(MeshBytes.ThreeMf(Start + "<resources>" + objects + "</resources><build><item objectid=\"39\"/></build></model>"), "x.3mf");
        Assert.That(read.Value, Is.Null);
        Assert.That(read.Diagnostics.Single().Code, Is.EqualTo("mesh.syntax"));
    }

    [Category("Arithmetic")]
    [Test]
    public void Bombs_are_not_decompressed()
    {
        var bytes = MeshBytes.Gzip(new byte[70 << 20]);
        var read = MeshReader.Read(bytes, "x.stl.gz");
        Assert.That(read.Diagnostics.Single().ToString(),
            Is.EqualTo("x.stl.gz: error mesh.compression: The gzip file cannot be decompressed. It decompresses to more than 250 times its size."));
    }
}

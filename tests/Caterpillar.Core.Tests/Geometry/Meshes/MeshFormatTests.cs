using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.Geometry.Meshes;

[TestFixture]
public class MeshFormatTests
{
    public static IEnumerable<TestCaseData> Boxes()
    {
        yield return new TestCaseData(MeshBytes.BinaryStl(), "box.stl").SetName("Box_is_read_from_binary_stl");
        yield return new TestCaseData(MeshBytes.TextStl(), "box.stl").SetName("Box_is_read_from_ascii_stl");
        yield return new TestCaseData(MeshBytes.Obj(), "box.obj").SetName("Box_is_read_from_obj");
        yield return new TestCaseData(MeshBytes.TextPly(), "box.ply").SetName("Box_is_read_from_ascii_ply");
        yield return new TestCaseData(MeshBytes.BinaryPly(false), "box.ply").SetName("Box_is_read_from_little_endian_ply");
        yield return new TestCaseData(MeshBytes.BinaryPly(true), "box.ply").SetName("Box_is_read_from_big_endian_ply");
        yield return new TestCaseData(MeshBytes.ThreeMf(), "box.3mf").SetName("Box_is_read_from_3mf");
        yield return new TestCaseData(MeshBytes.Gzip(MeshBytes.TextStl()), "box.stl.gz").SetName("Box_is_read_from_gzip");
    }

    [TestCaseSource(nameof(Boxes))]
    public void Box_is_read(byte[] bytes, string name)
    {
        foreach (var given in new[] { name, "-" })
        {
            var read = MeshReader.Read(bytes, given);
            Assert.That(read.Diagnostics, Is.Empty, given);
            var mesh = read.Value!.Single().Mesh;
            Assert.That((mesh.VertexCount, mesh.TriangleCount, mesh.IsWatertight), Is.EqualTo((8, 12, true)));
            Assert.That(mesh.Volume, Is.EqualTo(6).Within(1e-12));
            Assert.That(mesh.Bounds, Is.EqualTo(new Bounds(Vec3.Zero, new Vec3(1, 2, 3))));
        }
    }

    [Test]
    public void Names_come_from_the_file_or_its_name()
    {
        Assert.That(MeshReader.Read(MeshBytes.BinaryStl(), "/a/b.c/part.v2.STL.gz").Value!.Single().Name, Is.EqualTo("part.v2"));
        Assert.That(MeshReader.Read(MeshBytes.TextStl(), "part.stl").Value!.Single().Name, Is.EqualTo("box"));
        Assert.That(MeshReader.Read(MeshBytes.Obj(), "part.obj").Value!.Single().Name, Is.EqualTo("box"));
        Assert.That(MeshReader.Read(MeshBytes.ThreeMf(), "part.3mf").Value!.Single().Name, Is.EqualTo("object 1"));
    }

    [TestCase("\\\n")]
    [TestCase("\\\r\n")]
    [TestCase("\\ \t\n")]
    public void A_backslash_at_the_end_of_a_line_of_OBJ_continues_it(string end)
    {
        var text = System.Text.Encoding.ASCII.GetString(MeshBytes.Obj()).Replace("v ", "v " + end + " ");
        Assert.That(MeshReader.Read(System.Text.Encoding.ASCII.GetBytes(text), "box.obj").OrThrow().Single().Mesh.Volume, Is.EqualTo(MeshBytes.Box.Volume));
    }

    [Test]
    public void Ascii_stl_may_have_any_case_white_space_exponents_and_several_solids()
    {
        const string Text = "\uFEFFSOLID the vertex of facet 7\r\nFacet\tNormal nan -nan(ind) 1e400\r\nOuter\tLoop\r\nVertex 0 0 0\tVERTEX 1E+1 0 "
            + "-0\r\nvertex 0 .5e1 0.\r\nEndLoop endfacet\r\nendsolid\r\n"
            + "solid\nfacet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 5 0 vertex 10 0 0 endloop endfacet endsolid b";
        var read = MeshReader.Read(MeshBytes.Text(Text), "x.stl");
        Assert.That(read.Diagnostics, Is.Empty);
        var mesh = read.Value!.Single().Mesh;
        Assert.That(read.Value!.Single().Name, Is.EqualTo("the vertex of facet 7"));
        Assert.That((mesh.TriangleCount, mesh.VertexCount, mesh.IsWatertight), Is.EqualTo((2, 3, true)));
        Assert.That(mesh.Area, Is.EqualTo(50));
    }

    [Test]
    public void Binary_stl_may_begin_with_solid_and_have_attributes()
    {
        var bytes = MeshBytes.BinaryStl();
        MeshBytes.Text("solid facet normal").CopyTo(bytes, 0);
        bytes[84 + 48] = 0xFF;
        Assert.That(MeshReader.Read(bytes, "x.stl").Value!.Single().Mesh.Volume, Is.EqualTo(6).Within(1e-12));
        bytes[80] = 0;
        var uncounted = MeshReader.Read(bytes.Select((b, i) => i < 20 ? (byte)0 : b).ToArray(), "x.stl");
        Assert.That(uncounted.Diagnostics.Single().Code, Is.EqualTo("mesh.facet_count"));
        Assert.That(uncounted.Value!.Single().Mesh.TriangleCount, Is.EqualTo(12));
        var longer = MeshReader.Read([.. MeshBytes.BinaryStl(), 1, 2, 3], "x.stl");
        Assert.That(longer.Diagnostics.Single(),
            Is.EqualTo(new Diagnostic(Severity.Note, "mesh.trailing_bytes", "Bytes after the last facet are ignored.", new SourceLocation("x.stl"), 3)));
    }

    [Test]
    public void Floats_are_widened_exactly()
    {
        var bytes = MeshBytes.BinaryStl();
        BitConverter.GetBytes(0.1f).CopyTo(bytes, 84 + 12);
        var mesh = MeshReader.Read(bytes, "x.stl").Value!.Single().Mesh;
        Assert.That(mesh.Vertices[0].X, Is.EqualTo((double)0.1f));
    }

    [Test]
    public void Facets_that_are_not_finite_are_dropped_and_counted()
    {
        var bytes = MeshBytes.BinaryStl();
        BitConverter.GetBytes(float.NaN).CopyTo(bytes, 84 + 12);
        BitConverter.GetBytes(float.PositiveInfinity).CopyTo(bytes, 84 + 50 + 16);
        BitConverter.GetBytes(1e30f).CopyTo(bytes, 84 + 100 + 16);
        var read = MeshReader.Read(bytes, "x.stl");
        Assert.That(read.Diagnostics.Single(d => d.Code == "mesh.not_finite").Count, Is.EqualTo(3));
        Assert.That(read.Value!.Single().Mesh.TriangleCount, Is.EqualTo(9));
    }

    [Test]
    public void Cracks_of_an_stl_file_are_snapped_and_reported()
    {
        var text = System.Text.Encoding.ASCII.GetString(MeshBytes.TextStl(MeshMaker.Box(0, 0, 0, 10, 20, 30)));
        var at = text.IndexOf("vertex 10 20 30", StringComparison.Ordinal);
        var read = MeshReader.Read(MeshBytes.Text(text.Remove(at, 15).Insert(at, "vertex 10.00001 20 30")), "x.stl");
        Assert.That(read.Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "mesh.snapped" }));
        Assert.That(read.Diagnostics[0].Message, Does.Contain("0.00006 mm"));
        Assert.That(read.Value!.Single().Mesh.IsWatertight, Is.True);
        var wide = MeshReader.Read(MeshBytes.Text(text.Remove(at, 15).Insert(at, "vertex 10.001 20 30")), "x.stl");
        Assert.That(wide.Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "mesh.naked_edges" }), "beyond the snap nothing is moved");
        Assert.That(wide.Value!.Single().Mesh.VertexCount, Is.EqualTo(9));
    }

    [Test]
    public void Obj_polygons_are_fans_and_indices_may_be_negative_or_come_first()
    {
        const string Text = "mtllib missing.mtl\nv 0 0 0 1 0.5 0.5 0.5\nv 4 0 0\nf 1/1/1 -1/2/2 3//3 \\\n 4 # quad\nusemtl red\ng left\nv 4 3 0\nvt 0 0\nvn "
            + "0 0 1\nv 0 3 0\ns off\no other\nl 1 2\nf -1 -2 -3 -4";
        var read = MeshReader.Read(MeshBytes.Text(Text), "x.obj");
        Assert.That(read.Diagnostics, Is.Empty);
        var mesh = read.Value!.Single().Mesh;
        Assert.That(mesh.Indices, Is.EqualTo(new[] { 0, 1, 2, 0, 2, 3, 3, 2, 1, 3, 1, 0 }));
        Assert.That((mesh.IsWatertight, mesh.Area), Is.EqualTo((true, 24.0)));
    }

    [Test]
    public void Obj_lines_that_are_not_read_are_reported_once()
    {
        var read = MeshReader.Read(MeshBytes.Text("v 0 0 0\nv 1 0 0\nv 0 1 0\nfoo 1\nbar 2\ncurv 0 1 2\nf 1 2\nf 1 2 3\n"), "x.obj");
        Assert.That(read.Diagnostics.Select(d => (d.Severity, d.Code, d.Count, d.Source!.Line)), Is.EqualTo(new (Severity, string, int, int?)[]
        {
            (Severity.Note, "mesh.ignored", 2, 4), (Severity.Warning, "mesh.unsupported", 1, 6), (Severity.Warning, "mesh.incomplete_faces", 1, 7),
                (Severity.Note, "mesh.naked_edges", 3, null),
        }));
    }

    [Test]
    public void Duplicate_and_degenerate_faces_are_reported_with_counts()
    {
        var text = System.Text.Encoding.ASCII.GetString(MeshBytes.Obj()) + "f 1 1 2\nf 3 2 3\nf 1 3 2\nf 3 2 1\n";
        var read = MeshReader.Read(MeshBytes.Text(text), "x.obj");
        Assert.That(read.Diagnostics.Select(d => (d.Code, d.Count)), Is.EqualTo(new[] { ("mesh.degenerate_faces", 2), ("mesh.duplicate_faces", 2) }));
        Assert.That(read.Value!.Single().Mesh.IsWatertight, Is.True);
    }

    [Test]
    public void Triangles_that_are_inside_out_are_flipped()
    {
        var hollow = TriMesh.Merge([MeshMaker.BumpySphere(24, 12), MeshMaker.InsideOut(MeshMaker.Box(-3, -3, 33, 3, 3, 39))]);
        var random = new Random(8);
        var indices = hollow.Indices.ToArray();
        var turned = 0;
        for (var t = 0; t < indices.Length - 36; t += 3)
        {
            if (random.Next(3) != 0) continue;
            (indices[t], indices[t + 1]) = (indices[t + 1], indices[t]);
            turned++;
        }
        var read = MeshReader.Read(StlWriter.ToBytes(TriMesh.Create(hollow.Vertices, indices)), "x.stl");
        Assert.That(read.Diagnostics.Select(d => (d.Code, d.Count)), Is.EqualTo(new[] { ("mesh.flipped_faces", turned) }));
        Assert.That(read.Value!.Single().Mesh.IsWatertight);
        Assert.That(read.Value!.Single().Mesh.Volume, Is.EqualTo(hollow.Volume).Within(0.1), "the cavity stays a cavity");
        var all = MeshReader.Read(StlWriter.ToBytes(MeshMaker.InsideOut(hollow)), "x.stl");
        Assert.That(all.Diagnostics.Single().Code, Is.EqualTo("mesh.inside_out"));
        Assert.That(all.Value!.Single().Mesh.Volume, Is.EqualTo(hollow.Volume).Within(0.1));
    }

    [Test]
    public void Ply_faces_may_be_polygons()
    {
        const string Text = "ply\nformat ascii 1.0\nobj_info a b\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
            + "property uchar red\nproperty list uchar uint vertex_indices\nproperty uchar blue\nend_header\n0 0 0\n4 0 0\n4 3 0\n0 3 0\n7 4 0 1 2 3 8\n9 3 "
                + "0 3 2 1";
        var mesh = MeshReader.Read(MeshBytes.Text(Text), "x.ply").Value!.Single().Mesh;
        Assert.That(mesh.Indices, Is.EqualTo(new[] { 0, 1, 2, 0, 2, 3, 0, 3, 2 }));
    }

    [TestCase("x.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 x 0\n", "x.stl:5:10: error mesh.syntax: A coordinate is not a number.")]
    [TestCase("x.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1", "x.stl:5:9: error mesh.truncated: The file ends inside a vertex.")]
    [TestCase("x.stl", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendfacet",
        "x.stl:5:1: error mesh.syntax: A facet has fewer than three vertices.")]
    [TestCase("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1\n", "x.obj:3:6: error mesh.syntax: A vertex needs three numbers.")]
    [TestCase("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "x.obj:4:1: error mesh.index: A face uses vertex 4, but the file has only 3.")]
    [TestCase("x.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n", "x.obj:4:7: error mesh.index: A face uses a vertex that does not exist.")]
    [TestCase("x.obj", "v 0 0 0\nf 1 -2 1\n", "x.obj:2:5: error mesh.index: A face uses a vertex that does not exist.")]
    [TestCase("x.obj", "v 0 0 0\nf 1 a 1\n", "x.obj:2:5: error mesh.syntax: A vertex of a face must be a number or numbers separated by slashes.")]
    [TestCase("x.obj", "# nothing\n", "x.obj: error mesh.empty: The file has no faces.")]
    [TestCase("x.ply", "plz", "x.ply: error mesh.syntax: A PLY file must start with the line \"ply\". (byte 0)")]
    [TestCase("x.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty float x\nend_header\n0",
        "x.ply:6:1: error mesh.truncated: The PLY header states 99999999999 of \"vertex\", more than the file holds.")]
    [TestCase("x.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 zero\n",
        "x.ply:8:5: error mesh.syntax: A value in the vertices is not a number.")]
    [TestCase("x.ply", "ply\nformat ascii 1.0\nelement vertex one\n", "x.ply:3:1: error mesh.syntax: An element needs a name and a count.")]
    [TestCase("x.3mf", "text", "x.3mf: error mesh.syntax: A 3MF file must be a zip archive. (byte 0)")]
    [TestCase("x.txt", "text", "x.txt: error mesh.unknown_format: Unknown mesh format. Use STL, OBJ, PLY or 3MF. (byte 0)")]
    public void Errors_state_what_and_where(string name, string text, string message)
    {
        var read = MeshReader.Read(MeshBytes.Text(text), name);
        Assert.That(read.Value, Is.Null);
        Assert.That(read.Diagnostics.Single(d => d.Severity == Severity.Error).ToString(), Is.EqualTo(message));
    }

    [Test]
    public void Truncated_binary_files_name_the_byte()
    {
        var stl = MeshReader.Read(MeshBytes.BinaryStl().Take(300).ToArray(), "x.stl");
        Assert.That(stl.Diagnostics.Single().ToString(),
            Is.EqualTo("x.stl: error mesh.truncated: The STL header states 12 facets, but the file ends after 4. (byte 300)"));
        var ply = MeshBytes.BinaryPly(true);
        var cut = MeshReader.Read(ply.Take(ply.Length - 20).ToArray(), "x.ply");
        Assert.That(cut.Diagnostics.Single().Code, Is.EqualTo("mesh.truncated"));
        Assert.That(cut.Diagnostics.Single().Message, Does.Contain("(byte "));
    }
}

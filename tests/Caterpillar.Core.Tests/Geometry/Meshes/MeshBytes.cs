using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using Caterpillar.Geometry;

namespace Caterpillar.Tests.Geometry.Meshes;

/// <summary>Files of every format made in memory: a box 1 × 2 × 3 unless stated otherwise.</summary>
internal static class MeshBytes
{
    public const string ModelStart =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
        + "xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\">\n";

    public static TriMesh Box { get; } = MeshMaker.Box(0, 0, 0, 1, 2, 3);

    public static byte[] Text(string text) => Encoding.UTF8.GetBytes(text);

    public static byte[] BinaryStl() => StlWriter.ToBytes(Box);

    public static byte[] TextStl(TriMesh? mesh = null)
    {
        mesh ??= Box;
        var text = new StringBuilder("solid box\n");
        for (var t = 0; t < mesh.TriangleCount; t++)
        {
            var (a, b, c) = mesh.Triangle(t);
            text.Append(" facet normal 0 0 0\n  outer loop\n");
            foreach (var p in new[] { mesh.Vertices[a], mesh.Vertices[b], mesh.Vertices[c] }) text.Append("   vertex ").Append(Numbers(p)).Append('\n');
            text.Append("  endloop\n endfacet\n");
        }
        return Text(text.Append("endsolid box\n").ToString());
    }

    public static byte[] Obj()
        => Text("# box\no box\n" + string.Concat(Box.Vertices.Select(p => "v " + Numbers(p) + "\n"))
            + string.Concat(Triples(Box).Select(t => $"f {t.A + 1}/1 {t.B + 1}//2 {t.C + 1}\n")));

    public static byte[] TextPly() => Text(
        "ply\nformat ascii 1.0\ncomment box\nelement vertex 8\nproperty double x\nproperty double y\nproperty double z\nelement face 12\nproperty list uchar "
            + "int vertex_indices\nend_header\n"
        + string.Concat(Box.Vertices.Select(p => Numbers(p) + "\n")) + string.Concat(Triples(Box).Select(t => $"3 {t.A} {t.B} {t.C}\n")));

    /// <summary>Binary PLY with an element before, one after, a list in the vertices and properties around the list of the faces.</summary>
    public static byte[] BinaryPly(bool bigEndian)
    {
        var data = new List<byte>(Text($"ply\r\nformat binary_{(bigEndian ? "big" : "little")}_endian 1.0\r\nelement before 2\r\nproperty list uint8 double "
            + $"d\r\nproperty short s\r\n"
            + "element vertex 8\r\nproperty float z\r\nproperty list uchar ushort l\r\nproperty float x\r\nproperty uchar red\r\nproperty double y\r\n"
            + "element face 12\r\nproperty char a\r\nproperty list uint uint16 vertex_index\r\nproperty list uchar float b\r\nelement after 1\r\nproperty "
                + "int i\r\nend_header\r\n"));
        void Put(byte[] bytes) => data.AddRange(bigEndian ? Enumerable.Reverse(bytes) : bytes);
        for (var i = 0; i < 2; i++)
        {
            data.Add((byte)i);
            for (var k = 0; k < i; k++) Put(BitConverter.GetBytes(1.5));
            Put(BitConverter.GetBytes((short)7));
        }
        foreach (var p in Box.Vertices)
        {
            Put(BitConverter.GetBytes((float)p.Z));
            data.Add(2);
            Put(BitConverter.GetBytes((ushort)1));
            Put(BitConverter.GetBytes((ushort)2));
            Put(BitConverter.GetBytes((float)p.X));
            data.Add(255);
            Put(BitConverter.GetBytes(p.Y));
        }
        foreach (var (a, b, c) in Triples(Box))
        {
            data.Add(1);
            Put(BitConverter.GetBytes(3u));
            foreach (var v in new[] { a, b, c }) Put(BitConverter.GetBytes((ushort)v));
            data.Add(0);
        }
        Put(BitConverter.GetBytes(99));
        return data.ToArray();
    }

    public static string ModelObject(int id, TriMesh? mesh = null, string attributes = "")
    {
        mesh ??= Box;
        return $"<object id=\"{id}\" {attributes}><mesh><vertices>"
            + string.Concat(mesh.Vertices.Select(p => $"<vertex x=\"{Number(p.X)}\" y=\"{Number(p.Y)}\" z=\"{Number(p.Z)}\"/>")) + "</vertices><triangles>"
            + string.Concat(Triples(mesh).Select(t => $"<triangle v1=\"{t.A}\" v2=\"{t.B}\" v3=\"{t.C}\"/>")) + "</triangles></mesh></object>\n";
    }

    public static byte[] ThreeMf(string? model = null, params (string Path, string Text)[] more)
    {
        model ??= ModelStart + "<resources>" + ModelObject(1) + "</resources><build><item objectid=\"1\"/></build></model>";
        using var memory = new MemoryStream();
        using (var zip = new ZipArchive(memory, ZipArchiveMode.Create, true))
        {
            var rels = "<?xml version=\"1.0\"?><Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
                + "<Relationship Target=\"/3D/box.model\" Id=\"rel0\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>";
            // The model comes last: it is the one that the package names, not the first.
            foreach (var (path, text) in more.Concat([("_rels/.rels", rels), ("3D/box.model", model)]))
            {
                using var stream = zip.CreateEntry(path).Open();
                var bytes = Text(text);
                stream.Write(bytes, 0, bytes.Length);
            }
        }
        return memory.ToArray();
    }

    public static byte[] Gzip(byte[] bytes)
    {
        using var memory = new MemoryStream();
        using (var zip = new GZipStream(memory, CompressionMode.Compress, true)) zip.Write(bytes, 0, bytes.Length);
        return memory.ToArray();
    }

    private static IEnumerable<(int A, int B, int C)> Triples(TriMesh mesh) => Enumerable.Range(0, mesh.TriangleCount).Select(mesh.Triangle);

    private static string Numbers(Vec3 p) => Number(p.X) + " " + Number(p.Y) + " " + Number(p.Z);

    private static string Number(double value) => Caterpillar.Basics.NumberFormatter.Format(value, 9);
}

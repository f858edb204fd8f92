using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>Rhino geometry as Grasshopper stores it in a definition: openNURBS in an object of RhinoCommon, as .NET serializes it, deflated.</summary>
internal static class RhinoBytes
{
    private const string Library = "RhinoCommon, Version=7.37.24107.15001, Culture=neutral, PublicKeyToken=552281e97c755530";
    private const int Form = 10000;
    private const int Archive = 4;
    private const int OpenNurbs = 201508105;
    private const int Class = 0x00027FFA;
    private const int ClassId = 0x0002FFFB;
    private const int ClassData = 0x0002FFFC;
    private const int ClassEnd = unchecked((int)0x82027FFF);

    public static byte[] Polyline(IReadOnlyList<Rg.Point3d> points) => Of("PolylineCurve", "4ED7D4E6-E947-11d3-BFE5-0010830122F0", w =>
    {
        w.Write((byte)0x10);
        w.Write(points.Count);
        foreach (var point in points) Write(w, point.X, point.Y, point.Z);
        w.Write(points.Count);
        for (var i = 0; i < points.Count; i++) w.Write((double)i);
        w.Write(3);
    });

    /// <summary>Faces are triangles or quadrilaterals.</summary>
    public static byte[] Mesh(IReadOnlyList<Rg.Point3d> vertices, IReadOnlyList<int[]> faces) => Of("Mesh", "4ED7D4E4-E947-11d3-BFE5-0010830122F0", w =>
    {
        w.Write((byte)0x30);
        w.Write(vertices.Count);
        w.Write(faces.Count);
        Write(w, 0, 1, 0, 1, 0, 1, 0, 1, 1, 1);
        foreach (var pick in new Func<IEnumerable<double>, double>[] { Enumerable.Min, Enumerable.Max })
        {
            w.Write((float)pick(vertices.Select(v => v.X)));
            w.Write((float)pick(vertices.Select(v => v.Y)));
            w.Write((float)pick(vertices.Select(v => v.Z)));
        }
        // No normals and no texture.
        foreach (var value in new[] { 1f, 1, 1, -1, -1, -1, 1, 1, -1, -1 }) w.Write(value);
        w.Write(-1);
        w.Write(new byte[5]);
        w.Write(2);
        foreach (var face in faces)
        {
            for (var i = 0; i < 4; i++) w.Write((ushort)face[Math.Min(i, face.Length - 1)]);
        }
        var places = new MemoryStream();
        using (var floats = new BinaryWriter(places))
        {
            foreach (var v in vertices)
            {
                floats.Write((float)v.X);
                floats.Write((float)v.Y);
                floats.Write((float)v.Z);
            }
        }
        Buffer(w, places.ToArray());
        for (var empty = 0; empty < 4; empty++) w.Write(0);
    });

    /// <summary>A Brep from an object of an archive.</summary>
    public static byte[] Brep(byte[] written) => Deflated(Made(w => Serialize(w, "Rhino.Geometry.Brep", written)));

    private static byte[] Of(string name, string id, Action<BinaryWriter> body)
    {
        var content = Made(body);
        var inside = Made(w =>
        {
            Chunk(w, ClassId, new Guid(id).ToByteArray());
            Chunk(w, ClassData, content);
            w.Write(ClassEnd);
            w.Write(0);
        });
        var data = Made(w =>
        {
            w.Write(Class);
            w.Write(inside.Length);
            w.Write(inside);
        });
        return Deflated(Made(w => Serialize(w, "Rhino.Geometry." + name, data)));
    }

    // The records of .NET's binary form: head, library, an object of four members, its bytes, the end.
    private static void Serialize(BinaryWriter w, string name, byte[] data)
    {
        w.Write((byte)0);
        foreach (var head in new[] { 1, -1, 1, 0 }) w.Write(head);
        w.Write((byte)12);
        w.Write(2);
        w.Write(Library);
        w.Write((byte)5);
        w.Write(1);
        w.Write(name);
        w.Write(4);
        foreach (var member in new[] { "version", "archive3dm", "opennurbs", "data" }) w.Write(member);
        w.Write(new byte[] { 0, 0, 0, 7, 8, 8, 8, 2 });
        foreach (var value in new[] { 2, Form, Archive, OpenNurbs }) w.Write(value);
        w.Write((byte)9);
        w.Write(3);
        w.Write((byte)15);
        w.Write(3);
        w.Write(data.Length);
        w.Write((byte)2);
        w.Write(data);
        w.Write((byte)11);
    }

    private static void Chunk(BinaryWriter w, int code, byte[] content)
    {
        w.Write(code);
        w.Write(content.Length + 4);
        w.Write(content);
        w.Write(Crc(content));
    }

    private static void Buffer(BinaryWriter w, byte[] content)
    {
        w.Write(content.Length);
        w.Write(Crc(content));
        w.Write((byte)0);
        w.Write(content);
    }

    // Blocks that are stored as they are: the same bytes from every runtime.
    private static byte[] Deflated(byte[] content) => Made(w =>
    {
        const int Most = 60_000;
        for (var at = 0; at < content.Length; at += Most)
        {
            var count = Math.Min(Most, content.Length - at);
            w.Write((byte)(at + count == content.Length ? 1 : 0));
            w.Write((ushort)count);
            w.Write((ushort)~count);
            w.Write(content, at, count);
        }
    });

    private static byte[] Made(Action<BinaryWriter> write)
    {
        var stream = new MemoryStream();
        using (var writer = new BinaryWriter(stream, Encoding.UTF8)) write(writer);
        return stream.ToArray();
    }

    private static void Write(BinaryWriter w, params double[] values)
    {
        foreach (var value in values) w.Write(value);
    }

    private static uint Crc(byte[] bytes)
    {
        var crc = uint.MaxValue;
        foreach (var b in bytes)
        {
            crc ^= b;
            for (var k = 0; k < 8; k++) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xEDB88320 : crc >> 1;
        }
        return ~crc;
    }
}

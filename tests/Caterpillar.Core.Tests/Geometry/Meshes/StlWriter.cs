using System;
using System.IO;
using System.Text;
using Caterpillar.Geometry;

namespace Caterpillar.Tests.Geometry.Meshes;

/// <summary>Writes binary STL. Coordinates become floats, as the format requires; the bytes are the same everywhere.</summary>
internal static class StlWriter
{
    /// <summary>
    /// The file as bytes: an 80-byte header with <paramref name="title"/> (ASCII, at most 79 characters), the count, and 50 bytes for each
    /// triangle.
    /// </summary>
    /// <exception cref="ArgumentException">The title begins with "solid", which would make readers take the file for text.</exception>
    public static byte[] ToBytes(TriMesh mesh, string title = "Caterpillar")
    {
        if (mesh is null) throw new ArgumentNullException(nameof(mesh));
        if (title is null) throw new ArgumentNullException(nameof(title));
        if (title.StartsWith("solid", StringComparison.OrdinalIgnoreCase))
        {
            throw new ArgumentException("The title of a binary STL file must not begin with \"solid\".", nameof(title));
        }
        var bytes = new byte[84 + 50 * mesh.TriangleCount];
        var header = Encoding.ASCII.GetBytes(title);
        Array.Copy(header, bytes, Math.Min(79, header.Length));
        PutInt(bytes, 80, mesh.TriangleCount);
        for (var t = 0; t < mesh.TriangleCount; t++)
        {
            var at = 84 + 50 * t;
            var (a, b, c) = mesh.Triangle(t);
            PutVector(bytes, at, mesh.Normal(t));
            PutVector(bytes, at + 12, mesh.Vertices[a]);
            PutVector(bytes, at + 24, mesh.Vertices[b]);
            PutVector(bytes, at + 36, mesh.Vertices[c]);
        }
        return bytes;
    }

    /// <summary>Writes the file.</summary>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public static void Write(TriMesh mesh, string path, string title = "Caterpillar") => File.WriteAllBytes(path, ToBytes(mesh, title));

    private static void PutVector(byte[] bytes, int at, Vec3 v)
    {
        PutFloat(bytes, at, v.X);
        PutFloat(bytes, at + 4, v.Y);
        PutFloat(bytes, at + 8, v.Z);
    }

    // −0.0 is written as 0.0.
    private static void PutFloat(byte[] bytes, int at, double value) => PutInt(bytes, at, BitConverter.ToInt32(BitConverter.GetBytes((float)(value + 0.0)), 0));

    private static void PutInt(byte[] bytes, int at, int value)
    {
        for (var i = 0; i < 4; i++) bytes[at + i] = (byte)(value >> (8 * i));
    }
}

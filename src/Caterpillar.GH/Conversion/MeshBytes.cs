namespace Caterpillar.GH.Conversion;

/// <summary>A mesh as a definition stores it: counts, vertices in mm, and three indices for each triangle.</summary>
internal static class MeshBytes
{
    public static byte[] Pack(TriMesh mesh)
    {
        using var bytes = new MemoryStream();
        using var writer = new BinaryWriter(bytes);
        writer.Write(mesh.Vertices.Count);
        writer.Write(mesh.Indices.Count);
        foreach (var vertex in mesh.Vertices)
        {
            writer.Write(vertex.X);
            writer.Write(vertex.Y);
            writer.Write(vertex.Z);
        }
        foreach (var index in mesh.Indices) writer.Write(index);
        writer.Flush();
        return bytes.ToArray();
    }

    /// <summary>The mesh. Null if the bytes are damaged.</summary>
    public static TriMesh? Unpack(byte[] packed)
    {
        const int Head = 8, Point = 24, Index = 4;
        if (packed.Length < Head) return null;
        using var reader = new BinaryReader(new MemoryStream(packed));
        var (points, corners) = (reader.ReadInt32(), reader.ReadInt32());
        if (points < 0 || corners < 0 || packed.Length - Head != (long)Point * points + (long)Index * corners) return null;
        var vertices = new Vec3[points];
        var indices = new int[corners];
        for (var i = 0; i < vertices.Length; i++) vertices[i] = new Vec3(reader.ReadDouble(), reader.ReadDouble(), reader.ReadDouble());
        for (var i = 0; i < indices.Length; i++) indices[i] = reader.ReadInt32();
        try
        {
            return TriMesh.Create(vertices, indices);
        }
        catch (ArgumentException)
        {
            return null;
        }
    }
}

namespace Caterpillar.GH.Conversion;

/// <summary>A model for the library with Rhino's mesh of it, which shows its open edges.</summary>
internal sealed record ModelMesh(Rg.Mesh Mesh, TriMesh Triangles)
{
    /// <summary>The mesh of anything that can be sliced. The tolerance, in mm, is the maximum deviation of facets from a curved surface.</summary>
    /// <exception cref="InputProblem">It has no surface, or Rhino can't mesh it.</exception>
    public static ModelMesh Of(object geometry, double tolerance, DocumentUnits units)
    {
        var mesh = RhinoMesh.ToMesh(geometry, tolerance, units);
        return new ModelMesh(mesh, RhinoMesh.ToTriangles(mesh, units));
    }

    /// <summary>The triangles of several models as one mesh. Null for none.</summary>
    public static TriMesh? Joined(IReadOnlyCollection<ModelMesh> models) => models.Count == 0 ? null : TriMesh.Merge(models.Select(m => m.Triangles));

    /// <summary>Parts of a key that change with the geometry. Rhino's checksum of a mesh is taken from single-precision points, which is too coarse.</summary>
    public static object?[] Content(object geometry) => geometry switch
    {
        Rg.Mesh mesh => [typeof(Rg.Mesh), mesh.Vertices.Count, mesh.Faces.Count, Digest(mesh)],
        Rg.GeometryBase other => [other.GetType(), other.DataCRC(0), other.GetBoundingBox(true)],
        _ => [geometry],
    };

    private static ulong Digest(Rg.Mesh mesh)
    {
        var hash = 14695981039346656037UL;
        void Add(long value) => hash = unchecked((hash ^ (ulong)value) * 1099511628211UL) ^ (hash >> 29);
        foreach (var p in mesh.Vertices.ToPoint3dArray())
        {
            Add(BitConverter.DoubleToInt64Bits(p.X));
            Add(BitConverter.DoubleToInt64Bits(p.Y));
            Add(BitConverter.DoubleToInt64Bits(p.Z));
        }
        for (var i = 0; i < mesh.Faces.Count; i++)
        {
            var f = mesh.Faces[i];
            Add(((long)f.A << 32) | (uint)f.B);
            Add(((long)f.C << 32) | (uint)f.D);
        }
        return hash;
    }
}

namespace Caterpillar.Display;

/// <summary>A mesh as columns of a viewer page: coordinates of the vertices in µm, then the vertex indices of the corners.</summary>
internal static class ModelColumns
{
    public static IEnumerable<byte[]> Of(TriMesh model)
    {
        PackedColumn x = new("x"), y = new("y"), z = new("z"), corners = new("corners");
        foreach (var vertex in model.Vertices)
        {
            x.Add(vertex.X, 1e-3);
            y.Add(vertex.Y, 1e-3);
            z.Add(vertex.Z, 1e-3);
        }
        foreach (var corner in model.Indices) corners.Add(corner);
        foreach (var column in new[] { x, y, z, corners }) yield return column.ToBytes();
    }
}

namespace Caterpillar.Geometry;

/// <summary>Divides the edges of a mesh until none is longer than a length; its surface stays the same, and closed meshes stay closed.</summary>
internal static class MeshRefiner
{
    /// <summary>The vertices of the mesh keep their numbers; new ones follow.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="longest">mm, positive.</param>
    /// <param name="most">No further division from so many triangles on.</param>
    /// <param name="cancel">Cancels the call.</param>
    /// <returns>The mesh, and for each new vertex the two in whose middle it lies.</returns>
    public static (TriMesh Mesh, IReadOnlyList<(int A, int B)> Parents) Refine(TriMesh mesh, double longest, int most, CancellationToken cancel)
    {
        var divided = new DividedMesh(mesh);
        var first = 0;
        while (divided.Count < most)
        {
            cancel.ThrowIfCancellationRequested();
            var faces = divided.FaceCount;
            for (var face = first; face < faces; face++)
            {
                var edge = divided.Longest(face);
                if (divided.Square(edge) > longest * longest) divided.Divide(edge);
            }
            if (!divided.Split()) break;
            first = faces;
        }
        var parents = new (int A, int B)[divided.Points.Count - mesh.VertexCount];
        for (var edge = 0; edge < divided.EdgeCount; edge++)
        {
            if (divided.Middle(edge) is >= 0 and var vertex) parents[vertex - mesh.VertexCount] = divided.Ends(edge);
        }
        return (divided.ToMesh(divided.Points), parents);
    }
}

namespace Caterpillar.Geometry;

/// <summary>
/// Values on a mesh that are given at some vertices and as even as can be between them: the solution of Laplace's equation with cotangent weights (Pinkall and
/// Polthier, 1993). Linear functions are kept on flat places whatever the triangles.
/// </summary>
internal static class HarmonicValues
{
    /// <summary>A value for every vertex; every piece of the mesh has a vertex with a value.</summary>
    /// <param name="mesh">The mesh.</param>
    /// <param name="given">A value for each vertex that has one, NaN for the others.</param>
    /// <param name="cancel">Cancels the call.</param>
    public static double[] Solve(TriMesh mesh, double[] given, CancellationToken cancel)
    {
        var row = new int[given.Length];
        var count = 0;
        for (var i = 0; i < row.Length; i++) row[i] = double.IsNaN(given[i]) ? count++ : -1;
        if (count == 0) return [.. given];
        var entries = new List<(int Row, int Column, double Value)>();
        double[] diagonal = new double[count], right = new double[count], x = new double[count];
        foreach (var (a, b, weight) in Weights(mesh))
        {
            if (row[a] >= 0) diagonal[row[a]] += weight;
            if (row[b] >= 0) diagonal[row[b]] += weight;
            if (row[a] >= 0 && row[b] >= 0)
            {
                entries.Add((row[a], row[b], -weight));
            }
            else if (row[a] >= 0)
            {
                right[row[a]] += weight * given[b];
            }
            else if (row[b] >= 0)
            {
                right[row[b]] += weight * given[a];
            }
        }
        for (var i = 0; i < count; i++) diagonal[i] = Math.Max(diagonal[i], 1e-9);
        new SparseSystem(entries, diagonal).Solve(right, x, 1e-8, cancel);
        return given.Select((value, i) => row[i] >= 0 ? x[row[i]] : value).ToArray();
    }

    // One entry for each edge, in the order of its vertices.
    private static IEnumerable<(int A, int B, double Weight)> Weights(TriMesh mesh)
    {
        var (points, triangles) = (mesh.RawVertices, mesh.RawTriangles);
        var (_, keys) = MeshTopology.SortedEdges(mesh.VertexCount, triangles, out var sameAsBefore);
        var weight = 0.0;
        for (var i = 0; i < keys.Length; i++)
        {
            int side = (int)keys[i], next = MeshTopology.Next(side);
            int a = triangles[side], b = triangles[next], c = triangles[MeshTopology.Next(next)];
            Vec3 u = points[a] - points[c], v = points[b] - points[c];
            var cross = Vec3.Cross(u, v).Length;
            weight = (sameAsBefore[i] ? weight : 0) + (cross > 0 ? Vec3.Dot(u, v) / cross / 2 : 0);
            if (i + 1 == keys.Length || !sameAsBefore[i + 1]) yield return (a, b, weight);
        }
    }
}

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
        var values = (double[])given.Clone();
        var row = new int[values.Length];
        var count = 0;
        for (var i = 0; i < row.Length; i++) row[i] = double.IsNaN(given[i]) ? count++ : -1;
        if (count == 0) return values;
        var entries = new List<(int Row, int Column)>();
        var weights = new List<double>();
        double[] diagonal = new double[count], right = new double[count], x = new double[count];
        foreach (var (a, b, weight) in Weights(mesh))
        {
            if (row[a] >= 0) diagonal[row[a]] += weight;
            if (row[b] >= 0) diagonal[row[b]] += weight;
            if (row[a] >= 0 && row[b] >= 0)
            {
                entries.Add((row[a], row[b]));
                entries.Add((row[b], row[a]));
                weights.Add(-weight);
                weights.Add(-weight);
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
        new SparseSystem(count, entries.ToArray(), weights.ToArray(), diagonal).Solve(right, x, 1e-10, cancel);
        for (var i = 0; i < row.Length; i++)
        {
            if (row[i] >= 0) values[i] = x[row[i]];
        }
        return values;
    }

    // One entry for each edge, in the order of its vertices.
    private static List<(int A, int B, double Weight)> Weights(TriMesh mesh)
    {
        var points = mesh.RawVertices;
        var triangles = mesh.RawTriangles;
        var halves = new (long Edge, double Weight)[triangles.Length];
        for (var t = 0; t < triangles.Length; t += 3)
        {
            for (var k = 0; k < 3; k++)
            {
                int a = triangles[t + k], b = triangles[t + (k + 1) % 3], c = triangles[t + (k + 2) % 3];
                Vec3 u = points[a] - points[c], v = points[b] - points[c];
                var cross = Vec3.Cross(u, v).Length;
                halves[t + k] = (((long)Math.Min(a, b) << 32) | (uint)Math.Max(a, b), cross > 0 ? Vec3.Dot(u, v) / cross / 2 : 0);
            }
        }
        Array.Sort(halves, (p, q) => p.Edge != q.Edge ? p.Edge.CompareTo(q.Edge) : p.Weight.CompareTo(q.Weight));
        var result = new List<(int A, int B, double Weight)>(halves.Length / 2 + 1);
        for (var i = 0; i < halves.Length;)
        {
            var edge = halves[i].Edge;
            var weight = 0.0;
            for (; i < halves.Length && halves[i].Edge == edge; i++) weight += halves[i].Weight;
            result.Add(((int)(edge >> 32), (int)(uint)edge, weight));
        }
        return result;
    }
}

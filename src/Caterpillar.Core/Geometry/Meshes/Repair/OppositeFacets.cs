namespace Caterpillar.Geometry;

/// <summary>
/// Removes duplicate triangles with opposite directions, which cancel each other. The one that continues its neighbors stays. If the only neighbors of a
/// pair are other pairs (a shell that is duplicated as a whole), the first stays. If both continue neighbors (bodies that share a face), both stay.
/// </summary>
internal static class OppositeFacets
{
    public static (TriMesh Mesh, int Dropped) Drop(TriMesh mesh)
    {
        if (mesh.Topology.NonManifoldEdges == 0) return (mesh, 0);
        var triangles = mesh.RawTriangles;
        var pairs = Pairs(triangles);
        if (pairs.Count == 0) return (mesh, 0);
        var paired = new bool[mesh.TriangleCount];
        var edges = new Dictionary<long, (int Net, int Count)>();
        foreach (var (first, second) in pairs)
        {
            paired[first] = paired[second] = true;
            for (var k = 0; k < 3; k++) edges[Edge(triangles, 3 * first + k).Key] = (0, 0);
        }
        for (var h = 0; h < triangles.Length; h++)
        {
            if (paired[h / 3]) continue;
            var (key, forward) = Edge(triangles, h);
            if (edges.TryGetValue(key, out var sum)) edges[key] = (sum.Net + (forward ? 1 : -1), sum.Count + 1);
        }
        var drop = new bool[mesh.TriangleCount];
        var dropped = 0;
        foreach (var (first, second) in pairs)
        {
            int score = 0, neighbors = 0;
            for (var k = 0; k < 3; k++)
            {
                var (key, forward) = Edge(triangles, 3 * first + k);
                var (net, count) = edges[key];
                score -= forward ? Math.Sign(net) : -Math.Sign(net);
                neighbors += count;
            }
            if (score == 0 && neighbors > 0) continue;
            drop[score >= 0 ? second : first] = true;
            dropped++;
        }
        if (dropped == 0) return (mesh, 0);
        var left = triangles.Where((_, h) => !drop[h / 3]).ToArray();
        return (TriMesh.Own(MeshCleaning.DropUnused(mesh.RawVertices, left), left), dropped);
    }

    // Each triangle with the first later one that has the same corners in the other direction.
    private static List<(int First, int Second)> Pairs(int[] triangles)
    {
        var known = new Dictionary<(int, int, int), int>();
        var pairs = new List<(int, int)>();
        for (var t = 0; t < triangles.Length / 3; t++)
        {
            int a = triangles[3 * t], b = triangles[3 * t + 1], c = triangles[3 * t + 2];
            if (known.TryGetValue(MeshCleaning.Turned(a, c, b), out var other))
            {
                pairs.Add((other, t));
                known.Remove(MeshCleaning.Turned(a, c, b));
            }
            else
            {
                known[MeshCleaning.Turned(a, b, c)] = t;
            }
        }
        return pairs;
    }

    private static (long Key, bool Forward) Edge(int[] triangles, int halfEdge)
    {
        int from = triangles[halfEdge], to = triangles[MeshTopology.Next(halfEdge)];
        return from < to ? ((long)from << 32 | (uint)to, true) : ((long)to << 32 | (uint)from, false);
    }
}

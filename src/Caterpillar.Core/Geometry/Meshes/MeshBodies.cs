namespace Caterpillar.Geometry;

/// <summary>Sets of triangles that are connected across edges.</summary>
internal static class MeshBodies
{
    public static int Count(TriMesh mesh)
    {
        var bodies = mesh.TriangleCount;
        var parents = new int[mesh.TriangleCount];
        for (var t = 0; t < parents.Length; t++) parents[t] = t;
        var (_, keys) = MeshTopology.SortedEdges(mesh.VertexCount, mesh.RawTriangles, out var sameAsBefore);
        for (var i = 1; i < keys.Length; i++)
        {
            if (!sameAsBefore[i]) continue;
            var ra = Root(parents, (int)keys[i - 1] / 3);
            var rb = Root(parents, (int)keys[i] / 3);
            if (ra == rb) continue;
            parents[ra > rb ? ra : rb] = ra > rb ? rb : ra;
            bodies--;
        }
        return bodies;
    }

    private static int Root(int[] parents, int at)
    {
        while (parents[at] != at) at = parents[at] = parents[parents[at]];
        return at;
    }
}

namespace Caterpillar.Geometry;

/// <summary>
/// Joins naked edges: vertices on naked edges that are closer to each other than a quarter of the shortest edge at them, and than 1 mm, become one. The
/// vertex of the larger piece stays. The result is kept only if it has fewer naked edges.
/// </summary>
internal static class EdgeSnap
{
    private const double Share = 0.25;

    public static (TriMesh Mesh, int Moved, double Farthest) Close(TriMesh mesh)
    {
        if (mesh.NakedEdgeCount == 0) return (mesh, 0, 0);
        var reach = Reaches(mesh);
        var (targets, moved, farthest) = VertexSnap.Targets(mesh, reach, LargePiecesFirst(mesh, reach));
        if (moved == 0) return (mesh, 0, 0);
        var closed = MeshBuilder.Merging(mesh, targets).ToMesh();
        return closed.NakedEdgeCount < mesh.NakedEdgeCount ? (closed, moved, farthest) : (mesh, 0, 0);
    }

    // How far each vertex may go, 0 for those on no open edge.
    private static double[] Reaches(TriMesh mesh)
    {
        var partner = mesh.Topology.Partner;
        var shortest = new double[mesh.VertexCount];
        var open = new bool[mesh.VertexCount];
        for (var v = 0; v < shortest.Length; v++) shortest[v] = double.PositiveInfinity;
        for (var h = 0; h < partner.Length; h++)
        {
            int a = mesh.RawTriangles[h], b = mesh.RawTriangles[MeshTopology.Next(h)];
            var length = mesh.RawVertices[a].DistanceTo(mesh.RawVertices[b]);
            shortest[a] = Math.Min(shortest[a], length);
            shortest[b] = Math.Min(shortest[b], length);
            if (partner[h] < 0) open[a] = open[b] = true;
        }
        for (var v = 0; v < shortest.Length; v++) shortest[v] = open[v] ? Math.Min(VertexSnap.Largest, Share * shortest[v]) : 0;
        return shortest;
    }

    // The vertices that may move, those of large pieces first: by the size of their piece in powers of two.
    private static int[] LargePiecesFirst(TriMesh mesh, double[] reach)
    {
        const int Sizes = 32;
        var pieces = new MeshPieces(mesh);
        var largest = pieces.Area.Max();
        var kinds = new byte[pieces.Count];
        for (var i = 0; i < kinds.Length; i++)
        {
            for (var size = largest / 2; kinds[i] < Sizes - 1 && pieces.Area[i] < size; size /= 2) kinds[i]++;
        }
        var kind = Enumerable.Repeat((byte)Sizes, mesh.VertexCount).ToArray();
        for (var h = 0; h < mesh.RawTriangles.Length; h++)
        {
            var v = mesh.RawTriangles[h];
            if (reach[v] > 0) kind[v] = Math.Min(kind[v], kinds[pieces.Of[h / 3]]);
        }
        return Enumerable.Range(0, kind.Length).Where(v => kind[v] < Sizes).OrderBy(v => kind[v]).ToArray();
    }
}

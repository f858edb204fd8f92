namespace Caterpillar.Geometry;

/// <summary>
/// Fills holes of a surface: closed rings of open edges, each with a <see cref="RingPatch"/>. One missing triangle so comes back as it was. Rings of many
/// edges, and rings whose filling is about as large as the surface around them (the rim of a sheet), stay open.
/// </summary>
internal static class HoleFiller
{
    private const int MaxEdges = 64;
    private const double MaxShare = 0.9;

    /// <summary>The mesh without holes and without loose triangles at them, the holes, and the number of removed triangles.</summary>
    public static (TriMesh Mesh, IReadOnlyList<FilledHole> Holes, int Loose) Fill(TriMesh mesh, CancellationToken cancel)
    {
        if (mesh.Topology.IsPaired) return (mesh, [], 0);
        var pieces = new MeshPieces(mesh);
        var holes = new List<FilledHole>();
        var repaired = new bool[pieces.Count];
        var added = new List<int>();
        var patch = new List<int>();
        foreach (var (ring, piece) in Rings(mesh, pieces))
        {
            cancel.ThrowIfCancellationRequested();
            if (ring.Length > MaxEdges) continue;
            patch.Clear();
            var area = RingPatch.Fill(mesh, ring, patch);
            if (area > MaxShare * pieces.Area[piece]) continue;
            added.AddRange(patch);
            repaired[piece] = true;
            holes.Add(new FilledHole(Bounds.Of(ring.Select(edge => mesh.RawVertices[mesh.RawTriangles[edge]])), area));
        }
        if (holes.Count == 0) return (mesh, holes, 0);
        var loose = LoosePieces.Find(mesh, pieces, repaired, holes);
        var triangles = mesh.RawTriangles.Where((_, h) => !loose[pieces.Of[h / 3]]).ToList();
        var left = mesh.TriangleCount - triangles.Count / 3;
        triangles.AddRange(added);
        var all = triangles.ToArray();
        return (TriMesh.Own(MeshCleaning.DropUnused(mesh.RawVertices, all), all), holes, left);
    }

    // Rings of at least three half-edges, each named where it begins, in the direction in which the missing triangles run around them: against that of the
    // half-edges. A walk that passes a vertex twice is cut into two rings there.
    private static IEnumerable<(int[] Ring, int Piece)> Rings(TriMesh mesh, MeshPieces pieces)
    {
        var partner = mesh.Topology.Partner;
        var triangles = mesh.RawTriangles;
        var seen = new bool[partner.Length];
        var walk = new List<int>();
        var places = new Dictionary<int, int>();
        for (var start = 0; start < partner.Length; start++)
        {
            if (partner[start] >= 0 || seen[start]) continue;
            walk.Clear();
            places.Clear();
            var edge = start;
            do
            {
                seen[edge] = true;
                var vertex = triangles[edge];
                if (places.TryGetValue(vertex, out var place))
                {
                    if (Cut(walk, triangles, places, place) is { } ring) yield return (ring, pieces.Of[start / 3]);
                }
                places[vertex] = walk.Count;
                walk.Add(edge);
                edge = MeshTopology.Next(edge);
                // Around the vertex, through the triangles that meet in it, to the next open edge.
                while (partner[edge] >= 0) edge = MeshTopology.Next(partner[edge]);
            }
            while (edge != start);
            if (Cut(walk, triangles, places, 0) is { } last) yield return (last, pieces.Of[start / 3]);
        }
    }

    private static int[]? Cut(List<int> walk, int[] triangles, Dictionary<int, int> places, int from)
    {
        var ring = walk.GetRange(from, walk.Count - from).ToArray();
        walk.RemoveRange(from, walk.Count - from);
        foreach (var edge in ring) places.Remove(triangles[edge]);
        Array.Reverse(ring);
        return ring.Length >= 3 ? ring : null;
    }
}

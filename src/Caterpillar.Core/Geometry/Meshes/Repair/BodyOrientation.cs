namespace Caterpillar.Geometry;

/// <summary>
/// Turns closed bodies that face inward without being the cavity of another one, so that they neither vanish nor hollow out what they run through. A cavity
/// lies inside a body that faces outward with all of its points; one that leaves hardly anything of that body is its shell once more, turned inside out.
/// </summary>
internal static class BodyOrientation
{
    private const int Samples = 16;

    // A wall that is thinner than this on average cannot be printed.
    private const double ThinnestShell = 0.05;

    public static (TriMesh Mesh, int Turned) Unify(TriMesh mesh)
    {
        if (IsOneBody(mesh)) return (mesh, 0);
        var pieces = new MeshPieces(mesh);
        var turn = new bool[pieces.Count];
        var turned = 0;
        MeshHeights? rays = null;
        var boxes = new Lazy<Bounds[]>(() => pieces.Boxes(mesh));
        for (var piece = 0; piece < pieces.Count; piece++)
        {
            if (!pieces.IsClosed[piece] || !(pieces.Volume[piece] < 0)) continue;
            rays ??= new MeshHeights(mesh);
            if (IsCavity(mesh, pieces, piece, rays, boxes)) continue;
            turn[piece] = true;
            turned++;
        }
        if (turned == 0) return (mesh, 0);
        return (MeshOrientation.Flipped(mesh, Array.ConvertAll(pieces.Of, piece => turn[piece])), turned);
    }

    // By shared vertices, which is quicker than by edges; bodies that touch in a vertex count as one, as they are modeled together.
    private static bool IsOneBody(TriMesh mesh)
    {
        var bodies = new DisjointSets(mesh.VertexCount);
        var parts = mesh.VertexCount;
        var triangles = mesh.RawTriangles;
        for (var t = 0; t < triangles.Length; t += 3)
        {
            if (bodies.Join(triangles[t], triangles[t + 1])) parts--;
            if (bodies.Join(triangles[t], triangles[t + 2])) parts--;
        }
        return parts <= 1 && mesh.IsWatertight && mesh.Volume > 0;
    }

    private static bool IsCavity(TriMesh mesh, MeshPieces pieces, int piece, MeshHeights rays, Lazy<Bounds[]> boxes)
    {
        var points = Enumerable.Range(0, mesh.TriangleCount).Where(t => pieces.Of[t] == piece).Select(t => mesh.RawTriangles[3 * t]).ToList();
        var step = Math.Max(1, points.Count / Samples);
        for (var i = 0; i < points.Count; i += step)
        {
            if (rays.Winding(mesh.RawVertices[points[i]], t => pieces.IsClosed[pieces.Of[t]] && pieces.Volume[pieces.Of[t]] > 0) <= 0) return false;
        }
        for (var other = 0; other < pieces.Count; other++)
        {
            var left = pieces.Volume[other] + pieces.Volume[piece];
            if (pieces.IsClosed[other] && left > 0 && left < ThinnestShell * pieces.Area[piece] && pieces.Area[other] < 2 * pieces.Area[piece]
                && boxes.Value[other].Contains(mesh.RawVertices[points[0]]))
                return false;
        }
        return true;
    }
}

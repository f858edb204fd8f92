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
        VerticalRays? rays = null;
        for (var piece = 0; piece < pieces.Count; piece++)
        {
            if (!pieces.IsClosed[piece] || !(pieces.Volume[piece] < 0)) continue;
            rays ??= new VerticalRays(mesh, t => pieces.IsClosed[pieces.Of[t]] && pieces.Volume[pieces.Of[t]] > 0);
            if (IsCavity(mesh, pieces, piece, rays)) continue;
            turn[piece] = true;
            turned++;
        }
        if (turned == 0) return (mesh, 0);
        var triangles = (int[])mesh.RawTriangles.Clone();
        for (var t = 0; t < mesh.TriangleCount; t++)
        {
            if (turn[pieces.Of[t]]) (triangles[3 * t + 1], triangles[3 * t + 2]) = (triangles[3 * t + 2], triangles[3 * t + 1]);
        }
        return (TriMesh.Own(mesh.RawVertices, triangles), turned);
    }

    // By shared vertices, which is quicker than by edges; bodies that touch in a vertex count as one, as they are modeled together.
    private static bool IsOneBody(TriMesh mesh)
    {
        var parents = new int[mesh.VertexCount];
        for (var v = 0; v < parents.Length; v++) parents[v] = v;
        var parts = parents.Length;
        var triangles = mesh.RawTriangles;
        for (var t = 0; t < triangles.Length; t += 3)
        {
            var a = Root(parents, triangles[t]);
            for (var k = 1; k < 3; k++)
            {
                var b = Root(parents, triangles[t + k]);
                if (a == b) continue;
                if (b < a) (a, b) = (b, a);
                parents[b] = a;
                parts--;
            }
        }
        return parts <= 1 && mesh.IsWatertight && mesh.Volume > 0;
    }

    private static int Root(int[] parents, int at)
    {
        while (parents[at] != at) at = parents[at] = parents[parents[at]];
        return at;
    }

    private static bool IsCavity(TriMesh mesh, MeshPieces pieces, int piece, VerticalRays rays)
    {
        var points = new List<int>();
        for (var t = 0; t < mesh.TriangleCount; t++)
        {
            if (pieces.Of[t] == piece) points.Add(mesh.RawTriangles[3 * t]);
        }
        var step = Math.Max(1, points.Count / Samples);
        for (var i = 0; i < points.Count; i += step)
        {
            if (rays.Winding(mesh.RawVertices[points[i]]) <= 0) return false;
        }
        for (var other = 0; other < pieces.Count; other++)
        {
            var left = pieces.Volume[other] + pieces.Volume[piece];
            if (pieces.IsClosed[other] && left > 0 && left < ThinnestShell * pieces.Area[piece] && pieces.Area[other] < 2 * pieces.Area[piece]
                && BoundsOf(mesh, pieces, other).Contains(mesh.RawVertices[points[0]]))
            {
                return false;
            }
        }
        return true;
    }

    private static Bounds BoundsOf(TriMesh mesh, MeshPieces pieces, int piece)
    {
        var bounds = Bounds.Empty;
        for (var h = 0; h < mesh.RawTriangles.Length; h++)
        {
            if (pieces.Of[h / 3] == piece) bounds = bounds.Include(mesh.RawVertices[mesh.RawTriangles[h]]);
        }
        return bounds;
    }
}

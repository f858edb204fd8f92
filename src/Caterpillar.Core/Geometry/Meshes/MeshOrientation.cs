namespace Caterpillar.Geometry;

/// <summary>
/// Flips triangles that are inside out. Across edges whose two triangles run along them in the same direction one of the two is flipped, so that
/// each body is turned alike, as most of its triangles were. A closed mesh that is inside out as a whole is
/// flipped as a whole. Bodies without conflicts stay as they are, because cavities rightly face inward.
/// </summary>
internal static class MeshOrientation
{
    public static TriMesh Unify(TriMesh mesh, SourceLocation source, DiagnosticList diagnostics)
    {
        var turn = mesh.WindingConflictCount > 0 ? ConflictsToFlip(mesh) : [];
        var turned = turn.Count(t => t);
        var result = turned > 0 ? Flipped(mesh, turn) : mesh;
        if (turned > 0)
            diagnostics.Add(Severity.Warning, "mesh.flipped_faces", "A face was inside out relative to its neighbors and was flipped.", source, turned);
        if (!result.IsWatertight || result.Volume >= 0) return result;
        diagnostics.Add(Severity.Warning, "mesh.inside_out", "The mesh was inside out. All faces were flipped.", source);
        return Flipped(result, null);
    }

    /// <summary>The mesh with some of its triangles flipped, or all.</summary>
    public static TriMesh Flipped(TriMesh mesh, bool[]? which)
    {
        var triangles = (int[])mesh.RawTriangles.Clone();
        for (var t = 0; t < mesh.TriangleCount; t++)
        {
            if (which is null || which[t]) (triangles[3 * t + 1], triangles[3 * t + 2]) = (triangles[3 * t + 2], triangles[3 * t + 1]);
        }
        return TriMesh.Own(mesh.RawVertices, triangles);
    }

    private static bool[] ConflictsToFlip(TriMesh mesh)
    {
        var count = mesh.TriangleCount;
        var neighbors = Neighbors(mesh);
        var turn = new bool[count];
        var seen = new bool[count];
        var body = new List<int>();
        for (var first = 0; first < count; first++)
        {
            if (seen[first]) continue;
            body.Clear();
            body.Add(first);
            seen[first] = true;
            var conflicts = false;
            for (var i = 0; i < body.Count; i++)
            {
                for (var h = 3 * body[i]; h < 3 * body[i] + 3; h++)
                {
                    var other = neighbors[h];
                    if (other < 0) continue;
                    // Half-edges of neighbors should start at different vertices.
                    var same = mesh.RawTriangles[h] == mesh.RawTriangles[other];
                    conflicts |= same;
                    if (seen[other / 3]) continue;
                    seen[other / 3] = true;
                    turn[other / 3] = turn[body[i]] ^ same;
                    body.Add(other / 3);
                }
            }
            // As most of the triangles were: a cavity stays a cavity, and BodyOrientation looks at what is wrong as a whole.
            var isInsideOut = 2 * body.Count(t => turn[t]) > body.Count;
            foreach (var t in body) turn[t] = conflicts && turn[t] != isInsideOut;
        }
        return turn;
    }

    // For each half-edge the other one of an edge with exactly two triangles, else −1.
    private static int[] Neighbors(TriMesh mesh)
    {
        var (_, keys) = MeshTopology.SortedEdges(mesh.VertexCount, mesh.RawTriangles, out var sameAsBefore);
        var neighbors = new int[keys.Length];
        for (int i = 0, end; i < keys.Length; i = end)
        {
            end = i + 1;
            while (end < keys.Length && sameAsBefore[end]) end++;
            for (var k = i; k < end; k++) neighbors[(int)keys[k]] = end - i == 2 ? (int)keys[i + i + 1 - k] : -1;
        }
        return neighbors;
    }
}

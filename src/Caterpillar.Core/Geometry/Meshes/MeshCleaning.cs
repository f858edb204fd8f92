namespace Caterpillar.Geometry;

/// <summary>Removes what does not belong to the surface of a mesh.</summary>
internal static class MeshCleaning
{
    /// <summary>The vertices that the triangles use, in their order; the triangles are renumbered in place.</summary>
    public static Vec3[] DropUnused(Vec3[] vertices, int[] triangles)
    {
        var numbers = new int[vertices.Length];
        foreach (var v in triangles) numbers[v] = 1;
        var used = 0;
        for (var v = 0; v < numbers.Length; v++) numbers[v] = numbers[v] == 0 ? -1 : used++;
        if (used == vertices.Length) return vertices;
        var kept = new Vec3[used];
        for (var v = 0; v < numbers.Length; v++)
        {
            if (numbers[v] >= 0) kept[numbers[v]] = vertices[v];
        }
        for (var i = 0; i < triangles.Length; i++) triangles[i] = numbers[triangles[i]];
        return kept;
    }

    /// <summary>Triangles whose three vertices lie on a line. They stay, because they close the surface between their neighbors.</summary>
    public static int CountFlat(TriMesh mesh)
    {
        var flat = 0;
        var vertices = mesh.RawVertices;
        var triangles = mesh.RawTriangles;
        for (var t = 0; t < triangles.Length; t += 3)
        {
            var a = vertices[triangles[t]];
            var cross = Vec3.Cross(vertices[triangles[t + 1]] - a, vertices[triangles[t + 2]] - a);
            if (cross.X == 0 && cross.Y == 0 && cross.Z == 0) flat++;
        }
        return flat;
    }

    /// <summary>
    /// Drops triangles that repeat an earlier one with the same vertices in the same direction. Only edges with too many triangles can have them.
    /// </summary>
    public static TriMesh DropDuplicates(TriMesh mesh, SourceLocation source, DiagnosticList diagnostics)
    {
        if (mesh.Topology.NonManifoldEdges == 0 && mesh.Topology.WindingConflicts == 0) return mesh;
        var triangles = mesh.RawTriangles;
        var known = new HashSet<(int, int, int)>();
        var kept = new List<int>(triangles.Length);
        for (var t = 0; t < triangles.Length; t += 3)
        {
            int a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
            if (!known.Add(Turned(a, b, c))) continue;
            kept.AddRange([a, b, c]);
        }
        var dropped = (triangles.Length - kept.Count) / 3;
        if (dropped == 0) return mesh;
        diagnostics.Add(Severity.Note, "mesh.duplicate_faces", "A duplicate face was removed.", source, dropped);
        return TriMesh.Own(mesh.RawVertices, kept.ToArray());
    }

    /// <summary>The same triangle from its smallest corner.</summary>
    public static (int, int, int) Turned(int a, int b, int c) => a < b && a < c ? (a, b, c) : b < c ? (b, c, a) : (c, a, b);

    /// <summary>Reports what keeps the mesh from being a closed surface. Notes only: an open surface may be intended.</summary>
    public static void ReportTopology(TriMesh mesh, SourceLocation source, DiagnosticList diagnostics)
    {
        var topology = mesh.Topology;
        if (topology.OpenEdges > 0)
            diagnostics.Add(Severity.Note, "mesh.naked_edges", "The mesh is open: an edge has only one face (naked edge).", source, topology.OpenEdges);
        if (topology.NonManifoldEdges > 0)
            diagnostics.Add(Severity.Note, "mesh.non_manifold_edges", "An edge has more than two faces.", source, topology.NonManifoldEdges);
        if (topology.WindingConflicts > 0)
        {
            const string Message = "The normals of two neighboring faces disagree: one face is inside out.";
            diagnostics.Add(Severity.Note, "mesh.winding_conflicts", Message, source, topology.WindingConflicts);
        }
    }
}

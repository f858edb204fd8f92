namespace Caterpillar.Geometry;

/// <summary>
/// Closes cracks caused by files with few digits: vertices on open edges that are closer together than the snap distance become one. Only kept if it
/// leaves fewer open edges.
/// </summary>
internal static class CrackSnap
{
    /// <summary>Snap distance relative to the largest coordinate: two units of the sixth digit, the usual precision of text files.</summary>
    public const double RelativeSnap = 2e-6;

    public static TriMesh Close(TriMesh mesh, SourceLocation source, DiagnosticList diagnostics)
    {
        var bounds = mesh.Bounds;
        var largest = Math.Max(Largest(bounds.Min), Largest(bounds.Max));
        var snap = RelativeSnap * largest;
        if (!(snap > 0)) return mesh;
        var rim = OnOpenEdges(mesh);
        var reach = new double[mesh.VertexCount];
        foreach (var v in rim) reach[v] = snap;
        var (targets, moved, _) = VertexSnap.Targets(mesh, reach, rim);
        if (moved == 0) return mesh;
        var builder = MeshBuilder.Merging(mesh, targets);
        var closed = builder.ToMesh();
        if (closed.NakedEdgeCount >= mesh.NakedEdgeCount) return mesh;
        diagnostics.Add(Severity.Warning, "mesh.snapped",
            $"A vertex on a naked edge was moved by up to {NumberFormatter.Format(snap, 9)} mm to close a crack.", source, moved);
        if (builder.Degenerate > 0)
            diagnostics.Add(Severity.Note, "mesh.degenerate_faces", "A face with two equal vertices is ignored.", source, builder.Degenerate);
        return closed;
    }

    private static int[] OnOpenEdges(TriMesh mesh)
    {
        var partner = mesh.Topology.Partner;
        var open = new SortedSet<int>();
        for (var h = 0; h < partner.Length; h++)
        {
            if (partner[h] < 0) open.UnionWith([mesh.RawTriangles[h], mesh.RawTriangles[MeshTopology.Next(h)]]);
        }
        return [.. open];
    }

    private static double Largest(Vec3 p) => Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z)));
}

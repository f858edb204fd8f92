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
        var (target, moved) = Targets(mesh, snap);
        if (moved == 0) return mesh;
        var builder = MeshBuilder.Merging(mesh, target);
        var closed = builder.ToMesh();
        if (closed.NakedEdgeCount >= mesh.NakedEdgeCount) return mesh;
        diagnostics.Add(Severity.Warning, "mesh.snapped",
            $"A vertex on a naked edge was moved by up to {NumberFormatter.Format(snap, 9)} mm to close a crack.", source, moved);
        if (builder.Degenerate > 0)
        {
            diagnostics.Add(Severity.Note, "mesh.degenerate_faces", "A face with two equal vertices is ignored.", source, builder.Degenerate);
        }
        return closed;
    }

    // For each vertex the first one on an open edge within the snap, or itself.
    private static (int[] Target, int Moved) Targets(TriMesh mesh, double snap)
    {
        var vertices = mesh.RawVertices;
        var target = new int[vertices.Length];
        for (var v = 0; v < target.Length; v++) target[v] = v;
        var open = new bool[vertices.Length];
        var partner = mesh.Topology.Partner;
        for (var h = 0; h < partner.Length; h++)
        {
            if (partner[h] < 0) open[mesh.RawTriangles[h]] = open[mesh.RawTriangles[MeshTopology.Next(h)]] = true;
        }
        var cells = new Dictionary<(long, long, long), List<int>>();
        var moved = 0;
        for (var v = 0; v < target.Length; v++)
        {
            if (!open[v]) continue;
            var p = vertices[v];
            var (x, y, z) = (Cell(p.X, snap), Cell(p.Y, snap), Cell(p.Z, snap));
            var nearest = Nearest(cells, vertices, p, (x, y, z), snap);
            if (nearest >= 0)
            {
                target[v] = nearest;
                moved++;
                continue;
            }
            if (!cells.TryGetValue((x, y, z), out var list)) cells.Add((x, y, z), list = []);
            list.Add(v);
        }
        return (target, moved);
    }

    private static int Nearest(Dictionary<(long, long, long), List<int>> cells, Vec3[] vertices, Vec3 p, (long X, long Y, long Z) at, double snap)
    {
        var best = -1;
        var distance = snap;
        for (var i = 0; i < 27; i++)
        {
            if (!cells.TryGetValue((at.X + i % 3 - 1, at.Y + i / 3 % 3 - 1, at.Z + i / 9 - 1), out var list)) continue;
            foreach (var v in list)
            {
                var d = vertices[v].DistanceTo(p);
                if (d > distance || (d == distance && best >= 0 && v > best)) continue;
                (best, distance) = (v, d);
            }
        }
        return best;
    }

    private static long Cell(double value, double size) => (long)Math.Floor(value / size);

    private static double Largest(Vec3 p) => Math.Max(Math.Abs(p.X), Math.Max(Math.Abs(p.Y), Math.Abs(p.Z)));
}

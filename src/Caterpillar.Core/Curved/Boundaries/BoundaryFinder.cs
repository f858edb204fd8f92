namespace Caterpillar.Curved;

/// <summary>Finds the boundaries of parts.</summary>
internal static class BoundaryFinder
{
    // Cosine of 20 degrees: sharper edges end a face.
    private const double Sharp = 0.94;

    // Steeper than 60 degrees faces are walls.
    private const double LooksUp = 0.5;

    /// <summary>Open edges of a mesh: those that reach lowest, and all others.</summary>
    public static (int[] Lower, int[] Upper) OpenEdges(TriMesh mesh)
    {
        var loops = OpenLoops(mesh);
        if (loops.Count < 2) return ([], []);
        var low = loops.Min(Lowest);
        var most = low + 0.05 * mesh.Bounds.Size.Z;
        return (loops.Where(l => Lowest(l) <= most).SelectMany(l => l).Distinct().ToArray(),
            loops.Where(l => Lowest(l) > most).SelectMany(l => l).Distinct().ToArray());

        double Lowest(int[] loop) => loop.Min(v => mesh.RawVertices[v].Z);
    }

    /// <summary>The loops of open edges of a mesh, by their lowest vertex.</summary>
    public static List<int[]> OpenLoops(TriMesh mesh)
    {
        var next = new Dictionary<int, int>();
        var corners = mesh.RawTriangles;
        for (var h = 0; h < corners.Length; h++)
        {
            if (mesh.Topology.Partner[h] < 0) next[corners[h]] = corners[h - h % 3 + (h + 1) % 3];
        }
        var loops = new List<int[]>();
        foreach (var start in next.Keys.OrderBy(v => v).ToArray())
        {
            var loop = new List<int>();
            for (var v = start; next.TryGetValue(v, out var to); v = to)
            {
                next.Remove(v);
                loop.Add(v);
            }
            if (loop.Count > 0) loops.Add(loop.ToArray());
        }
        return loops;
    }

    /// <summary>Of a closed mesh its lowest vertices, and smooth faces that look up and fall away at all of their sharp edges.</summary>
    public static (int[] Lower, int[] Upper) SmoothFaces(TriMesh mesh)
    {
        var upper = new List<int>();
        var count = mesh.TriangleCount;
        var patch = new int[count];
        for (var t = 0; t < count; t++) patch[t] = -1;
        for (var t = 0; t < count; t++)
        {
            if (patch[t] >= 0) continue;
            patch[t] = t;
            if (mesh.Normal(t).Z < LooksUp) continue;
            var (faces, ends) = Patch(mesh, t, patch);
            if (ends) upper.AddRange(faces.SelectMany(f => new[] { mesh.RawTriangles[3 * f], mesh.RawTriangles[3 * f + 1], mesh.RawTriangles[3 * f + 2] }));
        }
        return (Lowest(mesh), upper.Distinct().OrderBy(v => v).ToArray());
    }

    /// <summary>Vertices at the lowest height of a mesh.</summary>
    public static int[] Lowest(TriMesh mesh)
    {
        var low = mesh.Bounds.Min.Z + 1e-4;
        return Enumerable.Range(0, mesh.VertexCount).Where(v => mesh.RawVertices[v].Z <= low).ToArray();
    }

    /// <summary>Vertices no farther from a shape than a distance.</summary>
    public static int[] Within(TriMesh mesh, Func<Vec3, double> distanceTo, double near)
        => Enumerable.Range(0, mesh.VertexCount).Where(v => distanceTo(mesh.RawVertices[v]) <= near).ToArray();

    /// <summary>
    /// Vertices along a shape: no farther than a distance, and of those over each other only the nearest. Where the shape runs through vertices, none beside
    /// it count, which would make the boundary a band.
    /// </summary>
    public static int[] Along(TriMesh mesh, Func<Vec3, double> distanceTo, double near)
    {
        var distance = new Dictionary<int, double>();
        for (var v = 0; v < mesh.VertexCount; v++)
        {
            if (distanceTo(mesh.RawVertices[v]) is var d && d <= near) distance.Add(v, d);
        }
        var nearer = new Dictionary<int, int>();
        var corners = mesh.RawTriangles;
        for (var h = 0; h < corners.Length; h++)
        {
            var (a, b) = (corners[h], corners[h - h % 3 + (h + 1) % 3]);
            if (!distance.TryGetValue(a, out var ofA) || !distance.TryGetValue(b, out var ofB)) continue;
            Descend(a, ofA, b, ofB);
            Descend(b, ofB, a, ofA);
        }
        // Downhill along edges each vertex comes to the one that stands for it.
        var least = new Dictionary<int, double>();
        foreach (var v in distance.Keys.OrderBy(v => distance[v]).ThenBy(v => v)) least.Add(v, nearer.TryGetValue(v, out var to) ? least[to] : distance[v]);
        return distance.Keys.Where(v => distance[v] <= 2 * least[v] + 0.05 * near).OrderBy(v => v).ToArray();

        void Descend(int from, double ofFrom, int to, double ofTo)
        {
            if (ofTo < ofFrom && (!nearer.TryGetValue(from, out var known) || ofTo < distance[known])) nearer[from] = to;
        }
    }

    /// <summary>Vertices of a mesh, and those which its refinement has set between two of them.</summary>
    public static int[] Between(TriMesh fine, int coarse, IReadOnlyList<(int A, int B)> parents, IReadOnlyList<int> vertices)
    {
        var marked = new bool[fine.VertexCount];
        foreach (var v in vertices) marked[v] = true;
        for (var i = 0; i < parents.Count; i++) marked[coarse + i] = marked[parents[i].A] && marked[parents[i].B];
        return Enumerable.Range(0, marked.Length).Where(v => marked[v]).ToArray();
    }

    /// <summary>A vertex that is not connected to any of a set; null if there is none.</summary>
    public static int? Unreached(TriMesh mesh, int[] set)
    {
        var pieces = new DisjointSets(mesh.VertexCount);
        var corners = mesh.RawTriangles;
        for (var t = 0; t < corners.Length; t += 3)
        {
            pieces.Join(corners[t], corners[t + 1]);
            pieces.Join(corners[t + 1], corners[t + 2]);
        }
        var reached = new HashSet<int>(set.Select(pieces.Of));
        var at = Array.FindIndex(corners, v => !reached.Contains(pieces.Of(v)));
        return at < 0 ? null : corners[at];
    }

    // The faces that go on smoothly from a face, and whether the mesh falls away at all of their edges.
    private static (List<int> Faces, bool Ends) Patch(TriMesh mesh, int first, int[] patch)
    {
        var faces = new List<int> { first };
        var ends = true;
        for (var i = 0; i < faces.Count; i++)
        {
            var normal = mesh.Normal(faces[i]);
            for (var k = 0; k < 3; k++)
            {
                var partner = mesh.Topology.Partner[3 * faces[i] + k];
                if (partner < 0) return (faces, false);
                var other = partner / 3;
                if (patch[other] == first) continue;
                var next = mesh.Normal(other);
                var opposite = mesh.RawVertices[mesh.RawTriangles[3 * other + (partner % 3 + 2) % 3]];
                var rises = Vec3.Dot(opposite - mesh.RawVertices[mesh.RawTriangles[3 * faces[i] + k]], normal) > 0;
                if (Vec3.Dot(next, normal) < Sharp)
                {
                    ends &= !rises;
                }
                else if (patch[other] >= 0 || next.Z < LooksUp)
                {
                    ends = false;
                }
                else
                {
                    patch[other] = first;
                    faces.Add(other);
                }
            }
        }
        return (faces, ends);
    }
}

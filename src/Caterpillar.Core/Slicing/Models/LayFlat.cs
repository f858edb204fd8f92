namespace Caterpillar.Slicing;

/// <summary>Turns a model so that the largest flat face of its convex hull is below. Of equal faces the one that needs the least turning.</summary>
internal static class LayFlat
{
    // cos 0.5°, and mm as a part of the size: facets of a curved surface do not count as one face.
    private const double SameDirection = 0.99996;
    private const double SamePlane = 1e-3;

    public static Affine Turn(TriMesh mesh)
    {
        var corners = ConvexHull.Of(mesh.Vertices);
        if (corners.Count == 0) return Affine.Identity;
        return Downwards(LargestFace(mesh.Vertices, corners, SamePlane * mesh.Bounds.Size.Length));
    }

    private static Vec3 LargestFace(IReadOnlyList<Vec3> points, IReadOnlyList<(int A, int B, int C)> triangles, double thickness)
    {
        var normals = new Vec3[triangles.Count];
        var areas = new double[triangles.Count];
        var neighbors = new Dictionary<(int, int), int>();
        for (var t = 0; t < triangles.Count; t++)
        {
            var (a, b, c) = triangles[t];
            var cross = Vec3.Cross(points[b] - points[a], points[c] - points[a]);
            areas[t] = cross.Length / 2;
            normals[t] = cross.Unit();
            neighbors[(a, b)] = neighbors[(b, c)] = neighbors[(c, a)] = t;
        }
        var taken = new bool[triangles.Count];
        var best = -Vec3.UnitZ;
        var bestArea = 0.0;
        var stack = new Stack<int>();
        foreach (var seed in Enumerable.Range(0, triangles.Count).OrderByDescending(t => areas[t]).ThenBy(t => t))
        {
            if (taken[seed]) continue;
            var sum = Vec3.Zero;
            taken[seed] = true;
            stack.Push(seed);
            while (stack.Count > 0)
            {
                var t = stack.Pop();
                sum += normals[t] * areas[t];
                var (a, b, c) = triangles[t];
                foreach (var edge in new[] { (b, a), (c, b), (a, c) })
                {
                    if (!neighbors.TryGetValue(edge, out var other) || taken[other] || Vec3.Dot(normals[other], normals[seed]) < SameDirection) continue;
                    var apex = triangles[other];
                    var far = new[] { apex.A, apex.B, apex.C }.Max(v => Math.Abs(Vec3.Dot(points[v] - points[triangles[seed].A], normals[seed])));
                    if (far > thickness) continue;
                    taken[other] = true;
                    stack.Push(other);
                }
            }
            var area = sum.Length;
            var equal = Math.Abs(area - bestArea) <= 1e-6 * bestArea;
            if (equal ? sum.Unit().Z < best.Z - 1e-9 : area > bestArea) (best, bestArea) = (sum.Unit(), area);
        }
        return best;
    }

    // The shortest turn that brings a direction to −Z.
    private static Affine Downwards(Vec3 n) => Affine.Rotate(n.LengthXY > 0 ? new Vec3(-n.Y, n.X) : Vec3.UnitX, Angle.Atan2(n.LengthXY, -n.Z));
}

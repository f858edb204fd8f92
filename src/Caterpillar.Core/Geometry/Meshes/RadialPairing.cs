namespace Caterpillar.Geometry;

/// <summary>
/// Pairs the triangles around an edge that has more than two: in their order around the edge, each one that runs along the edge
/// forward with the nearest backward one after it, with the solid between them. So bodies that touch along an edge stay separate.
/// </summary>
internal static class RadialPairing
{
    /// <summary>
    /// Sets the partners of the half-edges in <paramref name="keys"/> (low word) from <paramref name="from"/> to <paramref name="to"/>; true if all have one.
    /// </summary>
    public static bool Pair(Vec3[] vertices, int[] triangles, long[] keys, int from, int to, int[] partner)
    {
        var count = to - from;
        var edges = new int[count];
        var angles = new double[count];
        var first = (int)keys[from];
        int low = triangles[first], high = triangles[MeshTopology.Next(first)];
        if (low > high) (low, high) = (high, low);
        var axis = (vertices[high] - vertices[low]).Unit();
        var side = Across(axis);
        var up = Vec3.Cross(axis, side);
        for (var i = 0; i < count; i++)
        {
            var edge = (int)keys[from + i];
            edges[i] = edge;
            var apex = vertices[triangles[MeshTopology.Next(MeshTopology.Next(edge))]] - vertices[low];
            angles[i] = PseudoAngle(Vec3.Dot(apex, side), Vec3.Dot(apex, up));
            partner[edge] = -1;
        }
        // Ties keep the order of the half-edges.
        edges = edges.Select((edge, i) => (Edge: edge, Angle: angles[i])).OrderBy(e => e.Angle).Select(e => e.Edge).ToArray();
        // A forward triangle has its outside ahead in angle, so the solid lies after it: match each forward one with the
        // nearest unmatched backward one before it, as brackets; twice around, because the circle has no beginning.
        var open = new int[count];
        var depth = 0;
        for (var turn = 0; turn < 2; turn++)
        {
            for (var i = 0; i < count; i++)
            {
                var edge = edges[i];
                if (partner[edge] >= 0) continue;
                if (triangles[edge] == high)
                {
                    if (turn == 0) open[depth++] = edge;
                }
                else if (depth > 0)
                {
                    var other = open[--depth];
                    partner[edge] = other;
                    partner[other] = edge;
                }
            }
        }
        return Array.TrueForAll(edges, e => partner[e] >= 0);
    }

    private static Vec3 Across(Vec3 axis)
    {
        var helper = Math.Abs(axis.X) <= Math.Abs(axis.Y) && Math.Abs(axis.X) <= Math.Abs(axis.Z) ? Vec3.UnitX
            : Math.Abs(axis.Y) <= Math.Abs(axis.Z) ? Vec3.UnitY : Vec3.UnitZ;
        return Vec3.Cross(axis, helper).Unit();
    }

    // Grows with the angle of (x, y), from 0 to 4.
    private static double PseudoAngle(double x, double y)
    {
        var size = Math.Abs(x) + Math.Abs(y);
        if (size == 0) return 0;
        var t = y / size;
        return x < 0 ? 2 - t : t < 0 ? 4 + t : t;
    }
}

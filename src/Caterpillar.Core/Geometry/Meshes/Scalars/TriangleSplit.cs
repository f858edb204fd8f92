namespace Caterpillar.Geometry;

/// <summary>Divides a triangle along the middles of some of its edges.</summary>
internal static class TriangleSplit
{
    /// <summary>Adds the pieces, with the winding of the whole.</summary>
    /// <param name="points">Points by number: of two diagonals the shorter one is taken.</param>
    /// <param name="corners">The corners.</param>
    /// <param name="middles">Numbers of the middles of the edges that begin at each corner; −1 for edges that stay whole.</param>
    /// <param name="pieces">Where the pieces go.</param>
    public static void Add(
        IReadOnlyList<Vec3> points, (int A, int B, int C) corners, (int AB, int BC, int CA) middles, List<(int A, int B, int C)> pieces)
    {
        var (a, b, c) = corners;
        var (ab, bc, ca) = middles;
        switch ((ab >= 0 ? 1 : 0) + (bc >= 0 ? 1 : 0) + (ca >= 0 ? 1 : 0))
        {
            case 0:
                pieces.Add(corners);
                return;
            case 3:
                pieces.Add((a, ab, ca));
                pieces.Add((ab, b, bc));
                pieces.Add((ca, bc, c));
                pieces.Add((ab, bc, ca));
                return;
            case 1:
                // Turned until the edge from a to b is the divided one.
                if (bc >= 0) (a, b, c, ab) = (b, c, a, bc);
                else if (ca >= 0) (a, b, c, ab) = (c, a, b, ca);
                pieces.Add((a, ab, c));
                pieces.Add((ab, b, c));
                return;
            default:
                // Turned until the edge from c to a is whole.
                if (ab < 0) (a, b, c, ab, bc) = (b, c, a, bc, ca);
                else if (bc < 0) (a, b, c, ab, bc) = (c, a, b, ca, ab);
                pieces.Add((ab, b, bc));
                if (points[ab].DistanceTo(points[c]) < points[a].DistanceTo(points[bc]))
                {
                    pieces.Add((a, ab, c));
                    pieces.Add((ab, bc, c));
                }
                else
                {
                    pieces.Add((a, ab, bc));
                    pieces.Add((a, bc, c));
                }
                return;
        }
    }
}

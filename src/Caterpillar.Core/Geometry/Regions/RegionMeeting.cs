namespace Caterpillar.Geometry;

/// <summary>Whether the boundaries of two regions cross or touch: their box trees are gone through together.</summary>
internal static class RegionMeeting
{
    public static bool Meet(RegionIndex a, RegionIndex b)
        => a.Tree.Levels > 0 && b.Tree.Levels > 0 && Nodes(a, a.Tree.Levels - 1, 0, b, b.Tree.Levels - 1, 0);

    private static bool Nodes(RegionIndex a, int levelA, int nodeA, RegionIndex b, int levelB, int nodeB)
    {
        if (!GridBox.Overlap(a.Tree.Boxes[a.Tree.LevelStart[levelA] + nodeA], b.Tree.Boxes[b.Tree.LevelStart[levelB] + nodeB])) return false;
        if (levelA == 0 && levelB == 0) return Leaves(a, nodeA, b, nodeB);
        if (levelB == 0 || (levelA > 0 && levelA >= levelB))
        {
            if (Nodes(a, levelA - 1, 2 * nodeA, b, levelB, nodeB)) return true;
            return 2 * nodeA + 1 < a.Tree.LevelCount[levelA - 1] && Nodes(a, levelA - 1, 2 * nodeA + 1, b, levelB, nodeB);
        }
        if (Nodes(a, levelA, nodeA, b, levelB - 1, 2 * nodeB)) return true;
        return 2 * nodeB + 1 < b.Tree.LevelCount[levelB - 1] && Nodes(a, levelA, nodeA, b, levelB - 1, 2 * nodeB + 1);
    }

    private static bool Leaves(RegionIndex a, int leafA, RegionIndex b, int leafB)
    {
        for (var i = a.Tree.LeafStart[leafA]; i < a.Tree.LeafStart[leafA + 1]; i++)
        {
            for (var k = b.Tree.LeafStart[leafB]; k < b.Tree.LeafStart[leafB + 1]; k++)
            {
                if (Segments(a.Segments[i], b.Segments[k])) return true;
            }
        }
        return false;
    }

    private static bool Segments(in Segment s, in Segment t)
    {
        if (!GridBox.Overlap(GridBox.Of(s), GridBox.Of(t))) return false;
        long a = s.Side(t.Ax, t.Ay), b = s.Side(t.Bx, t.By);
        if ((a > 0 && b > 0) || (a < 0 && b < 0)) return false;
        long c = t.Side(s.Ax, s.Ay), d = t.Side(s.Bx, s.By);
        return !((c > 0 && d > 0) || (c < 0 && d < 0));
    }
}

namespace Caterpillar.Geometry;

/// <summary>
/// A binary tree of boxes over the segments of contours in their order along the contour, so it is built in linear time without sorting: consecutive
/// segments are neighbors in space. A leaf holds a run of segments of one contour. Level 0 are the leaves; node i of a level has the children 2i and 2i + 1.
/// </summary>
internal sealed class BoxTree
{
    private const int LeafSize = 6;

    public GridBox[] Boxes = [];
    public bool[] Fresh = [];

    /// <summary>
    /// Not 0 for nodes whose segments follow each other in one contour and all go to the right (1), left (2), up (4) or down (8): they can't cross each other.
    /// </summary>
    public byte[] Monotone = [];

    public int[] LeafStart = [];
    public int[] LeafContour = [];
    public int[] LevelStart = [];
    public int[] LevelCount = [];
    public int Levels;

    /// <summary>Contour c has the segments from contourStart[c] up to contourStart[c + 1]. Fresh marks nodes that hold a segment marked so.</summary>
    public void Build(Segment[] segments, bool[]? fresh, int[] contourStart, int contours)
    {
        var leaves = 0;
        for (var c = 0; c < contours; c++) leaves += Parts(contourStart[c + 1] - contourStart[c]);
        Levels = 0;
        if (leaves == 0) return;
        Reserve(leaves);
        for (int c = 0, leaf = 0; c < contours; c++)
        {
            var first = contourStart[c];
            var count = contourStart[c + 1] - first;
            var parts = Parts(count);
            for (var p = 0; p < parts; p++)
            {
                LeafContour[leaf] = c;
                LeafStart[leaf++] = first + (int)((long)count * p / parts);
            }
        }
        LeafStart[leaves] = contourStart[contours];
        for (var leaf = 0; leaf < leaves; leaf++)
        {
            var (i, end) = (LeafStart[leaf], LeafStart[leaf + 1]);
            int minX = segments[i].Ax, maxX = minX, minY = segments[i].Ay, maxY = minY;
            var any = false;
            var directions = 15;
            for (; i < end; i++)
            {
                // It begins where the one before ends.
                ref readonly var s = ref segments[i];
                minX = Math.Min(minX, s.Bx);
                maxX = Math.Max(maxX, s.Bx);
                minY = Math.Min(minY, s.By);
                maxY = Math.Max(maxY, s.By);
                directions &= (s.Bx > s.Ax ? 1 : s.Bx < s.Ax ? 2 : 0) | (s.By > s.Ay ? 4 : s.By < s.Ay ? 8 : 0);
                if (fresh is not null) any |= fresh[i];
            }
            Boxes[leaf] = new GridBox { MinX = minX, MinY = minY, MaxX = maxX, MaxY = maxY };
            Fresh[leaf] = any;
            Monotone[leaf] = (byte)directions;
        }
        LevelStart[0] = 0;
        LevelCount[0] = leaves;
        Levels = 1;
        while (LevelCount[Levels - 1] > 1) AddLevel();
    }

    /// <summary>Sums the operands' winding numbers at the point just left of and above (x, y), by a ray to the left.</summary>
    public void Winding(Segment[] segments, byte[] operands, int x, int y, out int first, out int second)
    {
        first = 0;
        second = 0;
        if (Levels > 0) Descend(segments, operands, x, y, Levels - 1, 0, ref first, ref second);
    }

    private void Descend(Segment[] segments, byte[] operands, int x, int y, int level, int node, ref int first, ref int second)
    {
        ref readonly var box = ref Boxes[LevelStart[level] + node];
        if (y < box.MinY || y >= box.MaxY || box.MinX >= x) return;
        if (level > 0)
        {
            Descend(segments, operands, x, y, level - 1, 2 * node, ref first, ref second);
            if (2 * node + 1 < LevelCount[level - 1]) Descend(segments, operands, x, y, level - 1, 2 * node + 1, ref first, ref second);
            return;
        }
        var sum = 0;
        for (var i = LeafStart[node]; i < LeafStart[node + 1]; i++)
        {
            ref readonly var s = ref segments[i];
            if (s.Ay <= y)
            {
                // Upward: the ray comes from the left side of the segment.
                if (s.By > y && s.Side(x, y) < 0) sum--;
            }
            else if (s.By <= y && s.Side(x, y) > 0)
            {
                sum++;
            }
        }
        if (operands[LeafContour[node]] == 0) first += sum;
        else second += sum;
    }

    private void AddLevel()
    {
        var below = LevelStart[Levels - 1];
        var count = LevelCount[Levels - 1];
        var start = below + count;
        for (var i = 0; i < count; i += 2)
        {
            var box = Boxes[below + i];
            var any = Fresh[below + i];
            var directions = Monotone[below + i];
            if (i + 1 < count)
            {
                var middle = (i + 1) << (Levels - 1);
                directions = LeafContour[middle - 1] == LeafContour[middle] ? (byte)(directions & Monotone[below + i + 1]) : (byte)0;
                box.Include(Boxes[below + i + 1]);
                any |= Fresh[below + i + 1];
            }
            Boxes[start + i / 2] = box;
            Fresh[start + i / 2] = any;
            Monotone[start + i / 2] = directions;
        }
        LevelStart[Levels] = start;
        LevelCount[Levels] = (count + 1) / 2;
        Levels++;
    }

    private static int Parts(int segments) => (segments + LeafSize - 1) / LeafSize;

    // No more than is needed the first time: most regions that are asked something are small.
    private void Reserve(int leaves)
    {
        int nodes = leaves, levels = 1;
        for (var n = leaves; n > 1; levels++) nodes += n = (n + 1) / 2;
        Buffers.Reserve(ref LeafStart, leaves + 1);
        Buffers.Reserve(ref LeafContour, leaves);
        Buffers.Reserve(ref Boxes, nodes);
        Buffers.Reserve(ref Fresh, nodes);
        Buffers.Reserve(ref Monotone, nodes);
        Buffers.Reserve(ref LevelStart, levels);
        Buffers.Reserve(ref LevelCount, levels);
    }
}

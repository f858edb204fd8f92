namespace Caterpillar.Slicing;

/// <summary>The loops of one contour among the steps of a layer, printed one after the other.</summary>
/// <param name="First">Number of the first step.</param>
/// <param name="Count">Number of loops.</param>
/// <param name="Outer">Number of the step of the outer wall.</param>
/// <param name="Supports">Parts over air of each loop, or null if it has none.</param>
internal readonly record struct WallChain(int First, int Count, int Outer, LoopSupport?[]? Supports = null)
{
    /// <summary>The support of the loop of a step.</summary>
    public LoopSupport? SupportOf(int step) => Supports?[step - First];
}

/// <summary>Finds which loops belong to one contour: each inner loop to the nearest loop around it.</summary>
internal static class WallChains
{
    /// <summary>For each contour its loops, from the outer wall inwards.</summary>
    public static List<List<int>> Find(IReadOnlyList<WallPath> walls)
    {
        var chains = new List<List<int>>();
        var chainOf = new int[walls.Count];
        var boxes = new Bounds[walls.Count];
        var deepest = 0;
        for (var i = 0; i < walls.Count; i++)
        {
            chainOf[i] = -1;
            if (!IsLoop(walls[i])) continue;
            boxes[i] = Bounds.Of(walls[i].Points);
            deepest = Math.Max(deepest, walls[i].Index);
        }
        for (var index = 0; index <= deepest; index++)
        {
            for (var i = 0; i < walls.Count; i++)
            {
                if (!IsLoop(walls[i]) || walls[i].Index != index) continue;
                var parent = index == 0 ? -1 : Parent(walls, boxes, i);
                if (parent < 0)
                {
                    chainOf[i] = chains.Count;
                    chains.Add([i]);
                }
                else
                {
                    chainOf[i] = chainOf[parent];
                    chains[chainOf[i]].Add(i);
                }
            }
        }
        return chains;
    }

    /// <summary>A loop of a wall, or a single extrusion that is its own outline.</summary>
    public static bool IsLoop(WallPath wall) => wall.Closed && (!wall.IsExtrusion || wall.Index == 0);

    /// <summary>Whether the outer wall of a contour is printed first.</summary>
    public static bool OuterFirst(PrintSettings settings, int layer, bool overhangs)
    {
        if (overhangs && settings.OverhangWallOrder != OverhangWallOrder.Same) return settings.OverhangWallOrder == OverhangWallOrder.OutsideIn;
        return settings.WallOrder switch { WallOrder.InsideOut => false, WallOrder.OutsideIn => true, _ => layer % 2 == 1 };
    }

    private static int Parent(IReadOnlyList<WallPath> walls, Bounds[] boxes, int child)
    {
        var place = walls[child].Points[0];
        var best = -1;
        var least = double.PositiveInfinity;
        for (var i = 0; i < walls.Count; i++)
        {
            if (walls[i].Index != walls[child].Index - 1 || !IsLoop(walls[i]) || SquareTo(boxes[i], place) >= least) continue;
            var square = (LoopPlace.Nearest(walls[i].Points, place).Point - place).LengthSquared;
            if (square >= least) continue;
            least = square;
            best = i;
        }
        return best;
    }

    internal static double SquareTo(Bounds box, Vec3 p)
    {
        var x = Math.Max(Math.Max(box.Min.X - p.X, p.X - box.Max.X), 0);
        var y = Math.Max(Math.Max(box.Min.Y - p.Y, p.Y - box.Max.Y), 0);
        return x * x + y * y;
    }
}

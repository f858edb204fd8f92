namespace Caterpillar.Toolpaths;

/// <summary>Finds the moves that are mapped together with the selected moves.</summary>
internal static class MappedMoves
{
    public static bool[] All(Toolpath toolpath)
    {
        var all = Enumerable.Repeat(true, toolpath.Count).ToArray();
        var inPlace = new bool[toolpath.Count];
        for (var block = 0; block < toolpath.Blocks.Count; block++) InPlace(toolpath, block, inPlace);
        Unmap(toolpath, all, inPlace);
        return all;
    }

    /// <summary>
    /// The selected extrusions, the selected moves between them, and the moves in place at their ends. Travel moves to the first extrusion or away from
    /// the last one have one end elsewhere: a travel move from or to the home position does not change.
    /// </summary>
    public static bool[] Of(Toolpath toolpath, MoveFilter filter)
    {
        var chosen = MoveChoice.Of(filter, toolpath);
        var inPlace = new bool[toolpath.Count];
        var extrusions = new bool[toolpath.Count];
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var columns = toolpath.Blocks[block].Columns;
            var first = toolpath.FirstOf(block);
            InPlace(toolpath, block, inPlace);
            for (var i = 0; i < columns.Count; i++)
                extrusions[first + i] = columns.Kind[i] is MoveKind.Print or MoveKind.Wipe or MoveKind.MovingDeretract;
        }
        var mapped = new bool[toolpath.Count];
        var last = -1;
        for (var i = 0; i < mapped.Length; i++)
        {
            if (!chosen[i]) last = -1;
            if (!chosen[i] || !extrusions[i]) continue;
            for (var k = last < 0 ? i : last + 1; k <= i; k++) mapped[k] = true;
            last = i;
        }
        for (var i = 1; i < mapped.Length; i++) mapped[i] |= inPlace[i] && mapped[i - 1];
        for (var i = mapped.Length - 2; i >= 0; i--) mapped[i] |= inPlace[i] && mapped[i + 1];
        Unmap(toolpath, mapped, inPlace);
        return mapped;
    }

    // Homing moves, which go to the switches, and moves in place without a travel to the extrusion that follows.
    private static void Unmap(Toolpath toolpath, bool[] mapped, bool[] inPlace)
    {
        var stays = false;
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var columns = toolpath.Blocks[block].Columns;
            var first = toolpath.FirstOf(block);
            for (var i = 0; i < columns.Count; i++)
            {
                var move = first + i;
                var homes = columns.Kind[i] == MoveKind.Travel && toolpath.HomeOf(toolpath[move]) is not null;
                if (homes || (stays && inPlace[move])) mapped[move] = false;
                stays = !mapped[move] && (columns.Kind[i] == MoveKind.Print || homes || inPlace[move]);
            }
        }
    }

    private static void InPlace(Toolpath toolpath, int block, bool[] inPlace)
    {
        var columns = toolpath.Blocks[block].Columns;
        var first = toolpath.FirstOf(block);
        var start = toolpath.StartOf(block);
        for (var i = 0; i < columns.Count; i++)
        {
            var end = new Vec3(columns.X[i], columns.Y[i], columns.Z[i]);
            inPlace[first + i] = Move.IsSame(start, end) && !columns.TryGetArc(i, out _);
            start = end;
        }
    }
}

namespace Caterpillar.Toolpaths;

/// <summary>Finds the moves that are mapped together with the selected moves.</summary>
internal static class MappedMoves
{
    public static MoveSet All(Toolpath toolpath)
    {
        var (all, inPlace) = (new MoveSet(toolpath.Count), new MoveSet(toolpath.Count));
        for (var block = 0; block < toolpath.Blocks.Count; block++) InPlace(toolpath, block, inPlace);
        for (var i = 0; i < toolpath.Count; i++) all[i] = true;
        Unmap(toolpath, all, inPlace);
        return all;
    }

    /// <summary>
    /// The selected extrusions, the selected moves between them, and the moves in place at their ends. Travel moves to the first extrusion or away from
    /// the last one have one end elsewhere: a travel move from or to the home position does not change. The first move may follow a selected extrusion.
    /// </summary>
    public static MoveSet Of(Toolpath toolpath, MoveFilter filter, bool follows = false)
    {
        var choice = new MoveChoice(filter, toolpath);
        var (mapped, inPlace) = (new MoveSet(toolpath.Count), new MoveSet(toolpath.Count));
        // The move after the last selected extrusion, while all moves since then are selected.
        int? next = follows ? 0 : null;
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var columns = toolpath.Blocks[block].Columns;
            var first = toolpath.FirstOf(block);
            InPlace(toolpath, block, inPlace);
            for (var i = 0; i < columns.Count; i++)
            {
                var chosen = choice.Has(columns, i);
                if (!chosen) next = null;
                if (!chosen || columns.Kind[i] is not (MoveKind.Print or MoveKind.Wipe or MoveKind.MovingDeretract)) continue;
                for (var k = next ?? first + i; k <= first + i; k++) mapped[k] = true;
                next = first + i + 1;
            }
        }
        if (follows && toolpath.Count > 0) mapped[0] |= inPlace[0];
        for (var i = 1; i < toolpath.Count; i++) mapped[i] |= inPlace[i] && mapped[i - 1];
        for (var i = toolpath.Count - 2; i >= 0; i--) mapped[i] |= inPlace[i] && mapped[i + 1];
        Unmap(toolpath, mapped, inPlace);
        return mapped;
    }

    // Homing moves, which go to the switches, and moves in place without a travel to the extrusion that follows.
    private static void Unmap(Toolpath toolpath, MoveSet mapped, MoveSet inPlace)
    {
        foreach (var what in toolpath.Events)
        {
            if (what.Event is HomeEvent && what.Move < toolpath.Count && Homes(what.Move)) mapped[what.Move] = false;
        }
        for (var i = inPlace.Find(true, 1, toolpath.Count); i < toolpath.Count; i = inPlace.Find(true, i + 1, toolpath.Count))
        {
            if (mapped[i] && !mapped[i - 1] && (inPlace[i - 1] || toolpath[i - 1].Kind == MoveKind.Print || Homes(i - 1))) mapped[i] = false;
        }

        bool Homes(int move) => toolpath.HomeOf(toolpath[move]) is not null;
    }

    private static void InPlace(Toolpath toolpath, int block, MoveSet inPlace)
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

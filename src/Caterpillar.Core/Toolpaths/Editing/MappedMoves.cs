namespace Caterpillar.Toolpaths;

/// <summary>Determines which moves are mapped together with the chosen ones.</summary>
internal static class MappedMoves
{
    public static bool[] All(Toolpath toolpath)
    {
        var all = new bool[toolpath.Count];
        for (var i = 0; i < all.Length; i++) all[i] = true;
        Unmap(toolpath, all);
        return all;
    }

    /// <summary>
    /// The chosen strands, the chosen moves between them, and the moves in place at their ends. Travels that lead to the first strand or away from the last
    /// have one end elsewhere: a travel from or to the home position stays.
    /// </summary>
    public static bool[] Of(Toolpath toolpath, MoveFilter filter)
    {
        var chosen = new bool[toolpath.Count];
        var inPlace = new bool[toolpath.Count];
        var strands = new bool[toolpath.Count];
        foreach (var move in toolpath.Moves())
        {
            chosen[move.Index] = filter.Matches(toolpath, move);
            inPlace[move.Index] = move.IsInPlace;
            strands[move.Index] = move.Kind is MoveKind.Print or MoveKind.Wipe or MoveKind.MovingRestore;
        }
        var mapped = new bool[toolpath.Count];
        var last = -1;
        for (var i = 0; i < mapped.Length; i++)
        {
            if (!chosen[i]) last = -1;
            if (!chosen[i] || !strands[i]) continue;
            for (var k = last < 0 ? i : last + 1; k <= i; k++) mapped[k] = true;
            last = i;
        }
        for (var i = 1; i < mapped.Length; i++) mapped[i] |= inPlace[i] && mapped[i - 1];
        for (var i = mapped.Length - 2; i >= 0; i--) mapped[i] |= inPlace[i] && mapped[i + 1];
        Unmap(toolpath, mapped);
        return mapped;
    }

    /// <summary>Unmaps homing moves, which go to the switches, and moves in place without a travel to the strand that follows.</summary>
    public static void Unmap(Toolpath toolpath, bool[] mapped)
    {
        var stays = false;
        foreach (var move in toolpath.Moves())
        {
            if (toolpath.HomeOf(move) is not null) mapped[move.Index] = false;
            else if (stays && mapped[move.Index] && move.IsInPlace) mapped[move.Index] = false;
            var leads = move.Index == 0 || mapped[move.Index] || (move.Kind != MoveKind.Print && toolpath.HomeOf(move) is null && !move.IsInPlace);
            stays = !leads;
        }
    }
}

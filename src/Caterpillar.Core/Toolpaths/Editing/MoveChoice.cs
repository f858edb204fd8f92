namespace Caterpillar.Toolpaths;

/// <summary>Applies a filter to all moves of a toolpath, with a few look-ups for each.</summary>
internal static class MoveChoice
{
    /// <summary>Whether each move of a toolpath is selected.</summary>
    public static bool[] Of(MoveFilter filter, Toolpath toolpath)
    {
        var kinds = Enum.GetValues(typeof(MoveKind)).Cast<MoveKind>().Select(k => filter.Kinds is null || filter.Kinds.Contains(k)).ToArray();
        var roles = Enum.GetValues(typeof(Role)).Cast<Role>().Select(r => filter.Roles is null || filter.Roles.Contains(r)).ToArray();
        // By layer; at last, of moves without one.
        var layers = toolpath.Layers.Select(filter.MatchesNumber).Concat([filter.MatchesNumber(null)]).ToArray();
        var chosen = new bool[toolpath.Count];
        var move = 0;
        foreach (var block in toolpath.Blocks)
        {
            var c = block.Columns;
            for (var i = 0; i < c.Count; i++)
            {
                var layer = c.Layer[i];
                chosen[move++] = kinds[(int)c.Kind[i]] && roles[(int)c.Role[i]] && layers[layer < 0 ? layers.Length - 1 : layer]
                    && (filter.Tool is null || c.Tool[i] == filter.Tool)
                    && (filter.Box is null || filter.Box.Value.Contains(new Vec3(c.X[i], c.Y[i], c.Z[i])));
            }
        }
        return chosen;
    }
}

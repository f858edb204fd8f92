namespace Caterpillar.Slicing;

/// <summary>
/// Purges tools into sparse infill: what a tool prints first after a change. That is its own infill where another tool has printed the walls already, and
/// infill of parts that were printed before the change, unless their infill has a tool of its own.
/// </summary>
internal static class InfillPurge
{
    /// <summary>Moves infill to the beginning of turns and lowers what is left to purge.</summary>
    public static void Take(ToolTurn[] level)
    {
        var walls = WallTools(level);
        for (var k = 1; k < level.Length; k++)
        {
            for (var i = k; i >= 0 && level[k].Purge > 0; i--) Take(level[k], level[i], walls, Array.ConvertAll(level, t => t.Tool).Take(k).ToArray());
        }
    }

    private static void Take(ToolTurn turn, ToolTurn from, Dictionary<(int Layer, int Island), int> walls, int[] before)
    {
        var isOwn = ReferenceEquals(turn, from);
        var taken = new List<SlicedLayer>();
        for (var i = 0; i < from.Layers.Count && turn.Purge > 0; i++)
        {
            var steps = new List<PathStep>();
            var rest = new List<PathStep>();
            foreach (var step in from.Layers[i].Steps)
            {
                var group = step.Group!.Value;
                var isFree = step.Path.Role == Role.Infill && turn.Purge > 0 && walls.TryGetValue((group.Layer, group.Island), out var wall)
                    && before.Contains(wall) && (isOwn || wall == from.Tool);
                if (isFree) turn.Purge -= VolumeOf(step.Path);
                if (isFree) steps.Add(step.With(step.Path.With(tool: turn.Tool)));
                else rest.Add(step);
            }
            if (steps.Count == 0) continue;
            taken.Add(from.Layers[i] with { Steps = steps });
            from.Layers[i] = from.Layers[i] with { Steps = rest };
        }
        from.Layers.RemoveAll(l => l.Steps.Count == 0);
        turn.Layers.InsertRange(0, taken);
    }

    // The tool of the walls of each island.
    private static Dictionary<(int Layer, int Island), int> WallTools(ToolTurn[] level)
    {
        var walls = new Dictionary<(int Layer, int Island), int>();
        foreach (var step in level.SelectMany(t => t.Layers).SelectMany(l => l.Steps))
        {
            if (step.Path.Role is Role.OuterWall or Role.InnerWall or Role.OverhangWall)
                walls[(step.Group!.Value.Layer, step.Group.Value.Island)] = step.Path.Tool;
        }
        return walls;
    }

    private static double VolumeOf(PrintPath path)
    {
        var volume = 0.0;
        for (var i = 0; i < path.SegmentCount; i++) volume += path.BeadOf(i).Area * path.RawPoints[i].DistanceTo(path.EndOf(i));
        return volume;
    }
}

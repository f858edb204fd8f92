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
        var walls = new Dictionary<(int Layer, int Island), int>();
        foreach (var step in level.SelectMany(t => t.Layers).SelectMany(l => l.Steps))
        {
            if (step.Path.Role is Role.OuterWall or Role.InnerWall or Role.OverhangWall)
                walls[(step.Group!.Value.Layer, step.Group.Value.Island)] = step.Path.Tool;
        }
        for (var k = 1; k < level.Length; k++)
        {
            for (var i = k; i >= 0; i--) Take(level[k], level[i], walls, Array.ConvertAll(level, t => t.Tool).Take(k).ToArray());
        }
    }

    private static void Take(ToolTurn turn, ToolTurn from, Dictionary<(int Layer, int Island), int> walls, int[] before)
    {
        var taken = new List<SlicedLayer>();
        for (var i = 0; i < from.Layers.Count && turn.Purge > 0; i++)
        {
            var moved = from.Layers[i].Steps.Where(IsFree).ToArray();
            if (moved.Length == 0) continue;
            taken.Add(from.Layers[i] with { Steps = Array.ConvertAll(moved, s => s with { Path = s.Path with { Tool = turn.Tool } }) });
            from.Layers[i] = from.Layers[i] with { Steps = from.Layers[i].Steps.Except(moved).ToArray() };
        }
        from.Layers.RemoveAll(l => l.Steps.Count == 0);
        turn.Layers.InsertRange(0, taken);

        bool IsFree(PathStep step)
        {
            if (!(turn.Purge > 0) || step.Path.Role != Role.Infill || step.Group is not { } group) return false;
            if (!walls.TryGetValue((group.Layer, group.Island), out var wall) || !before.Contains(wall) || (turn != from && wall != from.Tool)) return false;
            turn.Purge -= Enumerable.Range(0, step.Path.SegmentCount)
                .Sum(i => step.Path.BeadOf(i).Area * step.Path.RawPoints[i].DistanceTo(step.Path.EndOf(i)));
            return true;
        }
    }
}

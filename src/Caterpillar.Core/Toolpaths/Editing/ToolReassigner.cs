namespace Caterpillar.Toolpaths;

/// <summary>
/// Assigns a range of moves to another tool; a new tool has the properties of the last one. Each tool has its own balance of retraction, so that
/// a move that restored one may prime the other; kinds and deposited amounts follow.
/// </summary>
internal sealed class ToolReassigner(Toolpath toolpath, int from, int until, int tool)
{
    private readonly Dictionary<int, double> _before = [];
    private readonly Dictionary<int, double> _now = [];

    public Toolpath Run()
    {
        var blocks = new List<ToolpathBlock>(toolpath.Blocks.Count);
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var columns = toolpath.Blocks[block].Columns;
            var first = toolpath.FirstOf(block);
            ToolpathColumns? copy = null;
            for (var i = 0; i < columns.Count; i++)
            {
                var changes = first + i >= from && first + i < until && columns.Tool[i] != tool;
                if (changes)
                {
                    copy ??= columns.Copy(columns.Count);
                    copy.Tool[i] = checked((short)tool);
                }
                Balance(columns, ref copy, i, changes ? tool : columns.Tool[i]);
            }
            blocks.Add(copy is null ? toolpath.Blocks[block] : new ToolpathBlock(copy));
        }
        var tools = toolpath.Tools.ToList();
        while (tools.Count <= tool) tools.Add(tools.Count > 0 ? tools[tools.Count - 1] : new ToolpathTool(null));
        return toolpath.WithBlocks(blocks).WithTools(tools);
    }

    private void Balance(ToolpathColumns columns, ref ToolpathColumns? copy, int i, int toolNow)
    {
        var e = columns.E[i];
        if (e == 0) return;
        var restored = Restore(_before, columns.Tool[i], e);
        var restoredNow = Restore(_now, toolNow, e, out var hadRetracted);
        if (e < 0 || Math.Abs(restored - restoredNow) <= 1e-9) return;
        copy ??= columns.Copy(columns.Count);
        var flow = e - restored > 1e-9 && columns.Deposited[i] > 0 ? columns.Deposited[i] / (e - restored) : 1;
        var deposited = Math.Max(e - restoredNow, 0) * flow;
        var inPlace = columns.Kind[i] is MoveKind.Deretract or MoveKind.Prime;
        copy.Deposited[i] = deposited;
        copy.Kind[i] = inPlace ? (hadRetracted ? MoveKind.Deretract : MoveKind.Prime) : deposited > 0 ? MoveKind.Print : MoveKind.MovingDeretract;
    }

    private static double Restore(Dictionary<int, double> pulled, int tool, double e) => Restore(pulled, tool, e, out _);

    // The part of the E that only restores.
    private static double Restore(Dictionary<int, double> pulled, int tool, double e, out bool hadRetracted)
    {
        pulled.TryGetValue(tool, out var before);
        hadRetracted = before > 1e-9;
        var restored = e > 0 ? Math.Min(before, e) : 0;
        pulled[tool] = e < 0 ? before - e : before - restored;
        return restored;
    }
}

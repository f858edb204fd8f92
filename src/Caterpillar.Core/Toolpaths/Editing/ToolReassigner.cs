namespace Caterpillar.Toolpaths;

/// <summary>
/// Assigns a range of moves to another tool. A new tool has the properties of the last one. Each tool has its own retraction balance: a move that deretracted
/// one tool may prime the other. Kinds and deposited amounts follow.
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
            blocks.Add(copy is null ? toolpath.Blocks[block] : new ToolpathBlock(copy, toolpath.Blocks[block].File));
        }
        var tools = toolpath.Tools.ToList();
        while (tools.Count <= tool) tools.Add(tools.Count > 0 ? tools[tools.Count - 1] : new ToolpathTool(null));
        return toolpath.With(blocks, tools: tools);
    }

    private void Balance(ToolpathColumns columns, ref ToolpathColumns? copy, int i, int toolNow)
    {
        var e = columns.E[i];
        if (e == 0) return;
        var deretracted = Deretract(_before, columns.Tool[i], e, out _);
        var deretractedNow = Deretract(_now, toolNow, e, out var hadRetracted);
        if (e < 0 || Math.Abs(deretracted - deretractedNow) <= 1e-9) return;
        copy ??= columns.Copy(columns.Count);
        var flow = e - deretracted > 1e-9 && columns.Deposited[i] > 0 ? columns.Deposited[i] / (e - deretracted) : 1;
        var deposited = Math.Max(e - deretractedNow, 0) * flow;
        var inPlace = columns.Kind[i] is MoveKind.Deretract or MoveKind.Prime;
        copy.Deposited[i] = deposited;
        copy.Kind[i] = inPlace ? (hadRetracted ? MoveKind.Deretract : MoveKind.Prime) : deposited > 0 ? MoveKind.Print : MoveKind.MovingDeretract;
    }

    // The part of the E that only deretracts.
    private static double Deretract(Dictionary<int, double> retracted, int tool, double e, out bool hadRetracted)
    {
        retracted.TryGetValue(tool, out var before);
        hadRetracted = before > 1e-9;
        var deretracted = e > 0 ? Math.Min(before, e) : 0;
        retracted[tool] = e < 0 ? before - e : before - deretracted;
        return deretracted;
    }
}

namespace Caterpillar.Toolpaths;

/// <summary>Arcs in toolpaths, fitted to runs of straight printing moves.</summary>
internal static class ToolpathArcs
{
    /// <summary>
    /// Replaces runs of straight printing moves with arcs within a tolerance (see <see cref="ArcFitter"/>). A run has one role, layer, tool and speed, and
    /// nothing between its lines. Its material per mm varies by no more than <paramref name="evenness"/> and the rounding of the file. An arc gets the source
    /// of its first move and the material of all.
    /// </summary>
    public static Toolpath FitArcs(this Toolpath toolpath, double tolerance = 0.02, double evenness = 0.02)
    {
        var eventful = new HashSet<int>(toolpath.Events.Select(e => e.Move));
        var blocks = new List<ToolpathBlock>();
        var events = new List<MoveEvent>();
        var next = 0;
        var made = 0;
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var columns = toolpath.Blocks[block].Columns;
            var first = toolpath.FirstOf(block);
            var points = new Vec3[columns.Count + 1];
            points[0] = toolpath.StartOf(block);
            for (var i = 0; i < columns.Count; i++) points[i + 1] = new Vec3(columns.X[i], columns.Y[i], columns.Z[i]);
            var fitter = new ArcFitter(points, tolerance);
            ToolpathBuilder? editor = null;
            var run = 0;
            for (var i = 0; i < columns.Count;)
            {
                for (; next < toolpath.Events.Count
                    && toolpath.Events[next].Move <= first + i; next++) events.Add(toolpath.Events[next] with { Move = made });
                if (run <= i) run = RunEnd(columns, points, i, first, eventful, evenness);
                if (fitter.From(i, run) is { } fit)
                {
                    if (editor is null)
                    {
                        editor = ToolpathBuilder.At(toolpath, first, columns.Count);
                        editor.Add(columns, 0, i);
                    }
                    double e = 0, deposited = 0;
                    for (var k = i; k < fit.End; k++)
                    {
                        e += columns.E[k];
                        deposited += columns.Deposited[k];
                    }
                    editor.Line = columns.Line?[i] ?? 0;
                    editor.Add(points[fit.End], e, deposited, columns.Speed[i], MoveKind.Print, columns.Role[i], columns.Layer[i], columns.Tool[i],
                        columns.Source[i], fit.Arc);
                    i = fit.End;
                }
                else
                {
                    editor?.Add(columns, i, i + 1);
                    i++;
                }
                made++;
            }
            if (editor is null) blocks.Add(toolpath.Blocks[block]);
            else blocks.AddRange(editor.ToBlocks());
        }
        for (; next < toolpath.Events.Count; next++) events.Add(toolpath.Events[next] with { Move = made });
        return toolpath.With(blocks, events);
    }

    // After the last move of the run that starts at a move.
    private static int RunEnd(ToolpathColumns c, Vec3[] points, int start, int first, HashSet<int> eventful, double evenness)
    {
        if (!IsStraightPrint(c, start)) return start + 1;
        var length = points[start].DistanceTo(points[start + 1]);
        if (!(length > 0)) return start + 1;
        var rate = c.E[start] / length;
        var end = start + 1;
        for (; end < c.Count && IsStraightPrint(c, end) && !eventful.Contains(first + end); end++)
        {
            if (c.Role[end] != c.Role[start] || c.Layer[end] != c.Layer[start] || c.Tool[end] != c.Tool[start] || c.Speed[end] != c.Speed[start]) break;
            if (c.Source[end] != c.Source[end - 1] + 1 && c.Source[end] != c.Source[end - 1]) break;
            var step = points[end].DistanceTo(points[end + 1]);
            if (Math.Abs(c.E[end] - rate * step) > evenness * rate * step + 2e-5 + 1e-3 * rate) break;
        }
        return end;
    }

    private static bool IsStraightPrint(ToolpathColumns c, int i)
        => c.Kind[i] == MoveKind.Print && c.E[i] == c.Deposited[i] && c.Turns is null && !c.TryGetArc(i, out _);
}

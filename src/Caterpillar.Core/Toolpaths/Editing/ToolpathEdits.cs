namespace Caterpillar.Toolpaths;

/// <summary>
/// Edits of a planned or decoded toolpath. Each returns a new toolpath that shares the unchanged blocks. Moves keep their sources, so that only the changed
/// lines of a decoded file are written differently.
/// </summary>
public static class ToolpathEdits
{
    /// <summary>Multiplies the speed of the selected moves.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The factor is not positive and finite.</exception>
    public static Toolpath ScaleSpeed(this Toolpath toolpath, MoveFilter filter, double factor, CancellationToken cancel = default)
    {
        if (!(factor > 0) || double.IsInfinity(factor)) throw new ArgumentOutOfRangeException(nameof(factor), factor, "Must be positive and finite.");
        return Change(toolpath, filter, (columns, chosen) =>
        {
            var speed = columns.Speed = (double[])columns.Speed.Clone();
            for (var i = 0; i < columns.Count; i++)
            {
                if (chosen.Has(columns, i)) speed[i] *= factor;
            }
        }, cancel);
    }

    /// <summary>Multiplies the material of the selected printing moves. Deretraction does not change.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The factor is negative or not finite.</exception>
    public static Toolpath ScaleFlow(this Toolpath toolpath, MoveFilter filter, double factor, CancellationToken cancel = default)
    {
        if (!(factor >= 0) || double.IsInfinity(factor)) throw new ArgumentOutOfRangeException(nameof(factor), factor, "The flow factor must be 0 or more.");
        return Change(toolpath, filter, (columns, chosen) =>
        {
            var e = columns.E = (double[])columns.E.Clone();
            var amounts = columns.Deposited = (double[])columns.Deposited.Clone();
            for (var i = 0; i < columns.Count; i++)
            {
                if (!chosen.Has(columns, i) || columns.Kind[i] is not (MoveKind.Print or MoveKind.Prime)) continue;
                var deposited = amounts[i] * factor;
                e[i] += deposited - amounts[i];
                amounts[i] = deposited;
            }
        }, cancel);
    }

    /// <summary>
    /// Removes the selected moves. Adds a travel move if the head no longer reaches the start of an extrusion. After the cut, each tool is retracted as far as
    /// before, by E or by the firmware. Events, homing and the moves after the last extrusion of the last layer (end code) stay.
    /// </summary>
    public static Toolpath Remove(this Toolpath toolpath, MoveFilter filter, CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (filter is null) throw new ArgumentNullException(nameof(filter));
        var removed = MoveChoice.Of(filter, toolpath);
        var end = PrintCut.EndOfPrint(toolpath);
        for (var i = end; i < toolpath.Count && end > 0; i++) removed[i] = false;
        return new MoveRemover(toolpath, removed).Run(cancel);
    }

    /// <summary>Keeps only the selected moves. See <see cref="Remove"/>.</summary>
    public static Toolpath Keep(this Toolpath toolpath, MoveFilter filter, CancellationToken cancel = default)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (filter is null) throw new ArgumentNullException(nameof(filter));
        var removed = MoveChoice.Of(filter, toolpath);
        for (var i = 0; i < toolpath.Count; i++) removed[i] = !removed[i];
        return new MoveRemover(toolpath, removed).Run(cancel);
    }

    /// <summary>The moves before one, and that one up to a position (mm), which is a part of it from 0 to 1. All blocks before it are shared.</summary>
    public static Toolpath Until(this Toolpath toolpath, int move, Vec3 position, double done)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (move < 0) throw new ArgumentOutOfRangeException(nameof(move));
        if (move >= toolpath.Count) return toolpath;
        var block = toolpath.BlockOf(move);
        var last = move - toolpath.FirstOf(block);
        var columns = toolpath.Blocks[block].Columns.Copy(done > 0 ? last + 1 : last);
        if (done > 0)
        {
            (columns.X[last], columns.Y[last], columns.Z[last]) = (position.X, position.Y, position.Z);
            columns.E[last] *= done;
            columns.Deposited[last] *= done;
            if (columns.TryGetArc(last, out var arc))
                columns.Arcs = [.. columns.Arcs.Take(columns.Arcs.Length - 1), arc with { Sweep = arc.Sweep * done }];
        }
        var count = toolpath.FirstOf(block) + columns.Count;
        return toolpath.With([.. toolpath.Blocks.Take(block), new ToolpathBlock(columns)], toolpath.Events.Where(e => e.Move < count));
    }

    /// <summary>
    /// Inserts an event before a move, or at the end (number of moves). After a <see cref="ToolEvent"/>, its tool makes the moves up to the next one. Each tool
    /// has its own retraction balance.
    /// </summary>
    /// <exception cref="ArgumentOutOfRangeException">The toolpath has no move with this number.</exception>
    public static Toolpath Insert(this Toolpath toolpath, int move, PrinterEvent what)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (what is null) throw new ArgumentNullException(nameof(what));
        if (move < 0 || move > toolpath.Count) throw new ArgumentOutOfRangeException(nameof(move), move, "The toolpath has no move with this number.");
        var events = toolpath.Events.ToList();
        var at = events.FindIndex(e => e.Move > move);
        if (at < 0) at = events.Count;
        // A dwell or a homing move belongs to its event: an event inserted before the move comes before both.
        while (at > 0 && events[at - 1].Move == move && events[at - 1].Event is DwellEvent or HomeEvent && move < toolpath.Count
            && IsOf(toolpath, toolpath[move], events[at - 1].Event)) at--;
        var next = events.Skip(at).Where(e => e.Event is ToolEvent).Select(e => (int?)e.Move).FirstOrDefault() ?? toolpath.Count;
        events.Insert(at, new MoveEvent(move, what));
        return (what is ToolEvent { Tool: >= 0 } tool ? new ToolReassigner(toolpath, move, next, tool.Tool).Run() : toolpath).With(events: events);
    }

    /// <summary>Inserts an event (a pause, a tool, a temperature) before the first move of a layer, by its number in its object.</summary>
    /// <returns>The toolpath, or the error <c>toolpath.no_layer</c>.</returns>
    public static Result<Toolpath> InsertAtLayer(this Toolpath toolpath, int layer, PrinterEvent what)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        return toolpath.FirstOfLayer(layer) is { } first ? new Result<Toolpath>(toolpath.Insert(first.Index, what), [])
            : new Result<Toolpath>("toolpath.no_layer", $"Layer {NumberFormatter.Format(layer)} not found.");
    }

    private static bool IsOf(Toolpath toolpath, Move move, PrinterEvent what)
        => what is DwellEvent ? move.Kind == MoveKind.Dwell : toolpath.HomeOf(move) is not null;

    // Changes the columns of each block that has chosen moves. They are shared: what changes is replaced first.
    private static Toolpath Change(Toolpath toolpath, MoveFilter filter, Action<ToolpathColumns, MoveChoice> change, CancellationToken cancel)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (filter is null) throw new ArgumentNullException(nameof(filter));
        var chosen = new MoveChoice(filter, toolpath);
        return toolpath.With(toolpath.Blocks.Select(block =>
        {
            cancel.ThrowIfCancellationRequested();
            return block.Edited(Changed) ?? block;
        }));

        ToolpathColumns? Changed(ToolpathColumns columns)
        {
            if (!Enumerable.Range(0, columns.Count).Any(i => chosen.Has(columns, i))) return null;
            var changed = columns.Share();
            change(changed, chosen);
            return changed;
        }
    }
}

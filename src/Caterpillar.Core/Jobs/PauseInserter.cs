namespace Caterpillar.Jobs;

/// <summary>Adds pauses to a finished toolpath.</summary>
internal static class PauseInserter
{
    /// <summary>Adds a pause before the first move of a layer: retract, raise the head, park, wait, return and deretract.</summary>
    /// <param name="toolpath">The toolpath.</param>
    /// <param name="layer">Number of the layer.</param>
    /// <param name="setup">Its printer says how it pauses; null = only the command of the flavor.</param>
    /// <returns>The toolpath, or the error <c>toolpath.no_layer</c>.</returns>
    public static Result<Toolpath> PauseAtLayer(this Toolpath toolpath, int layer, PrintSetup? setup)
    {
        PrinterEvent what = setup?.Printer.PauseGCode is { Count: > 0 } lines ? new RawEvent(string.Join("\n", lines)) : new PauseEvent();
        return setup?.Printer.PauseLift > 0 && toolpath.FirstOfLayer(layer) is { } first
            ? new Result<Toolpath>(Insert(toolpath, first, setup, what), []) : toolpath.InsertAtLayer(layer, what);
    }

    private static Toolpath Insert(Toolpath toolpath, Move before, PrintSetup setup, PrinterEvent what)
    {
        var block = toolpath.BlockOf(before.Index);
        var columns = toolpath.Blocks[block].Columns;
        var editor = ToolpathBuilder.At(toolpath, toolpath.FirstOf(block));
        var at = before.Index - toolpath.FirstOf(block);
        editor.Add(columns, 0, at);
        editor.Line = columns.Line?[at] ?? 0;
        var made = Moves(toolpath, before, setup, editor);
        editor.Add(columns, at, columns.Count);
        // The head waits after retracting, rising and parking.
        var parked = before.Index + made / 2;
        var events = toolpath.Events.Select(e => e.Move >= before.Index && !IsBefore(toolpath, e, before) ? e with { Move = e.Move + made } : e).ToList();
        events.Insert(events.FindIndex(e => e.Move > parked) is >= 0 and var place ? place : events.Count, new MoveEvent(parked, what));
        var blocks = toolpath.Blocks.Take(block).Concat(editor.ToBlocks()).Concat(toolpath.Blocks.Skip(block + 1));
        return toolpath.With(blocks, events);
    }

    // What the file says before the first move of the layer stays there, up to a dwell or homing, whose move it is.
    private static bool IsBefore(Toolpath toolpath, MoveEvent e, Move before)
        => e.Move == before.Index && before.Kind != MoveKind.Dwell && toolpath.HomeOf(before) is null;

    // As many moves after the pause as before it.
    private static int Moves(Toolpath toolpath, Move before, PrintSetup setup, ToolpathBuilder editor)
    {
        var (printer, speed) = (setup.Printer, setup.Settings.TravelSpeed);
        var from = before.Start;
        double top = from.Z, leastX = from.X, leastY = from.Y;
        var hasE = false;
        foreach (var move in toolpath.Moves())
        {
            hasE |= move.E != 0;
            if (toolpath.HomeOf(move) is not null) continue;
            if (move.Index < before.Index && move.Kind == MoveKind.Print) top = Math.Max(top, Math.Max(move.Start.Z, move.End.Z));
            if (move.Kind != MoveKind.Print) continue;
            leastX = Math.Min(leastX, Math.Min(move.Start.X, move.End.X));
            leastY = Math.Min(leastY, Math.Min(move.Start.Y, move.End.Y));
        }
        var height = Math.Max(Math.Min(top + printer.PauseLift, printer.BuildVolume.Z), top);
        var park = printer.PausePark.Count > 0 ? printer.PausePark[0] : new Vec3(leastX, leastY, 0);
        var unit = toolpath.VolumePerE(before.Tool) == 1 ? ExtrusionModel.FilamentAreaOf(setup.Material.FilamentDiameter) : 1;
        var count = 0;
        void Add(Vec3 end, double e, double speed, MoveKind kind)
        {
            editor.Add(end, e, kind == MoveKind.Deretract ? printer.PausePrime * unit : 0, speed, kind, Role.Unspecified, before.Layer, before.Tool, -1, null);
            count++;
        }
        if (hasE && printer.PauseRetraction > 0) Add(from, -printer.PauseRetraction * unit, printer.RetractionSpeed, MoveKind.Retract);
        Add(from.WithZ(height), 0, printer.ZHopSpeed, MoveKind.Travel);
        Add(park.WithZ(height), 0, speed, MoveKind.Travel);
        Add(from.WithZ(height), 0, speed, MoveKind.Travel);
        Add(from, 0, printer.ZHopSpeed, MoveKind.Travel);
        if (hasE && printer.PauseRetraction > 0)
            Add(from, (printer.PauseRetraction + printer.PausePrime) * unit, printer.RetractionSpeed, MoveKind.Deretract);
        return count;
    }
}

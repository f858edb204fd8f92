namespace Caterpillar.Checks;

/// <summary>
/// Commands in a part of the print where they do harm, and commands that are not understood. The print goes from its first to its last extrusion.
/// </summary>
internal sealed class CommandCheck
{
    private readonly Toolpath _toolpath;
    private readonly Printer _printer;
    private readonly CheckScope _scope;
    private readonly Findings _findings;
    private readonly int _first;
    private readonly int _last;
    private readonly List<Found> _found = [];

    public CommandCheck(Toolpath toolpath, Printer printer, CheckScope scope, Findings findings)
    {
        (_toolpath, _printer, _scope, _findings) = (toolpath, printer, scope, findings);
        if (scope.Commands.Count == 0) return;
        _first = FirstExtrusion();
        _last = _first < int.MaxValue ? LastExtrusion() : -1;
    }

    private enum Part
    {
        Before,
        Within,
        After,
    }

    public void Run()
    {
        foreach (var used in _scope.Commands)
        {
            if (used.UnknownAxes.Length > 0 && MacroEffect.Of(_printer.Macros, used.Name) is null) ReportLost(used);
            foreach (var place in used.Places)
            {
                var part = place.Move <= _first ? Part.Before : place.Move > _last ? Part.After : Part.Within;
                if (!_scope.IsOwnLine(place.Line) && CodeOf(used, place, part) is { } code) Add(code, used, place, part);
            }
        }
        foreach (var group in _found.GroupBy(f => f.Code)) Report(group.Key, group.ToArray());
    }

    private string? CodeOf(UsedCommand used, CommandPlace place, Part part)
    {
        var macro = MacroEffect.Of(_printer.Macros, used.Name);
        if (used.Command is null && macro is null)
        {
            var isNew = _scope.Before is { } before && !before.Any(b => b.Command is null && b.Name == used.Name);
            return isNew ? CheckCodes.UnverifiedCommand : CheckCodes.UnknownCommand;
        }
        if (IsUsual(used.Name, part)) return null;
        var use = macro is null ? used.Command!.Use : macro.Homes ? CommandUse.Start : macro.Cools ? CommandUse.End : CommandUse.Ok;
        var kind = macro is null ? used.Command!.Class : CommandClass.Flow;
        return use switch
        {
            CommandUse.Pause => CheckCodes.PauseCommand,
            CommandUse.Depends => CheckCodes.MachineCommand,
            CommandUse.Start or CommandUse.End or CommandUse.Never or CommandUse.Untracked when part == Part.Within => CheckCodes.UnsafeCommand,
            CommandUse.Start or CommandUse.Never when part == Part.After => AfterPrint(used.Name, kind),
            CommandUse.End or CommandUse.Never when part == Part.Before => BeforePrint(kind, use, place),
            _ => null,
        };
    }

    // Cold extrusion of materials that are not heated, and homing of deltas, which go up.
    private bool IsUsual(string name, Part part)
        => name == "M302" ? _printer.MinExtrusionTemperature == 0
            : part == Part.After && _printer.BedShape == BedShape.Round && name.StartsWith("G28", StringComparison.Ordinal);

    // What homes or probes meets the print. G28 is followed on its path.
    private static string AfterPrint(string name, CommandClass kind)
        => name.StartsWith("G28", StringComparison.Ordinal) ? CheckCodes.MachineCommand
            : kind is CommandClass.Home or CommandClass.Motion ? CheckCodes.UnsafeCommand : CheckCodes.SettingCommand;

    // What ends the print here, and what loses the position if it is not homed again.
    private string? BeforePrint(CommandClass kind, CommandUse use, CommandPlace place)
    {
        if (_last < 0) return null;
        var isSafe = kind switch
        {
            CommandClass.Pause or CommandClass.Flow => false,
            CommandClass.Motion or CommandClass.Home or CommandClass.Mode => IsHomedAfter(place),
            _ => use == CommandUse.Never || kind != CommandClass.Heat,
        };
        return !isSafe ? CheckCodes.UnsafeCommand : use == CommandUse.Never ? CheckCodes.SettingCommand : null;
    }

    private bool IsHomedAfter(CommandPlace place)
    {
        if (_scope.Homes) return true;
        bool x = false, y = false, z = false;
        foreach (var entry in _toolpath.Events)
        {
            if (entry.Move > _first) break;
            if (entry.Source <= place.Line || entry.Event is not HomeEvent home) continue;
            (x, y, z) = (x | home.X, y | home.Y, z | home.Z);
        }
        return x && y && z;
    }

    private void Add(string code, UsedCommand used, CommandPlace place, Part part)
    {
        var same = _found.FindIndex(f => f.Code == code && ReferenceEquals(f.Used, used));
        if (same < 0) _found.Add(new Found(code, used, place, part, place.Count));
        else _found[same] = _found[same] with { Count = _found[same].Count + place.Count };
    }

    private void Report(string code, Found[] found)
    {
        var worst = found[0];
        _findings.Add(code, EventOf(worst.Place), () => Message(code, found), found.Sum(f => f.Count));
    }

    private void ReportLost(UsedCommand used)
        => _findings.Add(CheckCodes.UnknownPosition, EventOf(used.Places[used.Places.Count - 1]),
            () => $"The file prints before the position in {used.UnknownAxes} is known: {used} may have moved the head. Move in {used.UnknownAxes} first.", 1);

    private string Message(string code, Found[] found)
    {
        var names = CommandLog.Listed(found.Select(Named).ToArray());
        switch (code)
        {
            case CheckCodes.UnknownCommand:
            case CheckCodes.UnverifiedCommand:
                return $"Not understood: {names}. What follows is unverified. Declare macros in the key macros of the printer.";
            case CheckCodes.PauseCommand:
                return $"The print pauses, and the firmware may move, retract and cool: {names}.";
            case CheckCodes.MachineCommand:
                return $"The effect depends on the machine: {names}.";
        }
        var first = found[0];
        var others = found.Length > 1 ? " Also " + CommandLog.Listed(found.Skip(1).Select(Named).ToArray()) + "." : "";
        var where = first.Part switch { Part.Before => "before", Part.Within => "within", _ => "after" };
        var remedy = code == CheckCodes.SettingCommand ? ""
            : first.Part switch { Part.Before => " Home and heat after it, or remove it.", Part.After => " Remove it.", _ => " Remove it from the print." };
        return $"{first.Used.Name} {where} the print: {first.Used.Command?.Effect ?? "a macro that homes or cools"}.{others}{remedy}";
    }

    private string Named(Found found)
        => UsedCommand.Named(found.Used.Name, _findings.PlaceOfEvent(EventOf(found.Place))?.Line ?? found.Place.Line, found.Count);

    private static MoveEvent EventOf(CommandPlace place) => new(place.Move, new CommentEvent("")) { Source = place.Line };

    private int FirstExtrusion()
        => _toolpath.Moves().Where(m => Extrudes(m) && m.Source >= _scope.FirstLine).Select(m => m.Index).DefaultIfEmpty(int.MaxValue).First();

    private int LastExtrusion()
    {
        var last = _toolpath.Count - 1;
        while (last >= 0 && !Extrudes(_toolpath[last])) last--;
        return last;
    }

    private static bool Extrudes(Move move) => move.Kind is MoveKind.Print or MoveKind.Prime;

    private readonly record struct Found(string Code, UsedCommand Used, CommandPlace Place, Part Part, int Count);
}

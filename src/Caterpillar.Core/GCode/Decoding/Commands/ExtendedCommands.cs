namespace Caterpillar.GCode;

/// <summary>Extended commands, as <c>SET_GCODE_OFFSET Z=0.2 MOVE=1</c>: a name, and words with an equals sign.</summary>
internal sealed class ExtendedCommands(Machine machine, ModeCommands modes, EventCommands events, CommentInterpreter comments)
{
    private const int LongestName = 60;
    private const int LongestText = 400;
    private readonly FlavorRules _rules = machine.Rules;
    private readonly InterpreterState _state = machine.State;

    /// <summary>The tool of <c>extruder</c>, <c>extruder1</c>, <c>extruder2</c> …; null for other names.</summary>
    public static int? ToolOf(string name)
    {
        if (!name.StartsWith("extruder", StringComparison.OrdinalIgnoreCase)) return null;
        if (name.Length == 8) return 0;
        return NumberReader.TryParseInt(name.Substring(8), out var number) ? number : null;
    }

    public void Take(byte[] text, ParsedLine line)
    {
        var start = line.CodeStart;
        while (start < line.CodeEnd && text[start] <= ' ') start++;
        machine.Log.See(text, start, line.CodeEnd);
        var end = start;
        while (end < line.CodeEnd && text[end] > ' ' && text[end] != '*') end++;
        var name = TextEncoding.Decode(text, start, Math.Min(end, start + LongestName)).ToUpperInvariant();
        var words = TextEncoding.Decode(text, end, Math.Min(line.CodeEnd, end + LongestText));
        switch (name)
        {
            case "EXCLUDE_OBJECT_START":
                comments.SetObject(Word(words, "NAME") ?? "");
                return;
            case "EXCLUDE_OBJECT_END":
                comments.SetObject("");
                return;
            case "SET_VELOCITY_LIMIT" when _rules.Limits == LimitCommands.Klipper:
                events.Limits.TakeVelocityLimit(key => Number(words, key));
                return;
            case "SET_RETRACTION" when _rules.RetractionSettings == RetractionCommands.Klipper:
                events.Limits.TakeRetraction(key => Number(words, key));
                return;
            case "SET_HEATER_TEMPERATURE" when _rules.ExtendedCommands:
                events.SetHeater(Word(words, "HEATER") ?? "", Number(words, "TARGET"));
                return;
            case "TURN_OFF_HEATERS" when _rules.ExtendedCommands:
                events.HeatersOff();
                return;
            case "ACTIVATE_EXTRUDER":
                if (_rules.ExtendedCommands && ToolOf(Word(words, "EXTRUDER") ?? "") is { } tool) machine.ChangeTool(tool);
                return;
            case "SAVE_GCODE_STATE" when _rules.ExtendedCommands:
                _state.Saved.SetNamed(modes.Current(StateName(words)));
                return;
            case "RESTORE_GCODE_STATE" when _rules.ExtendedCommands:
                RestoreState(words);
                return;
            case "SET_GCODE_OFFSET" when _rules.ExtendedCommands:
                SetOffset(words);
                return;
        }
        if (!events.TakePause(name)) machine.Log.Ignore();
    }

    private void RestoreState(string words)
    {
        if (_state.Saved.Named(StateName(words)) is not { } saved)
        {
            machine.Diagnostics.Warn("gcode.unknown_state", "RESTORE_GCODE_STATE names a state that was not saved. It is ignored.");
            return;
        }
        _state.Extrusion.Flow = saved.Extrusion.Flow;
        modes.Restore(saved, saved.Feed.Factor);
        _state.Head.SetShift(saved.Head.Shift);
        _state.Saved.Offset = saved.Offset;
        _state.Saved.OffsetE = saved.OffsetE;
        _state.Extrusion.SetE(saved.Extrusion.E);
        if (Number(words, "MOVE") is { } move && move != 0) MoveTo(saved.Head.Machine, words);
    }

    private void SetOffset(string words)
    {
        ref var saved = ref _state.Saved;
        var before = saved.Offset;
        saved.Offset = new Vec3(Changed(words, "X", before.X), Changed(words, "Y", before.Y), Changed(words, "Z", before.Z));
        var e = Changed(words, "E", saved.OffsetE);
        var change = saved.Offset - before;
        _state.Head.SetShift(_state.Head.Shift + change);
        _state.Extrusion.SetE(_state.Extrusion.E - (e - saved.OffsetE));
        var changeE = e - saved.OffsetE;
        saved.OffsetE = e;
        if (Number(words, "MOVE") is { } move && move != 0) MoveTo(_state.Head.Machine + change, words, changeE);
    }

    // To a position in machine coordinates.
    private void MoveTo(Vec3 position, string words, double e = 0)
    {
        ref var feed = ref _state.Feed;
        var speed = feed.Speed;
        if (Number(words, "MOVE_SPEED") is { } own && own is > 0 and < 1e6) feed.Speed = own;
        var target = position - _state.Head.Shift;
        _state.Extrusion.SetE(_state.Extrusion.E + e);
        machine.Moves.Line(target.X, target.Y, target.Z, e, 1);
        feed.Speed = speed;
    }

    private static double Changed(string words, string axis, double before)
    {
        var value = Number(words, axis) ?? (Number(words, axis + "_ADJUST") is { } more ? before + more : before);
        return value is > -MoveRecorder.LargestLength and < MoveRecorder.LargestLength ? value : before;
    }

    private static string StateName(string words) => (Word(words, "NAME") ?? "DEFAULT").ToUpperInvariant();

    private static double? Number(string words, string key) => Word(words, key) is { } text && NumberReader.TryParse(text, out var value) ? value : null;

    private static string? Word(string words, string key)
    {
        for (var at = 0; (at = words.IndexOf(key + "=", at, StringComparison.OrdinalIgnoreCase)) >= 0; at += key.Length)
        {
            if (at > 0 && words[at - 1] > ' ') continue;
            at += key.Length + 1;
            var end = at;
            while (end < words.Length && words[end] > ' ') end++;
            return words.Substring(at, end - at).Trim('"', '\'');
        }
        return null;
    }
}

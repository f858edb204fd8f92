namespace Caterpillar.GCode;

/// <summary>M commands: modes, speed and flow factors, tools, extruder switch. <see cref="EventCommands"/> reads events.</summary>
internal sealed class MachineCommands(
    Machine machine, ModeCommands modes, PositionCommands positions, EventCommands events, CommentInterpreter comments)
{
    private readonly FlavorRules _rules = machine.Rules;
    private readonly InterpreterState _state = machine.State;

    public void Take(byte[] text, ParsedLine line)
    {
        machine.Log.See(text, line.LetterAt[0], line.CodeEnd);
        var code = line.Values[0] is >= 0 and < 100000 ? (int)Math.Floor(line.Values[0] * 10 + 0.5) : -1;
        if (events.Take(code, line)) return;
        switch (code)
        {
            case 820 or 830:
                modes.SetRelativeE(code == 830);
                return;
            case 1010 or 1030:
                _state.Extrusion.IsSwitchedOn = code == 1010;
                return;
            case 2010 or 3010 when _rules.SwitchedTools && line.Count == 1:
                machine.ChangeTool(code / 1000 - 1);
                _state.Extrusion.IsSwitchedOn = true;
                return;
            case 1200 when _rules.ModeStack:
                modes.Push();
                return;
            case 1210 when _rules.ModeStack:
                modes.Pop();
                return;
            case 2000 when _rules.Volumetric:
                modes.SetVolumetric(line);
                return;
            case 2200 when _rules.SpeedFactor:
                SpeedFactor(line);
                return;
            case 2210 when _rules.FlowFactor != FlowFactorRule.Ignored:
                FlowFactor(line);
                return;
            case 2060 when _rules.HomeOffset != HomeOffsetRule.None:
                positions.SetHomeOffset(line);
                return;
            case 2900 when _rules.LargestBabystep > 0:
                positions.Babystep(line);
                return;
            case 60 when _rules.ToolByM6:
                machine.ChangeTool(line.TryGet('T', out var tool) ? tool : double.IsNaN(_state.NextTool) ? _state.Tool : _state.NextTool);
                return;
            case 4860:
                ObjectByNumber(text, line);
                return;
            default:
                if (IsToolChange(code, line)) return;
                if (FlavorRules.Names(_rules.Dwells, 'M', code / 10.0)) events.Dwell(line);
                if (code == 2000) machine.Features.Add(Feature.M200);
                machine.Log.Ignore();
                return;
        }
    }

    // M135 T1 and its like: changes the tool.
    private bool IsToolChange(int code, ParsedLine line)
    {
        foreach (var command in _rules.ToolCommands)
        {
            var space = command.IndexOf(" ", StringComparison.Ordinal);
            if (!NumberReader.TryParseInt(command.Substring(1, space - 1), out var number) || number * 10 != code
                || !line.TryGet(command[space + 1], out var tool))
            {
                continue;
            }
            machine.ChangeTool(tool);
            return true;
        }
        return false;
    }

    private void SpeedFactor(ParsedLine line)
    {
        ref var feed = ref _state.Feed;
        var factor = Factor(line, feed.Factor);
        if (_rules.SpeedMemory != SpeedMemoryRule.None)
        {
            var saved = feed.SavedFactor;
            if (line.Has('B')) feed.SavedFactor = feed.Factor;
            if (line.Has('R'))
            {
                if (_rules.SpeedMemory != SpeedMemoryRule.RestoresFirst) factor = feed.SavedFactor;
                else if (line.Find('S') < 0) factor = saved;
            }
        }
        feed.Set(feed.Rate, factor);
    }

    private void FlowFactor(ParsedLine line)
    {
        var tool = _state.Tool;
        if (_rules.FlowToolLetter.Length > 0 && line.TryGet(_rules.FlowToolLetter[0], out var named) && named is >= 0 and < 1000) tool = (int)named;
        if (tool == _state.Tool) _state.Extrusion.Flow = Factor(line, _state.Extrusion.Flow);
        else if (_rules.FlowFactor == FlowFactorRule.PerTool) machine.Extruders.SetFlow(tool, before => Factor(line, before));
    }

    private double Factor(ParsedLine line, double before)
    {
        if (line.TryGet('S', out var percent)) return percent is > 0 and < 1e6 ? percent / 100 : before;
        return _rules.FactorsReset ? 1 : before;
    }

    // M486 S2 A"name": parts of the bed by number.
    private void ObjectByNumber(byte[] text, ParsedLine line)
    {
        if (!line.TryGet('S', out var number)) return;
        if (number < 0 || number >= 1e6)
        {
            comments.SetObject("");
            return;
        }
        var quote = Array.IndexOf(text, (byte)'"', line.CodeStart, line.CodeEnd - line.CodeStart);
        var close = quote < 0 ? -1 : Array.IndexOf(text, (byte)'"', quote + 1, line.CodeEnd - quote - 1);
        comments.SetObject(close > 0 ? TextEncoding.Decode(text, quote + 1, Math.Min(close, quote + 200)) : "object " + NumberFormatter.Format((long)number));
    }
}

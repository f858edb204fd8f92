namespace Caterpillar.GCode;

/// <summary>M commands that are events of the toolpath: temperatures, fans, pauses, accelerations, dwells.</summary>
internal sealed class EventCommands(Machine machine)
{
    private readonly FlavorRules _rules = machine.Rules;
    private readonly MoveRecorder _moves = machine.Moves;

    /// <summary>The limits of the motion.</summary>
    public LimitReader Limits { get; } = new(machine);

    /// <summary>Reads an M command, given ten times its number. False if it is none of these.</summary>
    public bool Take(int code, ParsedLine line)
    {
        if (IsPause(code, line))
        {
            _moves.AddEvent(new PauseEvent());
            return true;
        }
        switch (code)
        {
            case 1040 or 1090:
                if (Temperature(line, out var nozzle)) _moves.AddEvent(new NozzleTemperatureEvent(nozzle, code == 1090, ToolOf(line, 'T')));
                return true;
            case 1400 or 1900:
                if (Temperature(line, out var bed)) _moves.AddEvent(new BedTemperatureEvent(bed, code == 1900));
                return true;
            case 1410 or 1910:
                if (Temperature(line, out var chamber)) _moves.AddEvent(new ChamberTemperatureEvent(chamber, code == 1910));
                return true;
            case 5680 when _rules.ToolTemperatures && line.TryGet('A', out var state) && state == 0:
                _moves.AddEvent(new NozzleTemperatureEvent(0, false, ToolOf(line, 'P')));
                return true;
            case 5680 when _rules.ToolTemperatures:
                TakeToolTemperature(line);
                return true;
            case 1060 or 1070 when _rules.Fan != FanScale.None:
                Fan(line, code == 1060);
                return true;
            case 1260 or 1270 when _rules.ValveIsFan:
                _moves.AddEvent(new FanEvent(code == 1260 && line.Get('S', 1) != 0 ? 1 : 0));
                return true;
            case 4000 when !FlavorRules.Names(_rules.Dwells, 'M', 400):
                _moves.AddEvent(new FinishMovesEvent());
                return true;
            default:
                return Limits.Take(code, line);
        }
    }

    /// <summary>Reads a pause command with this name. False if the firmware has none.</summary>
    public bool TakePause(string name)
    {
        var isPause = _rules.Pauses.Contains(name);
        if (isPause) _moves.AddEvent(new PauseEvent());
        return isPause;
    }

    public void Dwell(ParsedLine line)
    {
        var seconds = _rules.DwellSeconds(line.TryGet('P', out var p) ? p : null, line.TryGet('S', out var s) ? s : null);
        if (seconds == 0) _moves.AddEvent(new FinishMovesEvent());
        if (!(seconds is > 0 and < 1e9)) return;
        _moves.AddEvent(new DwellEvent(seconds));
        _moves.Stay(MoveKind.Dwell);
    }

    /// <summary>SET_HEATER_TEMPERATURE: 0 without a target. Other heaters than nozzles and bed do not matter.</summary>
    public void SetHeater(string heater, double? target)
    {
        var celsius = target ?? 0;
        if (!IsTemperature(celsius)) return;
        if (heater.ToUpperInvariant() == "HEATER_BED") _moves.AddEvent(new BedTemperatureEvent(celsius));
        else if (heater.ToUpperInvariant() == "CHAMBER") _moves.AddEvent(new ChamberTemperatureEvent(celsius));
        else if (ExtendedCommands.ToolOf(heater) is { } tool) _moves.AddEvent(new NozzleTemperatureEvent(celsius, false, tool));
    }

    /// <summary>TURN_OFF_HEATERS.</summary>
    public void HeatersOff()
    {
        _moves.AddEvent(new BedTemperatureEvent(0));
        _moves.AddEvent(new NozzleTemperatureEvent(0));
        for (var tool = 0; tool < machine.Extruders.Count && machine.Extruders.Count > 1; tool++) _moves.AddEvent(new NozzleTemperatureEvent(0, false, tool));
    }

    /// <summary>G10 P S: the temperature of a tool. False if the line is something else.</summary>
    public bool TakeToolTemperature(ParsedLine line)
    {
        if (!_rules.ToolTemperatures || !line.TryGet('S', out var celsius) || !IsTemperature(celsius) || line.Find('L') >= 0) return false;
        _moves.AddEvent(new NozzleTemperatureEvent(celsius, false, ToolOf(line, 'P')));
        return true;
    }

    private bool IsPause(int code, ParsedLine line)
    {
        if (code < 0 || code % 10 != 0) return false;
        foreach (var pause in _rules.Pauses)
        {
            if (pause[0] != 'M') continue;
            var space = pause.IndexOf(" ", StringComparison.Ordinal);
            if (!NumberReader.TryParseInt(space < 0 ? pause.Substring(1) : pause.Substring(1, space - 1), out var number) || number * 10 != code) continue;
            if (space < 0 || (line.TryGet(pause[space + 1], out var value) && NumberFormatter.Format(value, 3) == pause.Substring(space + 2))) return true;
        }
        return false;
    }

    private bool Temperature(ParsedLine line, out double celsius)
        => line.TryGet('S', out celsius) || line.TryGet('R', out celsius) ? IsTemperature(celsius) : _rules.NoTargetIsOff;

    private static bool IsTemperature(double celsius) => celsius is > -300 and < 10000;

    private int? ToolOf(ParsedLine line, char letter) => line.TryGet(letter, out var tool) ? machine.ToolNumber(tool) : null;

    private void Fan(ParsedLine line, bool on)
    {
        // Only the part fan: others have numbers from 2 on.
        if (_rules.FanNumbers && _rules.FanLetter != 'P' && line.TryGet('P', out var number) && number is not (0 or 1)) return;
        if (!line.TryGet(_rules.FanLetter, out var speed))
        {
            // Without a number it only reports.
            if (on && _rules.Fan == FanScale.FractionOrByte) return;
            speed = on ? 255 : 0;
        }
        if (!on) speed = 0;
        if (!(speed is >= 0 and < 1e6)) return;
        _moves.AddEvent(new FanEvent(_rules.Fan switch
        {
            FanScale.Switch => speed > 0 ? 1 : 0,
            FanScale.FractionOrByte when speed <= 1 => speed,
            _ => Math.Min(speed / 255, 1),
        }));
    }
}

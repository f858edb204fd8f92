using System;
using System.Collections.Generic;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Dialects;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>M commands, extended commands, and what is ignored.</summary>
internal sealed partial class DecoderCore
{
    private const int MostKinds = 1000;
    private readonly SortedDictionary<string, int> _ignored = new(StringComparer.Ordinal);
    private bool _switchedOn;

    private bool _switched => _axis == ExtrusionAxis.Switched;

    private bool _strokes => _axis == ExtrusionAxis.Switched || (_axis == ExtrusionAxis.None && _rules.StrokesWithoutE);

    /// <summary>Commands without effect on the toolpath and how often they occur, by name.</summary>
    public IReadOnlyDictionary<string, int> IgnoredCommands => _ignored;

    private void AddEvent(PrinterEvent what) => _events.Add(new MoveEvent(_out.Count, what));

    private void Machine(byte[] text, ParsedLine line)
    {
        var code = line.Values[0] is >= 0 and < 100000 ? (int)Math.Floor(line.Values[0] * 10 + 0.5) : -1;
        if (IsPause(code, line))
        {
            AddEvent(new PauseEvent());
            return;
        }
        switch (code)
        {
            case 820:
            case 830:
                SetM83(code == 830);
                return;
            case 1010:
            case 1030:
                _switchedOn = code == 1010;
                return;
            case 2010 when _rules.SwitchedTools && line.Count == 1:
            case 3010 when _rules.SwitchedTools && line.Count == 1:
                ChangeTool(code / 1000 - 1);
                _switchedOn = true;
                return;
            case 1040:
            case 1090:
                if (Temperature(line, out var nozzle)) AddEvent(new NozzleTemperatureEvent(nozzle, code == 1090, ToolOf(line)));
                return;
            case 1400:
            case 1900:
                if (Temperature(line, out var bed)) AddEvent(new BedTemperatureEvent(bed, code == 1900));
                return;
            case 1060 when _rules.Fan != FanScale.None:
            case 1070 when _rules.Fan != FanScale.None:
                Fan(line, code == 1060);
                return;
            case 1260 when _rules.ValveIsFan:
            case 1270 when _rules.ValveIsFan:
                AddEvent(new FanEvent(code == 1260 && line.Get('S', 1) != 0 ? 1 : 0));
                return;
            case 1200 when _rules.ModeStack:
                PushModes();
                return;
            case 1210 when _rules.ModeStack:
                PopModes();
                return;
            case 2040:
                if ((line.TryGet('S', out var acceleration) || line.TryGet('P', out acceleration))
                    && acceleration is > 0 and < 1e9) AddEvent(new AccelerationEvent(acceleration));
                return;
            case 2000 when _rules.Volumetric:
                Volumetric(line);
                return;
            case 2200 when _rules.SpeedFactor:
                SpeedFactor(line);
                return;
            case 2210 when _rules.FlowFactor != FlowFactorRule.Ignored:
                FlowFactor(line);
                return;
            case 60:
                if (_rules.ToolByM6) ChangeTool(line.TryGet('T', out var tool) ? tool : double.IsNaN(_nextTool) ? _tool : _nextTool);
                else if (!ToolCommand(code, line)) Ignored('M', 6);
                return;
            case 4860:
                Object486(text, line);
                return;
            default:
                if (ToolCommand(code, line)) return;
                if (DialectRules.Names(_rules.Dwells, 'M', code / 10.0)) Dwell(line);
                if (code == 2000) Features.M200++;
                Ignored('M', line.Values[0]);
                return;
        }
    }

    // M135 T1 and its like.
    private bool ToolCommand(int code, ParsedLine line)
    {
        foreach (var command in _rules.ToolCommands)
        {
            var blank = command.IndexOf(" ", StringComparison.Ordinal);
            if (!NumberReader.TryParseInt(command.Substring(1, blank - 1), out var number) || number * 10 != code
                || !line.TryGet(command[blank + 1], out var tool)) continue;
            ChangeTool(tool);
            return true;
        }
        return false;
    }

    private bool IsPause(int code, ParsedLine line)
    {
        if (code < 0 || code % 10 != 0) return false;
        foreach (var pause in _rules.Pauses)
        {
            if (pause[0] != 'M') continue;
            var blank = pause.IndexOf(" ", StringComparison.Ordinal);
            if (!NumberReader.TryParseInt(blank < 0 ? pause.Substring(1) : pause.Substring(1, blank - 1), out var number) || number * 10 != code) continue;
            if (blank < 0 || (line.TryGet(pause[blank + 1], out var value) && NumberFormatter.Format(value, 3) == pause.Substring(blank + 2))) return true;
        }
        return false;
    }

    private static bool Temperature(ParsedLine line, out double celsius)
        => (line.TryGet('S', out celsius) || line.TryGet('R', out celsius)) && celsius is > -300 and < 10000;

    private int? ToolOf(ParsedLine line) => line.TryGet('T', out var tool) && tool >= 0 && tool < _rules.ToolLimit ? (int)tool : null;

    private void Fan(ParsedLine line, bool on)
    {
        // Only the part fan: others have numbers from 2 on.
        if (_rules.FanLetter != 'P' && line.TryGet('P', out var number) && number is not (0 or 1)) return;
        if (!line.TryGet(_rules.FanLetter, out var speed))
        {
            // Without a number it only reports.
            if (on && _rules.Fan == FanScale.FractionOrByte) return;
            speed = on ? 255 : 0;
        }
        if (!on) speed = 0;
        if (!(speed is >= 0 and < 1e6)) return;
        AddEvent(new FanEvent(_rules.Fan switch
        {
            FanScale.Switch => speed > 0 ? 1 : 0,
            FanScale.FractionOrByte when speed <= 1 => speed,
            _ => Math.Min(speed / 255, 1),
        }));
    }

    private void Macro(byte[] text, ParsedLine line)
    {
        var start = line.CodeStart;
        while (start < line.CodeEnd && text[start] <= ' ') start++;
        var end = start;
        while (end < line.CodeEnd && text[end] > ' ' && text[end] != '*') end++;
        var name = TextEncoding.Decode(text, start, Math.Min(end, start + 60)).ToUpperInvariant();
        if (_rules.ExtendedCommands && NamedState(name, TextEncoding.Decode(text, end, Math.Min(line.CodeEnd, end + 400)).ToUpperInvariant())) return;
        switch (name)
        {
            case "EXCLUDE_OBJECT_START":
                SetObject(Argument(TextEncoding.Decode(text, end, Math.Min(line.CodeEnd, end + 400)), "NAME="));
                return;
            case "EXCLUDE_OBJECT_END":
                SetObject("");
                return;
            case "ACTIVATE_EXTRUDER":
                Activate(Argument(TextEncoding.Decode(text, end, Math.Min(line.CodeEnd, end + 400)), "EXTRUDER="));
                return;
        }
        foreach (var pause in _rules.Pauses)
        {
            if (pause != name) continue;
            AddEvent(new PauseEvent());
            return;
        }
        Count(name);
    }

    // extruder, extruder1, extruder2 …
    private void Activate(string name)
    {
        if (!_rules.ExtendedCommands || !name.StartsWith("extruder", StringComparison.Ordinal)) return;
        var number = 0;
        if (name.Length == 8 || NumberReader.TryParseInt(name.Substring(8), out number)) ChangeTool(number);
    }

    private static string Argument(string text, string key)
    {
        var at = text.IndexOf(key, StringComparison.OrdinalIgnoreCase);
        if (at < 0) return "";
        at += key.Length;
        var end = at;
        while (end < text.Length && text[end] > ' ') end++;
        return text.Substring(at, end - at).Trim('"', '\'');
    }

    // M486 S2 A"name": parts of the bed by number.
    private void Object486(byte[] text, ParsedLine line)
    {
        if (!line.TryGet('S', out var number)) return;
        if (number < 0 || number >= 1e6)
        {
            SetObject("");
            return;
        }
        var quote = Array.IndexOf(text, (byte)'"', line.CodeStart, line.CodeEnd - line.CodeStart);
        var close = quote < 0 ? -1 : Array.IndexOf(text, (byte)'"', quote + 1, line.CodeEnd - quote - 1);
        SetObject(close > 0 ? TextEncoding.Decode(text, quote + 1, Math.Min(close, quote + 200)) : "object " + NumberFormatter.Format((long)number));
    }

    private void Ignored(char letter, double number)
    {
        var name = letter + NumberFormatter.Format(number is > -1e6 and < 1e6 ? number : 0, 1);
        Count(name);
        foreach (var other in _rules.NotFollowed)
        {
            if (other == name) NotFollowed(name);
        }
    }

    private void NotFollowed(string name) => Diagnostics.Add(
        Severity.Warning, "gcode.not_followed", _rules.Title + ": " + name
            + " moves the head or shifts its coordinates in a way that is not followed; positions behind it may be wrong.", new SourceLocation(Line: _line));

    private void Count(string name)
    {
        if (_ignored.TryGetValue(name, out var count)) _ignored[name] = count + 1;
        else if (_ignored.Count < MostKinds) _ignored.Add(name, 1);
        else _ignored["others"] = _ignored.TryGetValue("others", out var others) ? others + 1 : 1;
    }

    /// <summary>One remark about everything that was ignored.</summary>
    public void ReportIgnored()
    {
        if (_ignored.Count == 0) return;
        var names = new StringBuilder();
        var total = 0;
        var shown = 0;
        foreach (var pair in _ignored)
        {
            total += pair.Value;
            if (shown++ < 40) names.Append(names.Length > 0 ? ", " : "").Append(pair.Key).Append(" (").Append(NumberFormatter.Format(pair.Value)).Append(')');
        }
        if (_ignored.Count > 40) names.Append(" and ").Append(NumberFormatter.Format(_ignored.Count - 40)).Append(" more");
        Diagnostics.Add(Severity.Remark, "gcode.ignored", "Commands without effect on the toolpath: " + names + ".", count: total);
    }

    private void Refused(string code, string message) => Diagnostics.Add(Severity.Warning, code, message, new SourceLocation(Line: _line));

    private void Differs(string code, string message) => Diagnostics.Add(Severity.Warning, code, message, new SourceLocation(Line: _line));
}

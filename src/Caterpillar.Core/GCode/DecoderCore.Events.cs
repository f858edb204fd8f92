using System;
using System.Collections.Generic;
using System.Text;
using Caterpillar.Basics;
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
                Features.M82++;
                SetM83(false);
                return;
            case 830:
                Features.M83++;
                SetM83(true);
                return;
            case 1010:
            case 1030:
                _switchedOn = code == 1010;
                return;
            case 1040:
            case 1090:
                if (Temperature(line, out var nozzle)) AddEvent(new NozzleTemperatureEvent(nozzle, code == 1090, ToolOf(line)));
                return;
            case 1400:
            case 1900:
                if (Temperature(line, out var bed)) AddEvent(new BedTemperatureEvent(bed, code == 1900));
                return;
            case 1060:
            case 1070:
                Fan(line, code == 1060);
                return;
            case 1260:
            case 1270:
                AddEvent(new FanEvent(code == 1260 ? 1 : 0));
                return;
            case 2040:
                if ((line.TryGet('S', out var acceleration) || line.TryGet('P', out acceleration)) && acceleration is > 0 and < 1e9) AddEvent(new AccelerationEvent(acceleration));
                return;
            case 2000:
                Volumetric(line);
                return;
            case 2200:
                if (_rules.SpeedFactor && line.TryGet('S', out var percent) && percent is > 0 and < 1e6)
                {
                    _feedFactor = percent / 100;
                    _speed = _feed / 60 * _feedFactor;
                }
                return;
            case 2210:
                if (_rules.FlowFactor && line.TryGet('S', out var flow) && flow is > 0 and < 1e6) _flow = flow / 100;
                return;
            case 60:
                if (_rules.ToolByM6) ChangeTool(line.TryGet('T', out var tool) ? tool : double.IsNaN(_nextTool) ? _tool : _nextTool);
                return;
            case 4860:
                Object486(text, line);
                return;
            default:
                Ignored('M', line.Values[0]);
                return;
        }
    }

    private void SetM83(bool on)
    {
        if (_rules.RelativeE == RelativeERule.OnlyG90G91) return;
        _m83 = on;
        _lastRelative = on;
        Modes();
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
        if (line.TryGet('P', out var number) && number is not (0 or 1)) return;
        if (!line.TryGet('S', out var speed)) speed = on ? 255 : 0;
        if (!on) speed = 0;
        if (!(speed is >= 0 and < 1e6)) return;
        AddEvent(new FanEvent(_rules.Fan == FanScale.FractionOrByte && speed <= 1 ? speed : Math.Min(speed / 255, 1)));
    }

    private void Volumetric(ParsedLine line)
    {
        Features.M200++;
        if (!_rules.Volumetric) return;
        _volumetric = line.TryGet('D', out var diameter) ? diameter > 0 : !line.TryGet('S', out var on) || on > 0;
    }

    private void Macro(byte[] text, ParsedLine line)
    {
        var start = line.CodeStart;
        while (start < line.CodeEnd && text[start] <= ' ') start++;
        var end = start;
        while (end < line.CodeEnd && text[end] > ' ' && text[end] != '*') end++;
        var name = TextEncoding.Decode(text, start, Math.Min(end, start + 60)).ToUpperInvariant();
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
        if (_rules.SharedE || !name.StartsWith("extruder", StringComparison.Ordinal)) return;
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

    private void Ignored(char letter, double number) => Count(letter + NumberFormatter.Format(number is > -1e6 and < 1e6 ? number : 0, 1));

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

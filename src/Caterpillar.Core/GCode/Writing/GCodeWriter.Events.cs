using System;
using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Dialects;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Events, layers and tools.</summary>
public sealed partial class GCodeWriter
{
    private int _layers;

    private void Events(int move)
    {
        var events = _toolpath.Events;
        for (; _nextEvent < events.Count && events[_nextEvent].Move <= move; _nextEvent++)
        {
            var before = Lines;
            Event(events[_nextEvent].Event);
            Written?.Event(_nextEvent, before, Lines);
        }
    }

    private void Event(PrinterEvent what)
    {
        switch (what)
        {
            case NozzleTemperatureEvent nozzle:
                _out.Command((byte)'M', nozzle.Wait ? 109 : 104);
                if (nozzle.Tool is { } of) _out.Word((byte)'T', of, 0);
                _out.Word('S', nozzle.Celsius, 1);
                _out.EndLine();
                return;
            case BedTemperatureEvent bed:
                _out.Command((byte)'M', bed.Wait ? 190 : 140);
                _out.Word('S', bed.Celsius, 1);
                _out.EndLine();
                return;
            case FanEvent fan:
                Fan(Math.Min(Math.Max(fan.Speed, 0), 1));
                return;
            case ToolEvent tool:
                Tool(tool.Tool);
                return;
            case AccelerationEvent acceleration:
                _out.Command((byte)'M', 204);
                _out.Word('S', acceleration.Value, 0);
                _out.EndLine();
                return;
            case LimitEvent or FinishMovesEvent or ProgressEvent:
                foreach (var line in EventText.Lines(what, _rules)) _out.Line(line);
                return;
            case DwellEvent dwell:
                _out.Command((byte)'G', 4);
                if (_rules.DwellP == 1) _out.Word('P', dwell.Seconds, 3);
                else _out.Word('P', dwell.Seconds * 1000, 0);
                _out.EndLine();
                return;
            case PauseEvent pause:
                if (pause.Message.Length > 0) _out.Comment(" " + pause.Message);
                _out.Line(_rules.Pauses.Count > 0 ? _rules.Pauses[0] : "M0");
                return;
            case HomeEvent home:
                Home(home);
                return;
            case CommentEvent comment:
                _out.Comment(comment.Text.Length > 0 ? " " + comment.Text : "");
                return;
            case RawEvent raw:
                Raw([raw.Line]);
                return;
        }
    }

    private void Fan(double speed)
    {
        if (_rules.Fan == FanScale.None) return;
        if (_rules.ValveIsFan && _rules.Fan == FanScale.Switch)
        {
            _out.Command((byte)'M', speed > 0 ? 126 : 127);
            _out.EndLine();
            return;
        }
        if (_rules.Fan != FanScale.FractionOrByte && speed == 0)
        {
            _out.Command((byte)'M', 107);
            _out.EndLine();
            return;
        }
        _out.Command((byte)'M', 106);
        if (_rules.Fan == FanScale.FractionOrByte) _out.Word(_rules.FanLetter, speed, 3);
        else _out.Word(_rules.FanLetter, speed * 255, 0);
        _out.EndLine();
    }

    private void Home(HomeEvent home)
    {
        _out.Command((byte)'G', 28);
        if (!(home.X && home.Y && home.Z))
        {
            if (home.X) HomeAxis('X');
            if (home.Y) HomeAxis('Y');
            if (home.Z) HomeAxis('Z');
        }
        _out.EndLine();
        _homed = home;
        _positionKnown = false;
    }

    // Where G28 goes via a point, that point is the stored position itself.
    private void HomeAxis(char letter)
    {
        if (_rules.Homing == HomingRule.HomesToZero) _out.Bare(letter);
        else _out.Word((byte)letter, 0, 0);
    }

    private void Tool(int tool)
    {
        if (tool == _tool) return;
        var lines = _format.ToolLines?.Invoke(_tool, tool);
        CarryRest(tool);
        _tool = tool;
        if (lines is { Count: > 0 }) Raw(lines);
        else StateTool(tool);
        if (_rules.PositionOfE == PositionOfERule.Shared) return;
        if (!_sums.TryGetValue(tool, out var sum)) _sums.Add(tool, sum = new ExtruderSum());
        if (_rules.PositionOfE == PositionOfERule.ZeroAtChange)
        {
            sum.Exact -= NumberFormatter.FromUnits(sum.Written, _format.DecimalsE);
            sum.Written = 0;
        }
        _sum = sum;
    }

    // What rounding has left of E belongs to its tool, also where the tools share a position.
    private void CarryRest(int next)
    {
        if (_rules.PositionOfE != PositionOfERule.Shared) return;
        var written = NumberFormatter.FromUnits(_sum.Written, _format.DecimalsE);
        _rests[_tool] = _sum.Exact - written;
        _sum.Exact = _rests.TryGetValue(next, out var rest) ? written + rest : written;
    }

    private void StateTool(int tool)
    {
        if (_rules.ToolByM6)
        {
            _out.Command((byte)'M', 6);
            _out.Word((byte)'T', tool, 0);
        }
        else
        {
            _out.Command((byte)'T', tool);
        }
        _out.EndLine();
    }

    private void Layer(int number)
    {
        var before = _layer >= 0 ? _toolpath.Layers[_layer] : null;
        _layer = number;
        if (number < 0)
        {
            if (_format.Comments) Object("");
            return;
        }
        var layer = _toolpath.Layers[number];
        if (before is null || layer.Index != before.Index || layer.Z != before.Z)
        {
            if (_e != 0 && !_relative && Math.Abs(_sum.Written) > _largestSum) ResetE();
            if (_format.Comments)
            {
                _out.Comment("LAYER_CHANGE");
                _out.Comment("Z:" + NumberFormatter.Format(layer.Z, 4));
                if (layer.Thickness > 0) _out.Comment("HEIGHT:" + NumberFormatter.Format(layer.Thickness, 4));
            }
            if (_layers++ > 0 && _format.LayerLines?.Invoke(layer) is { Count: > 0 } lines) Raw(lines);
        }
        if (_format.Comments) Object(layer.Object);
    }

    private void Object(string name)
    {
        if (name == _object) return;
        if (_object.Length > 0) _out.Comment(" stop printing object " + _object);
        _object = name;
        if (name.Length > 0) _out.Comment(" printing object " + name);
    }
}

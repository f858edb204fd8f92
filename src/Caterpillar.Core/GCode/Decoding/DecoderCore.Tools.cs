using System;
using System.Collections.Generic;
using Caterpillar.Dialects;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Tools, and what each of them has pushed out and pulled back.</summary>
internal sealed partial class DecoderCore
{
    private readonly SortedDictionary<int, ToolState> _tools = [];
    private ToolState _state = new();
    private double _retracted;
    private double _run;
    private double _highest;
    private double _flow = 1;
    private double _nextTool = double.NaN;
    private int _highestTool;
    private bool _volumetric;

    /// <summary>E used by each tool that pushed or pulled: the highest value of its running sum.</summary>
    public IReadOnlyList<KeyValuePair<int, double>> UsedByTool()
    {
        StoreTool();
        var used = new List<KeyValuePair<int, double>>();
        foreach (var pair in _tools)
        {
            if (pair.Value.Touched) used.Add(new KeyValuePair<int, double>(pair.Key, pair.Value.Highest));
        }
        return used;
    }

    // dE > 0: what exceeds the retraction is deposited.
    private double Push(double e)
    {
        var tally = DecodeCounters;
        tally.EPositive += e;
        tally.ENet += e;
        _run += e;
        if (_run > _highest) _highest = _run;
        if (_retracted <= 0) return e * _flow;
        if (_retracted >= e)
        {
            _retracted -= e;
            if (_retracted < NoChange) _retracted = 0;
            return 0;
        }
        var rest = e - _retracted;
        _retracted = 0;
        return rest < NoChange ? 0 : rest * _flow;
    }

    private void Pull(double e)
    {
        DecodeCounters.ENegative -= e;
        DecodeCounters.ENet -= e;
        _run -= e;
        _retracted += e;
    }

    private void ChangeTool(double number)
    {
        if (!(number >= 0 && number < _rules.ToolLimit) || number != Math.Floor(number))
        {
            Ignored('T', number);
            return;
        }
        var tool = (int)number;
        if (tool == _tool) return;
        DecodeCounters.ToolChanges++;
        StoreTool();
        SelectTool(tool);
        if (_rules.PositionOfE == PositionOfERule.ZeroAtChange) _e = _shadowE = 0;
        if (_rules.FlowFactor == FlowFactorRule.UntilToolChange) _flow = 1;
        AddEvent(new ToolEvent(tool));
    }

    private void StoreTool()
    {
        _state.Retracted = _retracted;
        _state.Run = _run;
        _state.Touched |= _run != 0 || _highest != 0 || _retracted != 0;
        _state.Highest = _highest;
        _state.E = _e;
        _state.Flow = _flow;
    }

    private ToolState StateOf(int tool)
    {
        if (!_tools.TryGetValue(tool, out var state)) _tools.Add(tool, state = new ToolState());
        return state;
    }

    private void SelectTool(int tool)
    {
        var state = StateOf(tool);
        _state = state;
        _tool = tool;
        _highestTool = Math.Max(_highestTool, tool);
        _retracted = state.Retracted;
        _run = state.Run;
        _highest = state.Highest;
        if (_rules.PositionOfE == PositionOfERule.PerTool) _e = _shadowE = state.E;
        if (_rules.FlowFactor == FlowFactorRule.PerTool) _flow = state.Flow;
    }

    private sealed class ToolState
    {
        public double Retracted;
        public double Run;
        public double Highest;
        public double E;
        public double Flow = 1;
        public bool Touched;
    }
}

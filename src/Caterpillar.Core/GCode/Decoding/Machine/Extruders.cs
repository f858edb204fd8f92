namespace Caterpillar.GCode;

/// <summary>The extruders of the machine, with their extruded and retracted amounts.</summary>
internal sealed class Extruders(FlavorRules rules, InterpreterState state, DecodeCounters counters)
{
    private readonly SortedDictionary<int, Extruder> _byTool = [];
    private Extruder _current = new();

    /// <summary>Number of tools: the highest that was used, and those below it.</summary>
    public int Count { get; private set; } = 1;

    public bool IsRetracted => _current.Retracted > 0;

    /// <summary>The running sum of E of the current tool, and its maximum.</summary>
    public (double Sum, double Highest) Running
    {
        get => (_current.Sum, _current.Highest);
        set => (_current.Sum, _current.Highest) = value;
    }

    /// <summary>E used by each tool that moved filament: the maximum of its running sum.</summary>
    public IReadOnlyList<KeyValuePair<int, double>> UsedByTool()
    {
        Store();
        return [.. _byTool.Where(t => t.Value.WasUsed).Select(t => new KeyValuePair<int, double>(t.Key, t.Value.Highest))];
    }

    /// <summary>E rises. Returns the deposited amount: the part beyond the retraction.</summary>
    public double Push(double e)
    {
        var current = _current;
        counters.EPositive += e;
        counters.ENet += e;
        current.Sum += e;
        if (current.Sum > current.Highest) current.Highest = current.Sum;
        if (current.Retracted <= 0) return e * state.Extrusion.Flow;
        if (current.Retracted >= e)
        {
            current.Retracted -= e;
            if (current.Retracted < InterpreterState.NoChange) current.Retracted = 0;
            return 0;
        }
        var rest = e - current.Retracted;
        current.Retracted = 0;
        return rest < InterpreterState.NoChange ? 0 : rest * state.Extrusion.Flow;
    }

    /// <summary>E falls by a positive amount.</summary>
    public void Pull(double e)
    {
        counters.ENegative -= e;
        counters.ENet -= e;
        _current.Sum -= e;
        _current.Retracted += e;
    }

    /// <summary>Changes to another tool.</summary>
    public void Change(int tool)
    {
        Store();
        Select(tool);
        if (rules.PositionOfE == PositionOfERule.ZeroAtChange) state.Extrusion.SetE(0);
        if (rules.FlowFactor == FlowFactorRule.UntilToolChange) state.Extrusion.Flow = 1;
    }

    public void Select(int tool)
    {
        _current = Of(tool);
        state.Tool = tool;
        Count = Math.Max(Count, tool + 1);
        if (rules.PositionOfE == PositionOfERule.PerTool) state.Extrusion.SetE(_current.E);
        if (rules.FlowFactor == FlowFactorRule.PerTool) state.Extrusion.Flow = _current.Flow;
    }

    /// <summary>Sets the flow factor of a tool that is not the current one.</summary>
    public void SetFlow(int tool, Func<double, double> change)
    {
        var other = Of(tool);
        other.Flow = change(other.Flow);
    }

    /// <summary>The position of E of each tool. Empty if the tools share one.</summary>
    public KeyValuePair<int, double>[] Positions()
    {
        if (rules.PositionOfE != PositionOfERule.PerTool) return [];
        _current.E = state.Extrusion.E;
        return _byTool.Select(t => new KeyValuePair<int, double>(t.Key, t.Value.E)).ToArray();
    }

    public void Restore(KeyValuePair<int, double>[] positions, int tool)
    {
        foreach (var pair in positions) Of(pair.Key).E = pair.Value;
        if (tool != state.Tool) Select(tool);
    }

    private void Store()
    {
        _current.WasUsed |= _current.Sum != 0 || _current.Highest != 0 || _current.Retracted != 0;
        _current.E = state.Extrusion.E;
        _current.Flow = state.Extrusion.Flow;
    }

    private Extruder Of(int tool)
    {
        if (!_byTool.TryGetValue(tool, out var extruder)) _byTool.Add(tool, extruder = new Extruder());
        return extruder;
    }

    private sealed class Extruder
    {
        public double Retracted;
        public double Sum;
        public double Highest;
        public double E;
        public double Flow = 1;
        public bool WasUsed;
    }
}

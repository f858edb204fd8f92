namespace Caterpillar.Planning;

/// <summary>
/// Temperature, fan and acceleration: what the design set, what a path overrides, and the current values. Events are written only if these differ, so
/// that neighboring paths with the same overrides do not switch back and forth.
/// </summary>
internal sealed class OverrideState
{
    private readonly PlanRules _rules;
    private readonly MoveEmitter _emitter;
    private readonly bool _layered;

    // Set by the design for each tool; until then the rules give the usual values.
    private readonly double?[] _temperature;

    // Of each nozzle; null = never heated.
    private readonly double?[] _temperatureNow;
    private double? _fan, _fanNow;
    private double? _acceleration, _accelerationNow;
    private bool _overridden;

    public OverrideState(PlanRules rules, MoveEmitter emitter)
    {
        (_rules, _emitter) = (rules, emitter);
        _temperature = new double?[rules.Tools.Length];
        _temperatureNow = new double?[rules.Tools.Length];
        // The start code heats the first tool for the first layer and leaves the fan off.
        _temperatureNow[0] = Usual(0, 0);
        _fanNow = rules.AddsNothing ? rules.Tools[0].Fan : 0;
        _accelerationNow = rules.Acceleration;
        _layered = !rules.AddsNothing && rules.Tools.Any(t => t.Fan > 0 || (t.FanTime > 0 && t.MaxFan > 0) || t.FirstLayerNozzleTemperature is not null);
    }

    /// <summary>True if a value stayed overridden because its previous value is unknown.</summary>
    public bool CouldNotRevert { get; private set; }

    /// <summary>The design itself changed a setting: it becomes the value for paths without overrides.</summary>
    public void Note(PrinterEvent what)
    {
        switch (what)
        {
            case NozzleTemperatureEvent e when (e.Tool ?? _emitter.Tool) is var tool && tool < _temperature.Length:
                _temperature[tool] = _temperatureNow[Nozzle(tool)] = e.Celsius;
                break;
            case FanEvent e: _fan = _fanNow = e.Speed; break;
            case AccelerationEvent e: _acceleration = _accelerationNow = e.Value; break;
        }
    }

    /// <summary>Changes the tool: the last one cools down to its standby temperature, the new one is heated before it is used.</summary>
    /// <param name="tool">The new tool.</param>
    /// <param name="next">The path that it prints first; null = unknown.</param>
    public void SwitchTool(int tool, PrintPath? next)
    {
        var last = _emitter.Tool;
        if (_rules.Tools[last].StandbyTemperature is { } standby && standby < _temperatureNow[last]) Heat(last, standby, false);
        _emitter.SwitchTool(tool);
        if (Usual(tool, next is null ? -1 : LayerOf(next)) is { } celsius && celsius != _temperatureNow[Nozzle(tool)]) Heat(tool, celsius, true);
    }

    /// <summary>Turns off all nozzles but the current one, which the end code turns off.</summary>
    public void End()
    {
        for (var tool = 0; tool < _temperatureNow.Length && !_rules.SharedNozzle; tool++)
        {
            if (tool != _emitter.Tool && _temperatureNow[tool] > 0) Heat(tool, 0, false);
        }
    }

    /// <param name="path">The path that comes next.</param>
    /// <param name="layerTime">Time of its layer, s.</param>
    public void Apply(PrintPath path, double layerTime)
    {
        var wanted = path.Overrides;
        if (wanted is null && !_layered && !_overridden) return;
        _overridden = wanted is not null;
        var layer = _layered ? LayerOf(path) : 0;
        var usual = Usual(_emitter.Tool, layer);
        if (Differs(wanted?.NozzleTemperature, usual, ref _temperatureNow[Nozzle(_emitter.Tool)]) is { } celsius)
            _emitter.Event(new NozzleTemperatureEvent(celsius));
        usual = _fan ?? (layer >= 0 && layer < _emitter.ToolRules.FanOffLayers ? 0 : FanFor(layerTime));
        if (Differs(wanted?.Fan, usual, ref _fanNow) is { } fan) _emitter.Event(new FanEvent(fan));
        usual = _acceleration ?? _rules.Acceleration;
        if (Differs(wanted?.Acceleration, usual, ref _accelerationNow) is { } acceleration) _emitter.Event(new AccelerationEvent(acceleration));
    }

    private int Nozzle(int tool) => _rules.SharedNozzle ? 0 : tool;

    private double? Usual(int tool, int layer)
        => _temperature[tool] ?? (layer == 0 ? _rules.Tools[tool].FirstLayerNozzleTemperature : null) ?? _rules.Tools[tool].NozzleTemperature;

    private void Heat(int tool, double celsius, bool wait)
    {
        _temperatureNow[Nozzle(tool)] = celsius;
        _emitter.Event(new NozzleTemperatureEvent(celsius, wait, _rules.SharedNozzle ? null : tool));
    }

    // Quick layers get more of the fan, the quickest all of it.
    private double? FanFor(double layerTime)
    {
        var tool = _emitter.ToolRules;
        if (tool.Fan is not { } least || !(layerTime < tool.FanTime)) return tool.Fan;
        var share = layerTime <= _rules.MinLayerTime ? 1 : (tool.FanTime - layerTime) / (tool.FanTime - _rules.MinLayerTime);
        return Math.Round((least + (tool.MaxFan - least) * share) * 100) / 100;
    }

    // A path without a layer counts by its highest point: a helix that starts on the bed does not belong to the first layer.
    private int LayerOf(PrintPath path)
    {
        if (path.Layer is { } layer) return layer.Index;
        var top = double.NegativeInfinity;
        foreach (var p in path.RawPoints) top = Math.Max(top, p.Z);
        return _rules.LayerOf(path, top);
    }

    private double? Differs(double? wanted, double? usual, ref double? now)
    {
        var value = wanted ?? usual;
        if (value is null)
        {
            CouldNotRevert |= now is not null;
            return null;
        }
        if (value == now) return null;
        now = value;
        return value;
    }
}

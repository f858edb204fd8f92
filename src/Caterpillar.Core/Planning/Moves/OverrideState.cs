namespace Caterpillar.Planning;

/// <summary>
/// Temperature, fan and acceleration: what the design set, what a path overrides, and the current values. Events are written only if these differ, so
/// that neighboring paths with the same overrides do not switch back and forth.
/// </summary>
internal sealed class OverrideState(PlanRules rules, MoveEmitter emitter)
{
    // Set by the design, for each tool; until then the rules give the usual values.
    private readonly double?[] _temperature = new double?[rules.Tools.Length];

    // Of each nozzle; null = never heated. The start code heats the first one for the first layer and leaves the fan off.
    private readonly double?[] _temperatureNow = [rules.Tools[0].Temperature(isFirstLayer: true), .. new double?[rules.Tools.Length - 1]];

    private double? _fan, _fanNow = rules.AddsNothing ? LeastFan(rules.Tools[0]) : 0;
    private double? _bed, _bedNow = rules.FirstLayerBedTemperature ?? rules.BedTemperature;

    // What the firmware has is not known exactly: accelerations and jerk that are commanded at all are so from the first path on.
    private double? _acceleration, _accelerationNow = rules.Motion?.MostAcceleration is null ? rules.Printer.PrintAcceleration : null;
    private double? _travelNow, _jerkNow;

    private readonly bool _layered = !rules.AddsNothing
        && (rules.FirstLayerBedTemperature is not null || rules.Motion is not null
            || rules.Tools.Any(t => t.Material is { MinFanSpeedPercent: > 0 } or { FanLayerTime: > 0, MaxFanSpeedPercent: > 0 }
                or { FirstLayerNozzleTemperature: > 0 }));
    private bool _overridden;

    /// <summary>True if a value stayed overridden because its previous value is unknown.</summary>
    public bool CouldNotRevert { get; private set; }

    /// <summary>The design itself changed a setting: it becomes the value for paths without overrides.</summary>
    public void Note(PrinterEvent what)
    {
        switch (what)
        {
            case NozzleTemperatureEvent e when (e.Tool ?? emitter.Tool) is var tool && tool < _temperature.Length:
                _temperature[tool] = _temperatureNow[Nozzle(tool)] = e.Celsius;
                break;
            case BedTemperatureEvent e: _bed = _bedNow = e.Celsius; break;
            case FanEvent e: _fan = _fanNow = e.Speed; break;
            case AccelerationEvent e: (_acceleration, _accelerationNow, _travelNow) = (e.Value, e.Value, null); break;
        }
    }

    /// <summary>Changes the tool: the last one cools down to its standby temperature, the new one is heated before it is used.</summary>
    public void SwitchTool(int tool, PrintPath? next)
    {
        var last = emitter.Tool;
        if (!rules.Printer.SharedNozzle && rules.Tools[last].Material?.StandbyTemperature is > 0 and var standby && standby < _temperatureNow[last])
            Heat(last, standby, false);
        emitter.SwitchTool(tool);
        if (Usual(tool, next is null ? -1 : LayerOf(next)) is { } celsius && celsius != _temperatureNow[Nozzle(tool)]) Heat(tool, celsius, true);
    }

    /// <summary>Turns off all nozzles but the current one, which the end code turns off.</summary>
    public void End()
    {
        for (var tool = 0; tool < _temperatureNow.Length && !rules.Printer.SharedNozzle; tool++)
        {
            if (tool != emitter.Tool && _temperatureNow[tool] > 0) Heat(tool, 0, false);
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
        var usual = Usual(emitter.Tool, layer);
        if (Differs(wanted?.NozzleTemperature, usual, ref _temperatureNow[Nozzle(emitter.Tool)]) is { } celsius)
            emitter.Event(new NozzleTemperatureEvent(celsius));
        usual = _bed ?? (layer == 0 ? rules.FirstLayerBedTemperature : null) ?? rules.BedTemperature;
        if (rules.FirstLayerBedTemperature is not null && Differs(null, usual, ref _bedNow) is { } bed) emitter.Event(new BedTemperatureEvent(bed));
        usual = _fan ?? (layer >= 0 && layer < emitter.ToolRules.Material?.FanOffLayers ? 0 : FanFor(layerTime));
        if (Differs(wanted?.Fan, usual, ref _fanNow) is { } fan) emitter.Event(new FanEvent(fan));
        usual = _acceleration ?? rules.Motion?.Acceleration(path.Role, layer == 0) ?? rules.Printer.PrintAcceleration;
        if (Differs(wanted?.Acceleration, usual, ref _accelerationNow) is { } acceleration)
            emitter.Event(IsSeparate ? new LimitEvent(MotionLimit.PrintAcceleration, acceleration) : new AccelerationEvent(acceleration));
        Jerk(rules.Motion?.Jerk(path.Role, layer == 0));
    }

    /// <summary>Sets what travel moves have of their own. A design that sets the acceleration sets that of travel moves, too.</summary>
    public void Travel()
    {
        Jerk(rules.Motion?.TravelJerk);
        if (_acceleration is not null || rules.Motion?.TravelAcceleration is not { } travel) return;
        if (IsSeparate && Differs(null, travel, ref _travelNow) is not null) emitter.Event(new LimitEvent(MotionLimit.TravelAcceleration, travel));
        else if (!IsSeparate && Differs(null, travel, ref _accelerationNow) is not null) emitter.Event(new AccelerationEvent(travel));
    }

    private bool IsSeparate => rules.Printer.Flavor.SeparateAccelerations && rules.Motion?.MostAcceleration is not null;

    private void Jerk(double? value)
    {
        if (value is not null && Differs(null, value, ref _jerkNow) is { } jerk) emitter.Event(new LimitEvent(rules.Motion!.JerkLimit!.Value, jerk));
    }

    private int Nozzle(int tool) => rules.Printer.SharedNozzle ? 0 : tool;

    private double? Usual(int tool, int layer) => _temperature[tool] ?? rules.Tools[tool].Temperature(layer == 0);

    private static double? LeastFan(ToolRules tool) => tool.Material?.MinFanSpeedPercent / 100;

    private void Heat(int tool, double celsius, bool wait)
    {
        _temperatureNow[Nozzle(tool)] = celsius;
        emitter.Event(new NozzleTemperatureEvent(celsius, wait, rules.Printer.SharedNozzle ? null : tool));
    }

    // Quick layers get more of the fan, the quickest all of it.
    private double? FanFor(double layerTime)
    {
        var material = emitter.ToolRules.Material;
        if (LeastFan(emitter.ToolRules) is not { } least || !(layerTime < material!.FanLayerTime)) return LeastFan(emitter.ToolRules);
        var most = Math.Max(least, material.MaxFanSpeedPercent / 100);
        var share = layerTime <= rules.Settings.MinLayerTime ? 1 : (material.FanLayerTime - layerTime) / (material.FanLayerTime - rules.Settings.MinLayerTime);
        return Math.Round((least + (most - least) * share) * 100) / 100;
    }

    // A path without a layer counts by its highest point: a helix that starts on the bed does not belong to the first layer.
    private int LayerOf(PrintPath path)
    {
        if (path.Layer is { } layer) return layer.Index;
        var top = double.NegativeInfinity;
        foreach (var p in path.RawPoints) top = Math.Max(top, p.Z);
        return rules.LayerOf(path, top);
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

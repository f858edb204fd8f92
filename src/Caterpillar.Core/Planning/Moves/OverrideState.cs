namespace Caterpillar.Planning;

/// <summary>
/// Temperature, fan and acceleration: what the design set, what a path overrides, and the current values. Events are written only if these differ, so
/// that neighboring paths with the same overrides do not switch back and forth.
/// </summary>
internal sealed class OverrideState(PlanRules rules, MoveEmitter emitter)
{
    // Set by the design; until then the rules give the usual values. The start code heats for the first layer and leaves the fan off.
    private double? _temperature, _temperatureNow = rules.FirstLayerNozzleTemperature ?? rules.NozzleTemperature;
    private double? _fan, _fanNow = rules.AddsNothing ? rules.Fan : 0;
    private double? _bed, _bedNow = rules.FirstLayerBedTemperature ?? rules.BedTemperature;

    // What the firmware has is not known exactly: accelerations and jerk that are commanded at all are so from the first path on.
    private double? _acceleration, _accelerationNow = rules.Motion is { HasAcceleration: true } ? null : rules.Acceleration;
    private double? _travelNow, _jerkNow;

    private readonly bool _layered = !rules.AddsNothing
        && (rules.Fan > 0 || (rules.FanTime > 0 && rules.MaxFan > 0) || rules.FirstLayerNozzleTemperature is not null
            || rules.FirstLayerBedTemperature is not null || rules.Motion is not null);
    private bool _overridden;

    /// <summary>True if a value stayed overridden because its previous value is unknown.</summary>
    public bool CouldNotRevert { get; private set; }

    /// <summary>The design itself changed a setting: it becomes the value for paths without overrides.</summary>
    public void Note(PrinterEvent what)
    {
        switch (what)
        {
            case NozzleTemperatureEvent { Tool: null } e: _temperature = _temperatureNow = e.Celsius; break;
            case BedTemperatureEvent e: _bed = _bedNow = e.Celsius; break;
            case FanEvent e: _fan = _fanNow = e.Speed; break;
            case AccelerationEvent e: (_acceleration, _accelerationNow, _travelNow) = (e.Value, e.Value, null); break;
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
        var usual = _temperature ?? (layer == 0 ? rules.FirstLayerNozzleTemperature : null) ?? rules.NozzleTemperature;
        if (Differs(wanted?.NozzleTemperature, usual, ref _temperatureNow) is { } celsius) emitter.Event(new NozzleTemperatureEvent(celsius));
        usual = _bed ?? (layer == 0 ? rules.FirstLayerBedTemperature : null) ?? rules.BedTemperature;
        if (rules.FirstLayerBedTemperature is not null && Differs(null, usual, ref _bedNow) is { } bed) emitter.Event(new BedTemperatureEvent(bed));
        usual = _fan ?? (layer >= 0 && layer < rules.FanOffLayers ? 0 : FanFor(layerTime));
        if (Differs(wanted?.Fan, usual, ref _fanNow) is { } fan) emitter.Event(new FanEvent(fan));
        usual = _acceleration ?? (rules.Motion is { HasAcceleration: true } motion ? motion.Acceleration(path.Role, layer == 0) : rules.Acceleration);
        if (Differs(wanted?.Acceleration, usual, ref _accelerationNow) is { } acceleration)
            emitter.Event(IsSeparate ? new LimitEvent(MotionLimit.PrintAcceleration, acceleration) : new AccelerationEvent(acceleration));
        if (rules.Motion is { JerkLimit: not null } corners) Jerk(corners.Jerk(path.Role, layer == 0));
    }

    /// <summary>Sets what travel moves have of their own. A design that sets the acceleration sets that of travel moves, too.</summary>
    public void Travel()
    {
        if (rules.Motion?.TravelJerk is { } jerk) Jerk(jerk);
        if (_acceleration is not null || rules.Motion?.TravelAcceleration is not { } travel) return;
        if (!IsSeparate && Differs(null, travel, ref _accelerationNow) is not null) emitter.Event(new AccelerationEvent(travel));
        else if (IsSeparate && Differs(null, travel, ref _travelNow) is not null) emitter.Event(new LimitEvent(MotionLimit.TravelAcceleration, travel));
    }

    private bool IsSeparate => rules.SeparateAccelerations && rules.Motion is { HasAcceleration: true };

    private void Jerk(double value)
    {
        if (Differs(null, value, ref _jerkNow) is { } jerk) emitter.Event(new LimitEvent(rules.Motion!.JerkLimit!.Value, jerk));
    }

    // Quick layers get more of the fan, the quickest all of it.
    private double? FanFor(double layerTime)
    {
        if (rules.Fan is not { } least || !(layerTime < rules.FanTime)) return rules.Fan;
        var share = layerTime <= rules.MinLayerTime ? 1 : (rules.FanTime - layerTime) / (rules.FanTime - rules.MinLayerTime);
        return Math.Round((least + (rules.MaxFan - least) * share) * 100) / 100;
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

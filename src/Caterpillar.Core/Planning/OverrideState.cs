using Caterpillar.Toolpaths;

namespace Caterpillar.Planning;

/// <summary>
/// Temperature, fan and acceleration: what the design set, what a path wants for itself, and what is in force. Events are written only where these differ, so that neighbouring
/// paths with the same overrides do not switch to and fro.
/// </summary>
internal sealed class OverrideState(PlanRules rules, MoveEmitter emitter)
{
    private double? _temperature = rules.NozzleTemperature, _temperatureNow = rules.NozzleTemperature;
    private double? _fan = rules.Fan, _fanNow = rules.Fan;
    private double? _acceleration = rules.Acceleration, _accelerationNow = rules.Acceleration;

    /// <summary>True when something stayed overridden because nobody said what it was before.</summary>
    public bool CouldNotRevert { get; private set; }

    /// <summary>The design itself changed a setting: it becomes what paths without overrides use.</summary>
    public void Note(PrinterEvent what)
    {
        switch (what)
        {
            case NozzleTemperatureEvent { Tool: null } e: _temperature = _temperatureNow = e.Celsius; break;
            case FanEvent e: _fan = _fanNow = e.Speed; break;
            case AccelerationEvent e: _acceleration = _accelerationNow = e.Value; break;
        }
    }

    public void Apply(PathOverrides? wanted)
    {
        if (Differs(wanted?.NozzleTemperature, _temperature, ref _temperatureNow) is { } celsius) emitter.Event(new NozzleTemperatureEvent(celsius));
        if (Differs(wanted?.Fan, _fan, ref _fanNow) is { } fan) emitter.Event(new FanEvent(fan));
        if (Differs(wanted?.Acceleration, _acceleration, ref _accelerationNow) is { } acceleration) emitter.Event(new AccelerationEvent(acceleration));
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

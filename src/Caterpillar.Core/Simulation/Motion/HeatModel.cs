namespace Caterpillar.Simulation;

/// <summary>
/// Temperature of a heater over time: it moves towards what was set last at a constant rate, up as down, and stays there. With a rate of 0 it is there at once.
/// </summary>
internal sealed class HeaterCurve(double rate)
{
    private readonly List<(double Time, double From, double To)> _changes = [];

    /// <summary>°C per second.</summary>
    public double Rate => rate;

    /// <summary>Sets another temperature from a time on, in seconds; times ascend.</summary>
    public void Set(double time, double celsius)
        => _changes.Add((time, At(time), Math.Max(celsius, HeatModel.Ambient)));

    /// <summary>Seconds from the last <see cref="Set"/> until it is as hot, at a rate that is not 0; nothing waits for cooling.</summary>
    public double TimeTo(double celsius) => Math.Max(celsius - _changes[_changes.Count - 1].From, 0) / rate;

    /// <summary>°C at a time.</summary>
    public double At(double time)
    {
        var i = Last(time);
        if (i < 0) return HeatModel.Ambient;
        var (start, from, to) = _changes[i];
        var most = rate * (time - start);
        return rate == 0 || Math.Abs(to - from) <= most ? to : from + Math.Sign(to - from) * most;
    }

    /// <summary>°C that were set last before a time; 0 = off or never set.</summary>
    public double TargetAt(double time)
    {
        var i = Last(time);
        return i < 0 || _changes[i].To == HeatModel.Ambient ? 0 : _changes[i].To;
    }

    private int Last(double time) => Search.First(0, _changes.Count, (_changes, time), static (s, i) => s._changes[i].Time > s.time) - 1;
}

/// <summary>The heaters of a machine.</summary>
internal sealed class HeatModel(Printer printer)
{
    /// <summary>°C of everything that is off.</summary>
    public const double Ambient = 20;

    private readonly SortedDictionary<int, HeaterCurve> _nozzles = [];
    private readonly List<(HeaterCurve Heater, int Trapezoid, double Celsius)> _open = [];

    public HeaterCurve Bed { get; } = new(printer.BedHeating);

    /// <summary>The nozzle of a tool.</summary>
    public HeaterCurve Nozzle(int tool)
    {
        if (printer.SharedNozzle) tool = 0;
        if (!_nozzles.TryGetValue(tool, out var curve)) _nozzles.Add(tool, curve = new HeaterCurve(printer.NozzleHeating));
        return curve;
    }

    /// <summary>The nozzle of a tool, or null if it was never set.</summary>
    public HeaterCurve? NozzleOrNull(int tool) => _nozzles.TryGetValue(printer.SharedNozzle ? 0 : tool, out var curve) ? curve : null;

    /// <summary>Sets a heater when the trapezoids before one are over.</summary>
    public void Set(HeaterCurve heater, int trapezoid, double celsius) => _open.Add((heater, trapezoid, celsius));

    /// <summary>What was set happens at the times that are known by now.</summary>
    public void Settle(MotionColumns motion)
    {
        var known = _open.TakeWhile(o => o.Trapezoid <= motion.Count).ToArray();
        foreach (var (heater, trapezoid, celsius) in known) heater.Set(motion.StartTime(trapezoid), celsius);
        _open.RemoveRange(0, known.Length);
    }
}

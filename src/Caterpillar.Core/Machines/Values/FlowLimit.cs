namespace Caterpillar.Machines;

/// <summary>The most that a material flows at a temperature.</summary>
/// <param name="Temperature">Of the nozzle, °C.</param>
/// <param name="Flow">mm³/s.</param>
public readonly record struct FlowLimit(double Temperature, double Flow)
{
    /// <summary>The flow at any temperature: on the line between the limits around it, or that of the nearest limit.</summary>
    internal static double At(ValueList<FlowLimit> limits, double temperature)
    {
        var above = 0;
        while (above < limits.Count && limits[above].Temperature < temperature) above++;
        if (above == 0 || above == limits.Count) return limits[Math.Max(0, above - 1)].Flow;
        var (low, high) = (limits[above - 1], limits[above]);
        return low.Flow + (high.Flow - low.Flow) * (temperature - low.Temperature) / (high.Temperature - low.Temperature);
    }

    internal static string? Problem(ValueList<FlowLimit> limits)
        => limits.Zip(limits.Skip(1), (a, b) => a.Temperature < b.Temperature).All(ascends => ascends) ? null : "must have ascending temperatures";
}

namespace Caterpillar.Toolpaths;

/// <summary>Settings of the machine for one path only; null keeps the current value.</summary>
/// <param name="NozzleTemperature">°C.</param>
/// <param name="Fan">0 to 1.</param>
/// <param name="Acceleration">mm/s².</param>
public sealed record PathOverrides(double? NozzleTemperature = null, double? Fan = null, double? Acceleration = null);

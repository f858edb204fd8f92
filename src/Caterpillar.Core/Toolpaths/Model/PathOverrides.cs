namespace Caterpillar.Toolpaths;

/// <summary>Settings of the machine that hold for one path only; null keeps what is in force.</summary>
/// <param name="NozzleTemperature">°C.</param>
/// <param name="Fan">0 to 1.</param>
/// <param name="Acceleration">mm/s².</param>
public sealed record PathOverrides(double? NozzleTemperature = null, double? Fan = null, double? Acceleration = null);

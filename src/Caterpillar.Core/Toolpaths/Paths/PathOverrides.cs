namespace Caterpillar.Toolpaths;

/// <summary>Machine settings for one path. Null = no change.</summary>
/// <param name="NozzleTemperature">Nozzle temperature, °C.</param>
/// <param name="Fan">Fan speed, 0 to 1.</param>
/// <param name="Acceleration">Acceleration, mm/s².</param>
public sealed record PathOverrides(double? NozzleTemperature = null, double? Fan = null, double? Acceleration = null);

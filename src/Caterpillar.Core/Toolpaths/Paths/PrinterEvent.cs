namespace Caterpillar.Toolpaths;

/// <summary>An action of the machine other than a move. It happens at its position in the order of steps or moves.</summary>
public abstract record PrinterEvent;

/// <summary>Nozzle temperature of a tool in °C (0 = off). With <paramref name="Wait"/>, the machine waits for it (M104, M109).</summary>
public sealed record NozzleTemperatureEvent(double Celsius, bool Wait = false, int? Tool = null) : PrinterEvent;

/// <summary>Bed temperature in °C (0 = off). With <paramref name="Wait"/>, the machine waits for it (M140, M190).</summary>
public sealed record BedTemperatureEvent(double Celsius, bool Wait = false) : PrinterEvent;

/// <summary>Chamber temperature in °C (0 = off). With <paramref name="Wait"/>, the machine waits for it (M141, M191).</summary>
internal sealed record ChamberTemperatureEvent(double Celsius, bool Wait = false) : PrinterEvent;

/// <summary>Pressure advance of a tool in seconds (M900, M572, SET_PRESSURE_ADVANCE).</summary>
internal sealed record PressureAdvanceEvent(double Seconds, int Tool = 0) : PrinterEvent;

/// <summary>Speed of the part cooling fan, 0 to 1 (M106, M107).</summary>
public sealed record FanEvent(double Speed) : PrinterEvent;

/// <summary>Tool change (T).</summary>
public sealed record ToolEvent(int Tool) : PrinterEvent;

/// <summary>Acceleration of the following printing and travel moves, mm/s² (M204 S).</summary>
public sealed record AccelerationEvent(double Value) : PrinterEvent;

/// <summary>Homing (G28). If it moves the head, the event belongs to a travel move to the home position.</summary>
public sealed record HomeEvent(bool X = true, bool Y = true, bool Z = true) : PrinterEvent;

/// <summary>Dwell in seconds (G4).</summary>
public sealed record DwellEvent(double Seconds) : PrinterEvent;

/// <summary>Pause until the user continues (M0 or the pause command of the flavor).</summary>
public sealed record PauseEvent(string Message = "") : PrinterEvent;

/// <summary>A comment line. Line ends in the text become spaces.</summary>
public sealed record CommentEvent(string Text) : PrinterEvent;

/// <summary>A line of G-code, written unchanged.</summary>
public sealed record RawEvent(string Line) : PrinterEvent;

/// <summary>
/// Extrusion (positive) or retraction (negative) in place, mm³, at a speed of E. Planning deretracts before a dot, so that the whole volume is deposited.
/// </summary>
public sealed record ExtrudeEvent(double Volume, double Speed = 0, bool IsDot = false) : PrinterEvent;

/// <summary>The machine finishes all moves before it continues (M400).</summary>
internal sealed record FinishMovesEvent : PrinterEvent;

/// <summary>Motion limit for the following moves (M201, M203, M204, M205, M566, SET_VELOCITY_LIMIT), in mm/s, mm/s² or mm.</summary>
internal sealed record LimitEvent(MotionLimit Limit, double Value) : PrinterEvent;

/// <summary>Sets the firmware retraction. Null = unchanged.</summary>
/// <param name="Length">What is retracted, mm.</param>
/// <param name="Speed">Its speed, mm/s.</param>
/// <param name="Extra">What is extruded in addition to it afterwards, mm.</param>
/// <param name="Back">The speed of that, mm/s.</param>
internal sealed record RetractionEvent(double? Length, double? Speed, double? Extra, double? Back) : PrinterEvent;

/// <summary>Progress on the display of the machine: percent and remaining minutes (M73).</summary>
internal sealed record ProgressEvent(int Percent, int MinutesLeft) : PrinterEvent;

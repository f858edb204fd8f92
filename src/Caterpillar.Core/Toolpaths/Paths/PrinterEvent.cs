namespace Caterpillar.Toolpaths;

/// <summary>Something the machine does other than moving. It happens at its position in the order of steps or moves.</summary>
public abstract record PrinterEvent;

/// <summary>Nozzle temperature in °C (0 = off) of a tool; with <paramref name="Wait"/> the machine waits until it is reached (M104, M109).</summary>
public sealed record NozzleTemperatureEvent(double Celsius, bool Wait = false, int? Tool = null) : PrinterEvent;

/// <summary>Bed temperature in °C (0 = off); with <paramref name="Wait"/> the machine waits until it is reached (M140, M190).</summary>
public sealed record BedTemperatureEvent(double Celsius, bool Wait = false) : PrinterEvent;

/// <summary>Part cooling fan, 0 to 1 (M106, M107).</summary>
public sealed record FanEvent(double Speed) : PrinterEvent;

/// <summary>Changes the tool (T).</summary>
public sealed record ToolEvent(int Tool) : PrinterEvent;

/// <summary>Acceleration of printing and travelling in mm/s² from here on (M204 S).</summary>
public sealed record AccelerationEvent(double Value) : PrinterEvent;

/// <summary>Homing (G28). If that moves the head, the event is attached to a travel to the home position.</summary>
public sealed record HomeEvent(bool X = true, bool Y = true, bool Z = true) : PrinterEvent;

/// <summary>The machine waits for a time in seconds (G4).</summary>
public sealed record DwellEvent(double Seconds) : PrinterEvent;

/// <summary>The machine waits for its user (M0 or the equivalent of the flavor).</summary>
public sealed record PauseEvent(string Message = "") : PrinterEvent;

/// <summary>A comment line. Line ends in the text become spaces.</summary>
public sealed record CommentEvent(string Text) : PrinterEvent;

/// <summary>A line written as it is.</summary>
public sealed record RawEvent(string Line) : PrinterEvent;

/// <summary>
/// Material extruded (positive) or retracted (negative) in place, in mm³; the speed is that of E. A dot is deposited whole: planning restores what it has
/// retracted first.
/// </summary>
public sealed record ExtrudeEvent(double Volume, double Speed = 0, bool IsDot = false) : PrinterEvent;

/// <summary>The machine ends all its moves before it goes on (M400).</summary>
internal sealed record FinishMovesEvent : PrinterEvent;

/// <summary>Another limit of the motion from here on (M201, M203, M204, M205, M566, SET_VELOCITY_LIMIT), in mm/s, mm/s² or mm.</summary>
internal sealed record LimitEvent(MotionLimit Limit, double Value) : PrinterEvent;

/// <summary>Progress for the display of the machine: percent of the time, and minutes left (M73).</summary>
internal sealed record ProgressEvent(int Percent, int MinutesLeft) : PrinterEvent;

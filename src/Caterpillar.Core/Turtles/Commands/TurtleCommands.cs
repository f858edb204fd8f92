namespace Caterpillar.Turtles;

/// <summary>One command of the language: its names and values.</summary>
/// <param name="Action">Its action.</param>
/// <param name="Name">Its name in scripts.</param>
/// <param name="Aliases">Other names, mostly of the libraries of the papers.</param>
/// <param name="Values">Names of its numbers. Names in brackets are optional.</param>
/// <param name="Text">Name of its text, or null. In brackets if it is optional.</param>
/// <param name="Help">One sentence.</param>
internal sealed record TurtleCommandInfo(
    TurtleAction Action, string Name, IReadOnlyList<string> Aliases, IReadOnlyList<string> Values, string? Text, string Help)
{
    /// <summary>Number of required numbers.</summary>
    public int Required { get; } = Values.Count(v => !v.StartsWith("[", StringComparison.Ordinal));

    /// <summary>True if its first three numbers are coordinates that <c>keep</c> can leave unchanged.</summary>
    public bool MayKeep => Action is TurtleAction.Position or TurtleAction.Jump;

    /// <summary>For example <c>forward distance [rise]</c>.</summary>
    public string Usage => string.Join(" ",
        new[] { Name }.Concat(Values).Concat(Text is null ? []
        : [Text.StartsWith("[", StringComparison.Ordinal) ? "[\"" + Text.Trim('[', ']') + "\"]" : "\"" + Text + "\""]));

    public override string ToString() => Usage;
}

/// <summary>All commands of turtle programs.</summary>
internal static class TurtleCommands
{
    /// <summary>The commands in the order of the manual.</summary>
    public static IReadOnlyList<TurtleCommandInfo> All { get; } =
    [
        Of(TurtleAction.Start, "start", "setup", "x y [z]", "Set the starting point (mm). Only before the first move."),
        Of(TurtleAction.Forward, "forward", "fd", "distance [rise]",
            "Move forward (mm). With a rise, move level by the distance and along world Z by the rise (Kanada)."),
        Of(TurtleAction.Backward, "backward", "back bk", "distance", "Move backward without turning (mm). Prints like forward."),
        Of(TurtleAction.Move, "move", "", "distance", "Move forward (mm) without printing."),
        Of(TurtleAction.ForwardLift, "forward_lift", "", "distance height", "Move forward and up (mm) in one straight move."),
        Of(TurtleAction.Lift, "lift", "", "height", "Move along the turtle's up axis (mm) without printing."),
        Of(TurtleAction.LiftWorld, "lift_world", "", "height", "Move along world Z (mm) without printing."),
        Of(TurtleAction.Yaw, "yaw", "left lt", "angle", "Turn left."),
        Of(TurtleAction.Right, "right", "rt", "angle", "Turn right."),
        Of(TurtleAction.Pitch, "pitch", "pitch_up", "angle", "Raise the nose."),
        Of(TurtleAction.PitchDown, "pitch_down", "", "angle", "Lower the nose."),
        Of(TurtleAction.Roll, "roll", "roll_right", "angle", "Raise the left side."),
        Of(TurtleAction.RollLeft, "roll_left", "", "angle", "Lower the left side."),
        Of(TurtleAction.TurnAround, "turn_around", "", "", "Turn around (half a turn)."),
        Of(TurtleAction.Heading, "heading", "set_heading set_angle", "yaw [pitch] [roll]", "Set the heading: yaw, pitch and roll from the world axes."),
        Of(TurtleAction.ChangeHeading, "change_heading", "", "yaw [pitch] [roll]", "Add to the three angles of the heading."),
        Of(TurtleAction.Face, "face", "set_heading_point", "x y z", "Face a point (mm) with the wings level."),
        Of(TurtleAction.Level, "level", "", "", "Level the wings."),
        Of(TurtleAction.Position, "position", "goto set_position", "x y [z]",
            "Move straight to a point (mm). Prints if the pen is down. 'keep' leaves a coordinate unchanged."),
        Of(TurtleAction.Jump, "jump", "set_turtle", "x y [z] [azimuth]",
            "Move straight to a point (mm) without printing. An azimuth sets the heading there, with the wings level."),
        Of(TurtleAction.Arc, "arc", "", "radius angle [climb] [segments]", "Draw an arc (mm). Positive angles turn left. The arc can climb."),
        Of(TurtleAction.Circle, "circle", "", "radius [segments]", "Draw an exactly closed circle (mm) with its center on the left."),
        Of(TurtleAction.CircleAround, "circle_around", "", "radius [segments]", "Draw a circle (mm) around the turtle and return."),
        Of(TurtleAction.Polygon, "polygon", "", "sides side", "Draw an exactly closed regular polygon (side in mm). A negative side turns right."),
        Of(TurtleAction.CircleTrace, "circle_trace", "", "radius [strings]", "Print a circle of strings (mm) around the turtle. Traces do not move it."),
        Of(TurtleAction.SpiralTrace, "spiral_trace", "", "radius pitch [strings]", "Print a flat spiral (mm) from the turtle outward. strings: per turn."),
        Of(TurtleAction.HelixTrace, "helix_trace", "", "radius height pitch [strings] [ramp]",
            "Print a hollow cylinder (mm) without layers around the turtle. ramp: flow at both ends, 0 to 1."),
        Of(TurtleAction.ConeTrace, "cone_trace", "", "bottom_radius top_radius height pitch [strings] [ramp]", "Print a hollow cone (mm) as a helix."),
        Of(TurtleAction.CylinderTrace, "cylinder_trace", "", "radius height vertical_pitch horizontal_pitch [strings]",
            "Print a filled cylinder (mm) of flat spirals, alternately outward and inward."),
        Of(TurtleAction.SkirtTrace, "skirt_trace", "", "radius [loops] [pitch]", "Print rings (mm) around the turtle, outside in, to prime the nozzle."),
        Of(TurtleAction.Push, "push", "", "", "Save the whole state."),
        Of(TurtleAction.Pop, "pop", "", "", "Return to the last saved state on a path that planning finds."),
        Of(TurtleAction.PenUp, "penup", "pen_up pu", "", "Raise the pen. The following moves do not print."),
        Of(TurtleAction.PenDown, "pendown", "pen_down pd", "", "Lower the pen. The following moves print."),
        Of(TurtleAction.Density, "density", "set_density extrude_rate set_extrude_rate", "filament", "Extrusion in mm of filament per mm of path."),
        Of(TurtleAction.Area, "area", "cross_section set_cross_section", "area [height]", "Cross-section of the extrusion in mm², and its height in mm."),
        Of(TurtleAction.Bead, "bead", "", "width height [flow]", "Width and height of the extrusion in mm, and its flow ratio."),
        Of(TurtleAction.Rate, "rate", "feedrate set_feedrate", "speed", "Print speed in mm/min."),
        Of(TurtleAction.Speed, "speed", "set_velocity", "speed", "Print speed in mm/s."),
        Of(TurtleAction.TravelRate, "travel_rate", "", "speed", "Travel speed in mm/min; 0 = print speed."),
        Of(TurtleAction.TravelSpeed, "travel_speed", "", "speed", "Travel speed in mm/s; 0 = print speed."),
        Of(TurtleAction.Extrude, "extrude", "", "filament", "Extrude mm of filament in place. Negative values retract."),
        Of(TurtleAction.Dwell, "dwell", "", "time", "Wait for a time in milliseconds."),
        Of(TurtleAction.Pause, "pause", "pause_and_wait", "", "[message]", "Wait for the user."),
        Of(TurtleAction.NozzleTemperature, "hotend", "extruder_temp nozzle_temp set_extruder_temp", "temperature", "Heat the nozzle (°C) and wait; 0 = off."),
        Of(TurtleAction.SetNozzleTemperature, "hotend_nowait", "", "temperature", "Heat the nozzle (°C) without waiting; 0 = off."),
        Of(TurtleAction.BedTemperature, "bed", "bed_temp set_bed_temp", "temperature", "Heat the bed (°C) and wait; 0 = off."),
        Of(TurtleAction.SetBedTemperature, "bed_nowait", "", "temperature", "Heat the bed (°C) without waiting; 0 = off."),
        Of(TurtleAction.Fan, "fan", "", "speed", "Speed of the part cooling fan, 0 to 1."),
        Of(TurtleAction.Mix, "mix", "set_mix_factor", "fraction", "Fraction of the first of two mixed materials, 0 to 1."),
        Of(TurtleAction.Acceleration, "acceleration", "", "value", "Acceleration of the following moves in mm/s²."),
        Of(TurtleAction.Tool, "tool", "set_extruder", "number", "Change to a tool, numbered from 0."),
        Of(TurtleAction.Comment, "comment", "write_gcode_comment", "", "text", "Write a comment to the G-code. {formulas} in it are evaluated."),
        Of(TurtleAction.Raw, "raw", "do", "", "line", "Write a line of G-code as it is. {formulas} in it are evaluated."),
        Of(TurtleAction.Layer, "layer", "", "number [height]", "Layer of the following extrusions (height in mm)."),
        Of(TurtleAction.NextLayer, "next_layer", "", "[height]", "Put the following extrusions on the next layer."),
        Of(TurtleAction.Color, "color", "colour set_color", "[red] [green] [blue]", "[color]",
            "Color of the following extrusions: three numbers from 0 to 255, or \"#rrggbb\". No value = no color."),
        Of(TurtleAction.Name, "name", "", "", "name", "Name of the following extrusions."),
        Of(TurtleAction.Role, "role", "", "", "role", "Role of the following extrusions: \"outer_wall\", \"infill\", \"skirt\" …"),
        Of(TurtleAction.Degrees, "degrees", "", "", "Use degrees for the following angles."),
        Of(TurtleAction.Radians, "radians", "", "", "Use radians for the following angles."),
    ];

    private static Dictionary<string, TurtleCommandInfo> ByName { get; } = Index();

    /// <summary>All names and aliases.</summary>
    public static IEnumerable<string> Names => All.SelectMany(c => new[] { c.Name }.Concat(c.Aliases));

    /// <summary>The command of a name or alias, or null.</summary>
    public static TurtleCommandInfo? Find(string name) => ByName.TryGetValue(name, out var info) ? info : null;

    /// <summary>The command of an action.</summary>
    /// <exception cref="ArgumentException">Repeat, which has no values of its own.</exception>
    public static TurtleCommandInfo Of(TurtleAction action)
        => All.FirstOrDefault(c => c.Action == action) ?? throw new ArgumentException("This action is not a single command.", nameof(action));

    private static TurtleCommandInfo Of(TurtleAction action, string name, string aliases, string values, string help)
        => Of(action, name, aliases, values, null, help);

    private static TurtleCommandInfo Of(TurtleAction action, string name, string aliases, string values, string? text, string help)
        => new(action, name, Words(aliases), Words(values), text, help);

    private static string[] Words(string text) => text.Split([' '], StringSplitOptions.RemoveEmptyEntries);

    private static Dictionary<string, TurtleCommandInfo> Index()
    {
        var index = new Dictionary<string, TurtleCommandInfo>(StringComparer.Ordinal);
        foreach (var info in All)
        {
            index.Add(info.Name, info);
            foreach (var alias in info.Aliases) index.Add(alias, info);
        }
        return index;
    }
}

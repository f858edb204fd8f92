namespace Caterpillar.Turtles;

/// <summary>One command of the language: its names and values.</summary>
/// <param name="Action">What it does.</param>
/// <param name="Name">Its name in scripts.</param>
/// <param name="Aliases">Other names, mostly of the libraries of the papers.</param>
/// <param name="Values">Names of its numbers, with units; those in brackets are optional.</param>
/// <param name="Text">Name of its text, or null; in brackets if it is optional.</param>
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
        Of(TurtleAction.Start, "start", "setup", "x y [z]", "Starts at a point (mm); only before the first move."),
        Of(TurtleAction.Forward, "forward", "fd", "distance [rise]", "Moves along forward (mm); with a rise, along the azimuth and world Z (Kanada)."),
        Of(TurtleAction.Backward, "backward", "back bk", "distance", "Moves backward without turning (mm); prints like forward."),
        Of(TurtleAction.Move, "move", "", "distance", "Moves along forward (mm), never prints."),
        Of(TurtleAction.ForwardLift, "forward_lift", "", "distance height", "One straight move along forward and up (mm)."),
        Of(TurtleAction.Lift, "lift", "", "height", "Moves along the turtle's up (mm), never prints."),
        Of(TurtleAction.LiftWorld, "lift_world", "", "height", "Moves along world Z (mm), never prints."),
        Of(TurtleAction.Yaw, "yaw", "left lt", "angle", "Turns to the left."),
        Of(TurtleAction.Right, "right", "rt", "angle", "Turns to the right."),
        Of(TurtleAction.Pitch, "pitch", "pitch_up", "angle", "Raises the nose."),
        Of(TurtleAction.PitchDown, "pitch_down", "", "angle", "Lowers the nose."),
        Of(TurtleAction.Roll, "roll", "roll_right", "angle", "Lifts the left side."),
        Of(TurtleAction.RollLeft, "roll_left", "", "angle", "Lowers the left side."),
        Of(TurtleAction.TurnAround, "turn_around", "", "", "Turns around."),
        Of(TurtleAction.Heading, "heading", "set_heading set_angle", "yaw [pitch] [roll]", "Sets the heading: from the world axes, yaw, pitch, roll."),
        Of(TurtleAction.ChangeHeading, "change_heading", "", "yaw [pitch] [roll]", "Adds to the three angles of the heading."),
        Of(TurtleAction.Face, "face", "set_heading_point", "x y z", "Looks at a point (mm), wings level."),
        Of(TurtleAction.Level, "level", "", "", "Turns the wings level."),
        Of(TurtleAction.Position, "position", "goto set_position", "x y [z]",
            "Moves straight to a point (mm), prints with the pen down; 'keep' leaves a coordinate."),
        Of(TurtleAction.Jump, "jump", "set_turtle", "x y [z] [azimuth]",
            "Moves straight to a point (mm), never prints; with an azimuth it stands level there."),
        Of(TurtleAction.Arc, "arc", "", "radius angle [climb] [segments]", "An arc (mm), to the left with a positive angle; may climb."),
        Of(TurtleAction.Circle, "circle", "", "radius [segments]", "A circle (mm) with its center on the left, closed exactly."),
        Of(TurtleAction.CircleAround, "circle_around", "", "radius [segments]", "A circle (mm) around the turtle, which returns."),
        Of(TurtleAction.Polygon, "polygon", "", "sides side", "A regular polygon (side in mm), closed exactly; negative sides turn right."),
        Of(TurtleAction.CircleTrace, "circle_trace", "", "radius [strings]", "A circle of strings (mm) around the turtle, which stays, as after all traces."),
        Of(TurtleAction.SpiralTrace, "spiral_trace", "", "radius pitch [strings]", "A flat spiral (mm) from the turtle outward; strings per turn."),
        Of(TurtleAction.HelixTrace, "helix_trace", "", "radius height pitch [strings] [ramp]",
            "A hollow cylinder (mm) around the turtle without layers; ramp: flow at both ends, 0 to 1."),
        Of(TurtleAction.ConeTrace, "cone_trace", "", "bottom_radius top_radius height pitch [strings] [ramp]", "A hollow cone (mm), as a helix."),
        Of(TurtleAction.CylinderTrace, "cylinder_trace", "", "radius height vertical_pitch horizontal_pitch [strings]",
            "A filled cylinder of flat spirals (mm), outward and inward in turn."),
        Of(TurtleAction.SkirtTrace, "skirt_trace", "", "radius [loops] [pitch]", "Rings (mm) around the turtle that prime the flow, from the outside in."),
        Of(TurtleAction.Push, "push", "", "", "Saves the whole state."),
        Of(TurtleAction.Pop, "pop", "", "", "Returns to the last saved state, along a path that planning finds."),
        Of(TurtleAction.PenUp, "penup", "pen_up pu", "", "The following moves print nothing."),
        Of(TurtleAction.PenDown, "pendown", "pen_down pd", "", "The following moves print."),
        Of(TurtleAction.Density, "density", "set_density extrude_rate set_extrude_rate", "filament", "mm of filament per mm of path."),
        Of(TurtleAction.Area, "area", "cross_section set_cross_section", "area [height]", "Extrusion in mm², and its height in mm."),
        Of(TurtleAction.Bead, "bead", "", "width height [multiplier]", "Extrusion of a width and height in mm."),
        Of(TurtleAction.Rate, "rate", "feedrate set_feedrate", "speed", "Speed in mm/min."),
        Of(TurtleAction.Speed, "speed", "set_velocity", "speed", "Speed in mm/s."),
        Of(TurtleAction.TravelRate, "travel_rate", "", "speed", "Speed of moves that print nothing, mm/min; 0: as fast as printing."),
        Of(TurtleAction.TravelSpeed, "travel_speed", "", "speed", "Speed of moves that print nothing, mm/s; 0: as fast as printing."),
        Of(TurtleAction.Extrude, "extrude", "", "filament", "Extrudes mm of filament in place; negative retracts."),
        Of(TurtleAction.Dwell, "dwell", "", "time", "Waits for a time in milliseconds."),
        Of(TurtleAction.Pause, "pause", "pause_and_wait", "", "[message]", "Waits for the user."),
        Of(TurtleAction.NozzleTemperature, "hotend", "extruder_temp nozzle_temp set_extruder_temp", "temperature", "Heats the nozzle (°C) and waits."),
        Of(TurtleAction.SetNozzleTemperature, "hotend_nowait", "", "temperature", "Heats the nozzle (°C) without waiting."),
        Of(TurtleAction.BedTemperature, "bed", "bed_temp set_bed_temp", "temperature", "Heats the bed (°C) and waits; 0 is off."),
        Of(TurtleAction.SetBedTemperature, "bed_nowait", "", "temperature", "Heats the bed (°C) without waiting."),
        Of(TurtleAction.Fan, "fan", "", "speed", "Component cooling fan, 0 to 1."),
        Of(TurtleAction.Mix, "mix", "set_mix_factor", "share", "Share of the first of two materials, 0 to 1."),
        Of(TurtleAction.Acceleration, "acceleration", "", "value", "Acceleration in mm/s²."),
        Of(TurtleAction.Tool, "tool", "set_extruder", "number", "Changes the tool, from 0."),
        Of(TurtleAction.Comment, "comment", "write_gcode_comment", "", "text", "A comment in the G-code; {formulas} in it are evaluated."),
        Of(TurtleAction.Raw, "raw", "do", "", "line", "A line of G-code as it is; {formulas} in it are evaluated."),
        Of(TurtleAction.Layer, "layer", "", "number [thickness]", "The following extrusions belong to a layer (thickness in mm)."),
        Of(TurtleAction.NextLayer, "next_layer", "", "[thickness]", "The following extrusions belong to the next layer."),
        Of(TurtleAction.Color, "color", "colour set_color", "[red] [green] [blue]", "[color]",
            "The following extrusions have a color: three numbers 0 to 255, or \"#rrggbb\"; no value ends it."),
        Of(TurtleAction.Name, "name", "", "", "name", "The following extrusions have a name."),
        Of(TurtleAction.Role, "role", "", "", "role", "Role of the following extrusions: \"outer_wall\", \"infill\", \"skirt\" …"),
        Of(TurtleAction.Degrees, "degrees", "", "", "Angles of the following commands are in degrees."),
        Of(TurtleAction.Radians, "radians", "", "", "Angles of the following commands are in radians."),
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

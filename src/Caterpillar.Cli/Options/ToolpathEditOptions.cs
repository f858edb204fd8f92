using Caterpillar.GCode;
using Caterpillar.Jobs;
using Caterpillar.Shaping;

namespace Caterpillar.Cli;

/// <summary>Options that change what a decoded file prints. They act on the chosen layers; start and end code belong to no layer and stay.</summary>
internal sealed class ToolpathEditOptions
{
    private readonly MoveFilterOptions _filter = new();
    private readonly Described<string?> _speed = new("--speed", "Multiply the speed of the chosen extrusions.", "FACTOR|%");
    private readonly Described<string?> _flow = new("--flow", "Multiply the material of the chosen extrusions.", "FACTOR|%");
    private readonly Described<string?> _scale = new("--scale",
        "Scale the selection about the middle of its base, extrusions and their amounts of E included.", "FACTOR|X,Y,Z");
    private readonly Described<double?> _turn = new("--rotate", "Turn the selection about its middle, counterclockwise seen from above.", "DEGREES");
    private readonly Described<string?> _move = new("--move", "Move the selection.", "X,Y,Z");
    private readonly Described<string?> _deform = new("--deform", "Deform the selection: the new x, y, z in mm as formulas of the old.", "FORMULAS");
    private readonly Described<string?> _axis = new("--axis", "Formulas in r, theta (degrees) and z about this vertical axis.", "X,Y|middle");
    private readonly Described<bool> _remove = new("--remove", "Remove the selection.");
    private readonly Described<int[]> _pauses = new("--pause-at-layer",
        "Insert a pause before a layer, lifted and parked by the printer's keys; may be repeated.", "N");

    private readonly Described<bool> _plainPause = new("--plain-pause", "Pause on the spot, by the command alone.");
    private readonly Described<string[]> _tools = new("--tool-at-layer", "Change the tool before a layer; may be repeated.", "N=TOOL");
    private readonly Described<string[]> _lines = new("--gcode-at-layer", "Insert a line of G-code before a layer; may be repeated.", "N=LINE");
    private readonly Described<string?> _start = new("--start-gcode", "File with lines that replace everything before the first layer.", "FILE");
    private readonly Described<string?> _end = new("--end-gcode", "File with lines that replace everything after the last layer.", "FILE");

    public Option[] All =>
        [.. _filter.All, _speed, _flow, _scale, _turn, _move, _deform, _axis, _remove, _pauses, _plainPause, _tools, _lines, _start, _end];

    /// <summary>What is to be edited in a toolpath.</summary>
    /// <exception cref="CliException">An option is wrong.</exception>
    public FileEdits Of(Toolpath toolpath, double tolerance, Func<Pause> pause, ParseResult arguments, Session session)
    {
        var edits = new FileEdits
        {
            Filter = _filter.Of(toolpath, arguments),
            Speed = arguments.GetValue(_speed) is { } speed ? Numbers.Factor(speed, "--speed", 1e-6) : null,
            Flow = arguments.GetValue(_flow) is { } flow ? Numbers.Factor(flow, "--flow", 0) : null,
            Scale = arguments.GetValue(_scale) is { } scales ? Numbers.Scale(scales) : null,
            Move = arguments.GetValue(_move) is { } vector ? Numbers.Vector(vector, "--move") : null,
            Turn = arguments.GetValue(_turn) is not { } turn || double.IsFinite(turn) ? arguments.GetValue(_turn)
                : throw new CliException(ExitCode.Usage, "--rotate needs an angle in degrees."),
            Deform = Deformation(arguments, session),
            PauseAtLayers = arguments.GetValue(_pauses) ?? [],
            Remove = arguments.GetValue(_remove),
            Tolerance = tolerance,
        };
        var plain = arguments.GetValue(_plainPause);
        if (plain && edits.PauseAtLayers.Count == 0) throw new CliException(ExitCode.Usage, "--plain-pause needs --pause-at-layer.");
        if (edits.PauseAtLayers.Count > 0 && !plain) edits = edits with { Pause = pause() };
        edits = edits with { AtLayers = [.. (arguments.GetValue(_tools) ?? []).Select(Tool), .. (arguments.GetValue(_lines) ?? []).Select(Line)] };
        return !edits.Remove || _filter.IsGiven(arguments) ? edits
            : throw new CliException(ExitCode.Usage, "--remove needs layers, roles, objects, a tool or a box to cut out.");
    }

    /// <summary>New start and end code.</summary>
    public EditOptions Code(ParseResult arguments)
        => new() { Start = Lines(arguments.GetValue(_start), "--start-gcode"), End = Lines(arguments.GetValue(_end), "--end-gcode") };

    private static string[]? Lines(string? file, string option)
    {
        if (file is null) return null;
        return file.Trim().Length > 0 ? File.ReadAllLines(file) : throw new CliException(ExitCode.Usage, $"{option} needs the name of a file.");
    }

    private static (int Layer, PrinterEvent What) Tool(string text)
    {
        var (layer, tool) = Numbers.Pair(text, "--tool-at-layer");
        return Numbers.Whole(tool) is >= 0 and < 100 and var number ? (layer, new ToolEvent(number))
            : throw new CliException(ExitCode.Usage, $"--tool-at-layer: \"{tool}\" is not the number of a tool.");
    }

    private static (int Layer, PrinterEvent What) Line(string text)
    {
        var (layer, line) = Numbers.Pair(text, "--gcode-at-layer");
        return line.Trim().Length > 0 && !line.AsSpan().ContainsAny('\r', '\n') ? (layer, new RawEvent(line))
            : throw new CliException(ExitCode.Usage, "--gcode-at-layer needs one line of G-code: N=LINE.");
    }

    // Null where nothing is deformed.
    private Func<Vec3, Deformation>? Deformation(ParseResult arguments, Session session)
    {
        var axis = arguments.GetValue(_axis);
        if (arguments.GetValue(_deform) is not { } formulas)
            return axis is null ? null : throw new CliException(ExitCode.Usage, "--axis needs --deform.");
        if (formulas.Trim().Length == 0) throw new CliException(ExitCode.Usage, "--deform needs formulas, for example \"x + 0.1*z, y, z\".");
        var system = axis is null ? DeformationSystem.Cartesian : DeformationSystem.Cylindrical;
        var at = axis is null or "middle" ? (Vec3?)null : Numbers.Vector(axis, "--axis");
        return middle => session.ValueOrFail(DeformationText.Compile(
            formulas, null, null, system, axis is null ? Vec3.Zero : (at ?? middle).WithZ(0), new SourceLocation("--deform")), ExitCode.Usage);
    }
}

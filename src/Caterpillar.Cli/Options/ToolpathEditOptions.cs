namespace Caterpillar.Cli;

/// <summary>Options that edit a decoded file. They act on the selected layers. Start and end G-code are outside of layers and stay unchanged.</summary>
internal sealed class ToolpathEditOptions
{
    private readonly MoveFilterOptions _filter = new();
    private readonly Described<string?> _speed = new("--speed", "Speed factor of the selected extrusions.", "FACTOR|%");
    private readonly Described<string?> _flow = new("--flow", "Flow factor of the selected extrusions.", "FACTOR|%");
    private readonly Described<string?> _scale = new("--scale",
        "Scale the selection about the center of its base, with E.", "FACTOR|%|X,Y,Z");
    private readonly Described<double?> _turn = new("--rotate", "Rotate the selection about its center, counterclockwise from above.", "DEGREES");
    private readonly Described<string?> _move = new("--move", "Move the selection.", "X,Y,Z");
    private readonly Described<string?> _deform = new("--deform", "Deform the selection: formulas for the new x, y, z from the old, in mm.", "FORMULAS");
    private readonly Described<string?> _axis = new("--axis", "With --deform: vertical axis for formulas in r, theta (degrees) and z.", "X,Y|center");
    private readonly Described<bool> _remove = new("--remove", "Remove the selection.");
    private readonly Described<double?> _below = new("--keep-below",
        "Keep the lower part of the print: layers up to this height, a lift and the end code.", "Z");
    private readonly Described<double?> _above = new("--keep-above",
        "Keep the upper part of the print, which continues on a part of this height on the bed. The nozzle must touch its top before the start.", "Z");

    private readonly Described<int[]> _pauses = new("--pause-at-layer",
        "Pause before a layer. The pause keys of the printer set lift and parking position. Repeatable.", "N");

    private readonly Described<bool> _plainPause = new("--plain-pause", "Pause in place: write only the pause command.");
    private readonly Described<string[]> _tools = new("--tool-at-layer", "Change the tool before a layer. Repeatable.", "N=TOOL");
    private readonly Described<string[]> _lines = new("--gcode-at-layer", "Insert a line of G-code before a layer. Repeatable.", "N=LINE");
    private readonly Described<string?> _start = new("--start-gcode", "File with start G-code that replaces everything before the first layer.", "FILE");
    private readonly Described<string?> _end = new("--end-gcode", "File with end G-code that replaces everything after the last layer.", "FILE");

    public Option[] All =>
        [.. _filter.All, _speed, _flow, _scale, _turn, _move, _deform, _axis, _remove, _below, _above, _pauses, _plainPause, _tools, _lines, _start, _end];

    /// <summary>True if no edits are given, or none but those of all moves alike: speed, flow, scale, rotation and position.</summary>
    public bool AreNone(ParseResult arguments, bool orPlain = false)
        => All.Except<Option>(orPlain ? [_speed, _flow, _scale, _turn, _move] : []).All(o => arguments.GetResult(o) is null or { Implicit: true });

    /// <summary>The edits of a toolpath.</summary>
    /// <exception cref="CliException">An option is invalid.</exception>
    public FileEdits Of(Toolpath toolpath, double tolerance, Func<PrintSetup> pausing, ParseResult arguments, Session session)
    {
        var edits = new FileEdits
        {
            Filter = _filter.Of(toolpath, arguments),
            Speed = arguments.GetValue(_speed) is { } speed ? Numbers.Ratio(speed, "--speed", 1e-6) : null,
            Flow = arguments.GetValue(_flow) is { } flow ? Numbers.Ratio(flow, "--flow", 0) : null,
            Scale = arguments.GetValue(_scale) is { } scales ? Numbers.Scale(scales) : null,
            Move = arguments.GetValue(_move) is { } vector ? Numbers.Vector(vector, "--move") : null,
            Rotate = arguments.GetValue(_turn) is not { } turn || double.IsFinite(turn) ? arguments.GetValue(_turn)
                : throw CliException.Usage("--rotate needs an angle in degrees."),
            Deform = Deformation(arguments, session),
            PauseAtLayers = arguments.GetValue(_pauses) ?? [],
            Remove = arguments.GetValue(_remove),
            Tolerance = tolerance,
        };
        var plain = arguments.GetValue(_plainPause);
        if (plain && edits.PauseAtLayers.Count == 0) throw CliException.Usage("--plain-pause needs --pause-at-layer.");
        if (edits.PauseAtLayers.Count > 0 && !plain) edits = edits with { PauseFor = pausing() };
        edits = edits with { AtLayers = [.. (arguments.GetValue(_tools) ?? []).Select(Tool), .. (arguments.GetValue(_lines) ?? []).Select(Line)] };
        return !edits.Remove || _filter.IsGiven(arguments) ? edits
            : throw CliException.Usage("--remove needs a selection: --first-layer, --last-layer, --role, --object, --tool or --box.");
    }

    /// <summary>The part of the print that is kept.</summary>
    /// <exception cref="CliException">The print cannot be cut there.</exception>
    public FileJob Half(FileJob job, ParseResult arguments, Session session)
    {
        if (arguments.GetValue(_above) is { } above) job = session.ValueOrFail(job.KeepAbove(above));
        return arguments.GetValue(_below) is { } below ? session.ValueOrFail(job.KeepBelow(below)) : job;
    }

    /// <summary>New start and end G-code.</summary>
    public EditOptions Code(ParseResult arguments)
        => new() { Start = Lines(arguments.GetValue(_start), "--start-gcode"), End = Lines(arguments.GetValue(_end), "--end-gcode") };

    private static string[]? Lines(string? file, string option) => file is null ? null
        : file.Trim().Length > 0 ? File.ReadAllLines(file) : throw CliException.Usage($"{option} needs a file name.");

    private static (int Layer, PrinterEvent What) Tool(string text)
    {
        var (layer, tool) = Numbers.Pair(text, "--tool-at-layer");
        return Numbers.Whole(tool) is >= 0 and < 100 and var number ? (layer, new ToolEvent(number))
            : throw CliException.Usage($"--tool-at-layer needs a tool number from 0 to 99, not \"{tool}\".");
    }

    private static (int Layer, PrinterEvent What) Line(string text)
    {
        var (layer, line) = Numbers.Pair(text, "--gcode-at-layer");
        return line.Trim().Length > 0 && !line.AsSpan().ContainsAny('\r', '\n') ? (layer, new RawEvent(line))
            : throw CliException.Usage("--gcode-at-layer needs one line of G-code: N=LINE.");
    }

    // Null without deformation.
    private Func<Vec3, Deformation>? Deformation(ParseResult arguments, Session session)
    {
        var axis = arguments.GetValue(_axis);
        if (arguments.GetValue(_deform) is not { } formulas)
            return axis is null ? null : throw CliException.Usage("--axis needs --deform.");
        if (formulas.Trim().Length == 0) throw CliException.Usage("--deform needs formulas, for example \"x + 0.1*z, y, z\".");
        var system = axis is null ? DeformationSystem.Cartesian : DeformationSystem.Cylindrical;
        var at = axis is null or "center" ? (Vec3?)null : Numbers.Vector(axis, "--axis");
        return middle => session.ValueOrFail(DeformationText.Compile(
            formulas, null, null, system, axis is null ? Vec3.Zero : (at ?? middle).WithZ(0), new SourceLocation("--deform")), ExitCode.Usage);
    }
}

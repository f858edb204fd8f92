using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;

namespace Caterpillar.Cli.Commands;

/// <summary>Options that change what a decoded file prints. They act on the chosen layers; start and end code belong to no layer and stay.</summary>
internal sealed class ToolpathEditOptions
{
    private readonly MoveFilterOptions _filter = new();
    private readonly Option<string?> _speed = new("--speed") { Description = "Multiply the speed of the chosen strands.", HelpName = "FACTOR|%" };
    private readonly Option<string?> _flow = new("--flow") { Description = "Multiply the material of the chosen strands.", HelpName = "FACTOR|%" };
    private readonly Option<string?> _scale =
        new("--scale") { Description = "Scale the selection about the middle of its base, strands and their amounts of E included.",
        HelpName = "FACTOR|X,Y,Z" };
    private readonly Option<double?> _turn = new("--turn") { Description = "Turn the selection about its middle, counterclockwise seen from above.",
        HelpName = "DEGREES" };
    private readonly Option<string?> _move = new("--move") { Description = "Move the selection.", HelpName = "X,Y,Z" };
    private readonly Option<string?> _deform = new("--deform") { Description = "Deform the selection: the new x, y, z in mm as formulas of the old.",
        HelpName = "FORMULAS" };
    private readonly Option<string?> _axis = new("--axis") { Description = "Formulas in r, theta (degrees) and z about this vertical axis.",
        HelpName = "X,Y|middle" };
    private readonly Option<bool> _remove = new("--remove") { Description = "Remove the selection." };
    private readonly Option<int[]> _pauses = new("--pause-at-layer")
    {
        Description = "Insert a pause before a layer, lifted and parked by the printer's keys; may be repeated.", HelpName = "N",
    };

    private readonly Option<bool> _plainPause = new("--plain-pause") { Description = "Pause on the spot, by the command alone." };
    private readonly Option<string[]> _tools = new("--tool-at-layer") { Description = "Change the tool before a layer; may be repeated.",
        HelpName = "N=TOOL" };
    private readonly Option<string[]> _lines = new("--line-at-layer") { Description = "Insert a line of G-code before a layer; may be repeated.",
        HelpName = "N=LINE" };
    private readonly Option<string?> _start = new("--start-code") { Description = "File with lines that replace everything before the first layer.",
        HelpName = "FILE" };
    private readonly Option<string?> _end = new("--end-code") { Description = "File with lines that replace everything after the last layer.",
        HelpName = "FILE" };

    public void AddTo(Verb verb)
    {
        _filter.AddTo(verb);
        foreach (var option in new Option[] { _speed, _flow, _scale, _turn, _move, _deform, _axis, _remove, _pauses, _plainPause, _tools, _lines, _start,
            _end }) verb.Options.Add(option);
    }

    /// <summary>The edited toolpath; the same one if no edit is asked for.</summary>
    /// <exception cref="CliException">An option is wrong, or a formula gives no point.</exception>
    public Toolpath Edit(Toolpath toolpath, double tolerance, Func<Pause> pause, ParseResult arguments, Session session)
    {
        var filter = _filter.Of(toolpath, arguments);
        var strands = filter with { Kinds = [MoveKind.Print] };
        if (_filter.IsGiven(arguments) && !toolpath.Moves().Any(strands.MatchesIn(toolpath)))
            session.Print([new Diagnostic(Severity.Warning, "edit.nothing_selected", "The selection prints nothing in this file, so nothing is edited.")]);
        if (arguments.GetValue(_speed) is { } speed) toolpath = toolpath.ScaleSpeed(strands, Numbers.Factor(speed, "--speed", 1e-6));
        if (arguments.GetValue(_flow) is { } flow) toolpath = toolpath.ScaleFlow(strands, Numbers.Factor(flow, "--flow", 0));
        if (Map(toolpath, strands, arguments) is { } map)
        {
            if (arguments.GetValue(_scale) is { } scales) session.Print(ScaleNotes(toolpath, strands, Numbers.Scale(scales)));
            toolpath = toolpath.Transform(filter, map, tolerance);
        }
        if (arguments.GetValue(_deform) is { } formulas)
        {
            if (formulas.Trim().Length == 0) throw new CliException(ExitCode.Usage, "--deform needs formulas, for example \"x + 0.1*z, y, z\".");
            var deformation = session.ValueOrFail(Deformation(toolpath, strands, formulas, arguments.GetValue(_axis)), ExitCode.Usage);
            toolpath = session.ValueOrFail(toolpath.Deform(filter, deformation, tolerance));
        }
        else if (arguments.GetValue(_axis) is not null)
        {
            throw new CliException(ExitCode.Usage, "--axis needs --deform.");
        }
        toolpath = Pauses(toolpath, pause, arguments);
        foreach (var text in arguments.GetValue(_tools) ?? [])
        {
            var (layer, tool) = Numbers.Pair(text, "--tool-at-layer");
            if (Numbers.Whole(tool) is not (>= 0 and < 100 and var number))
            {
                throw new CliException(ExitCode.Usage, $"--tool-at-layer: \"{tool}\" is not the number of a tool.");
            }
            toolpath = AtLayer(toolpath, layer, new ToolEvent(number));
        }
        foreach (var text in arguments.GetValue(_lines) ?? [])
        {
            var (layer, line) = Numbers.Pair(text, "--line-at-layer");
            if (line.Trim().Length == 0 || line.AsSpan().ContainsAny('\r', '\n'))
                throw new CliException(ExitCode.Usage, "--line-at-layer needs one line of G-code: N=LINE.");
            toolpath = AtLayer(toolpath, layer, new RawEvent(line));
        }
        if (!arguments.GetValue(_remove)) return toolpath;
        if (!_filter.IsGiven(arguments)) throw new CliException(ExitCode.Usage, "--remove needs layers, roles, objects, a tool or a box to cut out.");
        return toolpath.Remove(_filter.NamesStrands(arguments) ? strands : filter);
    }

    private Toolpath Pauses(Toolpath toolpath, Func<Pause> lifted, ParseResult arguments)
    {
        var layers = arguments.GetValue(_pauses) ?? [];
        if (layers.Length == 0)
        {
            return !arguments.GetValue(_plainPause) ? toolpath : throw new CliException(ExitCode.Usage, "--plain-pause needs --pause-at-layer.");
        }
        var pause = arguments.GetValue(_plainPause) ? Pause.Plain : lifted();
        foreach (var layer in layers)
        {
            var changed = toolpath.PauseAtLayer(layer, pause);
            toolpath = changed.Value ?? throw new CliException(ExitCode.Usage, changed.Diagnostics[0].Message);
        }
        return toolpath;
    }

    /// <summary>New start and end code.</summary>
    public EditOptions Code(ParseResult arguments)
        => new() { Start = Lines(arguments.GetValue(_start), "--start-code"), End = Lines(arguments.GetValue(_end), "--end-code") };

    private static string[]? Lines(string? file, string option)
    {
        if (file is null) return null;
        return file.Trim().Length > 0 ? File.ReadAllLines(file) : throw new CliException(ExitCode.Usage, $"{option} needs the name of a file.");
    }

    private static Toolpath AtLayer(Toolpath toolpath, int layer, PrinterEvent what)
    {
        var changed = toolpath.InsertAtLayer(layer, what);
        return changed.Value ?? throw new CliException(ExitCode.Usage, changed.Diagnostics[0].Message);
    }

    // What scaling cannot know.
    private static IEnumerable<Diagnostic> ScaleNotes(Toolpath toolpath, MoveFilter strands, Vec3 scale)
    {
        if (toolpath.Moves().Where(strands.MatchesIn(toolpath)).All(m => m.Deposited == 0))
            yield return new Diagnostic(Severity.Warning, "edit.no_amounts", "The strands have no amounts of E: only their paths are scaled.");
        else if (scale.X != scale.Y || scale.Y != scale.Z)
            yield return new Diagnostic(Severity.Remark, "edit.scaled_apart",
                "Axes are scaled apart: each strand gets the area that its direction gives it; a width in a comment is that of the first strand after it.");
    }

    // Null if nothing is moved.
    private Affine? Map(Toolpath toolpath, MoveFilter strands, ParseResult arguments)
    {
        var scale = arguments.GetValue(_scale) is { } scales ? Numbers.Scale(scales) : (Vec3?)null;
        var turn = arguments.GetValue(_turn);
        var move = arguments.GetValue(_move) is { } vector ? Numbers.Vector(vector, "--move") : (Vec3?)null;
        if (scale is null && turn is null) return move is { } shift ? Affine.Move(shift) : null;
        var foot = Foot(toolpath, strands);
        var map = Affine.Move(-foot);
        if (scale is { } s) map = map.Then(Affine.Scale(s.X, s.Y, s.Z));
        if (turn is { } degrees)
        {
            map = map.Then(Affine.Rotate(Vec3.UnitZ,
                double.IsFinite(degrees) ? degrees : throw new CliException(ExitCode.Usage, "--turn needs an angle in degrees.")));
        }
        return map.Then(Affine.Move(foot + (move ?? Vec3.Zero)));
    }

    private static Result<Deformation> Deformation(Toolpath toolpath, MoveFilter strands, string formulas, string? axis)
    {
        var system = axis is null ? DeformationSystem.Cartesian : DeformationSystem.Cylindrical;
        var at = axis is null ? Vec3.Zero : axis == "middle" ? Foot(toolpath, strands) : Numbers.Vector(axis, "--axis");
        return DeformationText.Compile(formulas, null, null, system, at.WithZ(0), new SourceLocation("--deform"));
    }

    // The middle of what the strands cover, on the bed.
    private static Vec3 Foot(Toolpath toolpath, MoveFilter strands)
    {
        var box = strands.BoundsIn(toolpath);
        return box.IsEmpty ? Vec3.Zero : box.Center.WithZ(0);
    }
}

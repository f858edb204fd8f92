using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Cli.Commands;

/// <summary>Decodes a G-code file and writes it again: edited, for another firmware, in another notation. Lines that stay the same stay as they are.</summary>
internal sealed class ConvertVerb : Verb
{
    private readonly Argument<string> _file = new("FILE") { Description = "G-code file, also packed with gzip, or - for standard input." };
    private readonly Option<string> _out = new("--output", "-o") { Description = "File to write; - is standard output.", HelpName = "FILE", Required = true };
    private readonly Option<string?> _from = new("--from") { Description = "The firmware the file is for; detected from the file without it.", HelpName = "DIALECT" };
    private readonly Option<string?> _to = new("--dialect") { Description = "The firmware to write for.", HelpName = "DIALECT" };
    private readonly Option<string?> _e = new("--e") { Description = "E as increments or as sums.", HelpName = "relative|absolute" };
    private readonly Option<string?> _unit = new("--e-unit") { Description = "E in mm of filament or in mm³.", HelpName = "mm|mm3" };
    private readonly Option<double?> _diameter = new("--filament-diameter") { Description = "Diameter in mm where the file does not say.", HelpName = "MM" };
    private readonly Option<string?> _arcs = new("--arcs") { Description = "Fit arcs to strands, or expand arcs to chords.", HelpName = "fit|expand" };
    private readonly Option<double> _tolerance = new("--tolerance") { Description = "Largest deviation of fitted arcs and of chords.", HelpName = "MM", DefaultValueFactory = _ => 0.02 };
    private readonly Option<bool> _millimetres = new("--mm") { Description = "Inches become millimetres." };
    private readonly Option<double> _retraction = new("--retraction") { Description = "Retraction in units of E that stands for G10 and G11 where the target has none.", HelpName = "E" };
    private readonly Option<int?> _first = new("--first-layer") { Description = "First layer that is edited, from 0.", HelpName = "N" };
    private readonly Option<int?> _last = new("--last-layer") { Description = "Last layer that is edited.", HelpName = "N" };
    private readonly Option<string[]> _roles = new("--role") { Description = "Edit strands of this role only (OuterWall, Infill …); may be repeated.", HelpName = "ROLE" };
    private readonly Option<string[]> _objects = new("--object") { Description = "Edit this object only; may be repeated.", HelpName = "NAME" };
    private readonly Option<double?> _speed = new("--speed") { Description = "Multiply the speed of the chosen strands.", HelpName = "FACTOR" };
    private readonly Option<double?> _flow = new("--flow") { Description = "Multiply the material of the chosen strands.", HelpName = "FACTOR" };
    private readonly Option<string?> _move = new("--move") { Description = "Move what is chosen.", HelpName = "X,Y,Z" };
    private readonly Option<bool> _remove = new("--remove") { Description = "Cut the chosen layers, roles or objects out." };
    private readonly Option<int[]> _pause = new("--pause-at-layer") { Description = "Put a pause in front of a layer; may be repeated.", HelpName = "N" };

    public ConvertVerb()
        : base("convert", "Decode a G-code file and write it again: edited, for another firmware, in another notation.")
    {
        Arguments.Add(_file);
        foreach (var option in new Option[]
        {
            _out, _from, _to, _e, _unit, _diameter, _arcs, _tolerance, _millimetres, _retraction, _first, _last, _roles, _objects, _speed, _flow, _move, _remove, _pause,
        }) Options.Add(option);
        _e.AcceptOnlyFromAmong("relative", "absolute");
        _unit.AcceptOnlyFromAmong("mm", "mm3");
        _arcs.AcceptOnlyFromAmong("fit", "expand");
    }

    public override int Run(ParseResult arguments, Session session)
    {
        var file = arguments.GetValue(_file)!;
        var target = Target(arguments);
        var from = Dialect(arguments.GetValue(_from));
        GCodeDocument document;
        try
        {
            using var stream = session.OpenRead(file);
            document = GCodeDocument.Read(stream, Session.NameOf(file), session.Cancel);
        }
        catch (InvalidDataException broken)
        {
            session.Print([new Diagnostic(Severity.Error, "gcode.packed", "The packed file is broken: " + broken.Message, new SourceLocation(Session.NameOf(file)))]);
            return ExitCode.BadInput;
        }
        var decoding = session.Need(session.Long("Reading", p => Decoder.Decode(document, new DecodeOptions { Dialect = from, FilamentDiameter = arguments.GetValue(_diameter) }, p, session.Cancel)));
        var edited = Edit(decoding.Toolpath, arguments);
        if (!ReferenceEquals(edited, decoding.Toolpath))
        {
            var again = session.Need(session.Long("Editing", p => GCodeEditor.ToDocument(decoding, edited, p, session.Cancel)));
            decoding = Decoder.Decode(again, new DecodeOptions { Dialect = decoding.Dialect, FilamentDiameter = arguments.GetValue(_diameter) }, null, session.Cancel).Value!;
        }
        var result = target is null ? null : session.Long("Writing", p => GCodeConverter.ToDocument(decoding, target, p, session.Cancel));
        var written = result is null ? decoding.Document! : session.Need(result);
        session.Write(arguments.GetValue(_out)!, written.WriteTo);
        return ExitCode.Done;
    }

    // Null where nothing is to be converted.
    private ConvertOptions? Target(ParseResult arguments)
    {
        var target = new ConvertOptions
        {
            Dialect = Dialect(arguments.GetValue(_to)),
            RelativeE = arguments.GetValue(_e) is { } e ? e == "relative" : null,
            Volumetric = arguments.GetValue(_unit) is { } unit ? unit == "mm3" : null,
            FilamentDiameter = arguments.GetValue(_diameter),
            ExpandArcs = arguments.GetValue(_arcs) == "expand",
            ChordTolerance = Tolerance(arguments),
            Millimetres = arguments.GetValue(_millimetres),
            RetractionLength = arguments.GetValue(_retraction),
        };
        return target.Dialect is null && target.RelativeE is null && target.Volumetric is null && !target.ExpandArcs && !target.Millimetres ? null : target;
    }

    private double Tolerance(ParseResult arguments)
        => arguments.GetValue(_tolerance) is > 0 and < 1000 and var tolerance ? tolerance : throw new CliException(ExitCode.Usage, "--tolerance needs a positive number of mm.");

    private Toolpath Edit(Toolpath toolpath, ParseResult arguments)
    {
        var roles = arguments.GetValue(_roles) is { Length: > 0 } names ? names.Select(RoleOf).ToArray() : null;
        var objects = arguments.GetValue(_objects) is { Length: > 0 } found ? found : null;
        var filter = new MoveFilter { FirstLayer = arguments.GetValue(_first), LastLayer = arguments.GetValue(_last), Roles = roles, Objects = objects };
        var prints = filter with { Kinds = [MoveKind.Print] };
        if (arguments.GetValue(_speed) is { } speed) toolpath = toolpath.ScaleSpeed(prints, Factor(speed, "--speed", 1e-6));
        if (arguments.GetValue(_flow) is { } flow) toolpath = toolpath.ScaleFlow(prints, Factor(flow, "--flow", 0));
        if (arguments.GetValue(_move) is { } move)
        {
            var by = Vector(move);
            toolpath = toolpath.Deform(filter, p => p + by, Tolerance(arguments));
        }
        if (arguments.GetValue(_arcs) == "fit") toolpath = toolpath.FitArcs(new ArcFitOptions { Tolerance = Tolerance(arguments) });
        foreach (var layer in arguments.GetValue(_pause) ?? []) toolpath = toolpath.InsertAtLayer(layer, new PauseEvent());
        if (!arguments.GetValue(_remove)) return toolpath;
        if (filter == new MoveFilter()) throw new CliException(ExitCode.Usage, "--remove needs layers, roles or objects to cut out.");
        return toolpath.Remove(roles is null ? filter : prints);
    }

    private static Role RoleOf(string name)
        => Enum.TryParse<Role>(name.Replace("-", "").Replace("_", ""), true, out var role) && Enum.IsDefined(role)
            ? role
            : throw new CliException(ExitCode.Usage, $"There is no role \"{name}\"; there are " + string.Join(", ", Enum.GetNames<Role>()) + ".");

    private static double Factor(double value, string name, double least)
        => value >= least && value < 1e6 ? value : throw new CliException(ExitCode.Usage, name + " needs a positive factor.");

    private static Vec3 Vector(string text)
    {
        var parts = text.Split(',');
        var values = new double[3];
        if (parts.Length is < 2 or > 3) throw new CliException(ExitCode.Usage, "--move needs X,Y or X,Y,Z in mm.");
        for (var i = 0; i < parts.Length; i++)
        {
            if (!NumberReader.TryParse(parts[i].Trim(), out values[i])) throw new CliException(ExitCode.Usage, $"--move: \"{parts[i]}\" is no number.");
        }
        return new Vec3(values[0], values[1], values[2]);
    }

    private static DialectRules? Dialect(string? name)
    {
        if (name is null) return null;
        return DialectTable.Find(name) ?? throw new CliException(
            ExitCode.Usage, $"There is no dialect \"{name}\"; there are " + string.Join(", ", DialectTable.All.Select(d => d.Name)) + ".");
    }
}

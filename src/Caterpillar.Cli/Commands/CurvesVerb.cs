using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Drawings;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;

namespace Caterpillar.Cli.Commands;

/// <summary>Prints curves as drawn, in their order.</summary>
internal sealed class CurvesVerb : Verb
{
    private readonly Argument<string> _file =
        new("FILE") { Description = "Curves: points as CSV or JSON, lines of OBJ, paths of SVG, also gzipped; - is standard input." };

    private readonly CurveSettingOptions _strand = new();
    private readonly DivisionOptions _division = new();

    private readonly Option<string> _sort = new("--sort")
    {
        Description = "Order: none (as given), orient (only turned around), nearest, layer, z or tour.", DefaultValueFactory = _ => "none",
    };

    private readonly Option<string?> _move = new("--move") { Description = "Moves the curves by an offset in mm, or to the \"center\" of the bed.",
        HelpName = "X,Y[,Z]|center" };

    private readonly Option<string[]> _map = new("--map")
    {
        Description = "Maps a coordinate to another axis word, scaled: X=A*2.86 turns A by 2.86 degrees per mm of X; Y=Y*0.5 scales Y. Applied last.",
            HelpName = "AXIS=WORD*SCALE",
    };

    private readonly Option<string> _plan =
        new("--plan") { Description = "\"printer\": with the printer's retraction and lifts; \"drawn\": only the curves.",
        DefaultValueFactory = _ => "printer" };

    private readonly Option<bool> _json = new("--json") { Description = "Print what was planned and written as JSON." };

    private readonly OntoOptions _onto = new(OntoOptions.Drawn, OntoOptions.DrawnPartial);

    private readonly Option<string?> _maxSize = new("--max-size") { Description = "Largest file that the printer accepts, in MB; a larger one is not written.",
        HelpName = "MB" };

    private readonly SetupOptions _setup = new();
    private readonly WriteOptions _write = new();

    public CurvesVerb()
        : base("curves", "Turn user curves into G-code, as drawn and in their order.")
    {
        _sort.AcceptOnlyFromAmong("none", "orient", "nearest", "layer", "z", "tour");
        _plan.AcceptOnlyFromAmong("drawn", "printer");
        Arguments.Add(_file);
        _write.AddTo(this);
        _strand.AddTo(this);
        _division.AddTo(this);
        foreach (Option option in new Option[] { _sort, _move, _map, _plan, _json, _maxSize }) Options.Add(option);
        _onto.AddTo(this);
        _setup.AddTo(this);
        AllowBatches();
    }

    public override IReadOnlyList<(string Line, string Does)> Examples =>
    [
        ("curves curves.csv -o curves.gcode", "the curves of a table, in their order"),
        ("curves drawing.svg --printer pen_plotter --move center -o drawing.gcode", "a drawing for a pen"),
    ];

    public override string[] Writes => ["G-code"];

    public override string? Ending => ".gcode";

    public override int Run(ParseResult arguments, Session session)
    {
        var file = arguments.GetValue(_file)!;
        var target = _write.FileFor(arguments, file);
        var json = arguments.GetValue(_json);
        if (json && target == "-") throw new CliException(ExitCode.Usage, "Standard output can hold the G-code or the JSON, not both: give -o FILE.");
        var mappings = (arguments.GetValue(_map) ?? []).Select(AxisMappings.Parse).ToArray();
        var limit = OptionValues.OptionalNumber(arguments.GetValue(_maxSize), "--max-size", 0) * 1e6 ?? double.PositiveInfinity;
        _onto.Check(arguments);
        var setup = _setup.Resolve(arguments, session);
        var sort = SortOf(arguments.GetValue(_sort)!);
        // Sorting of curves is an option of this verb, not a setting as for sliced parts.
        setup = setup with { Settings = setup.Settings with { SortPaths = sort != SortRule.None } };
        var options = _division.Of(arguments, _strand.Of(arguments, setup)) with
        {
            Memory = session.Memory,
            Sorting = sort switch { SortRule.None => CurveSorting.None, SortRule.Layer or SortRule.Z => CurveSorting.All, _ => CurveSorting.WithinLayers },
        };
        var reading = new CurveReadOptions
        {
            Memory = session.Memory,
            WidthReference = setup.Printer.NozzleDiameter,
            HeightReference = setup.Settings.LayerHeight,
            SpeedReference = setup.Settings.PrintSpeed,
            UnitLength = _strand.UnitOf(arguments),
        };
        var (steps, count) = Steps(file, reading, options, arguments.GetValue(_move), setup, session);
        var policy = arguments.GetValue(_plan) == "printer" ? PlanPolicy.Printer : PlanPolicy.AsDrawn;
        var planning = new PlanOptions { Policy = policy, Sort = new SortOptions(sort), Memory = session.Memory };
        (steps, setup) = _onto.Apply(arguments, steps, setup, session);
        var plan = Planned(steps, setup, planning, session);
        var toolpath = plan.Toolpath;
        foreach (var mapping in mappings) toolpath = mapping.Apply(toolpath, null, session.Cancel);
        var written = _write.WriteGCode(arguments, session, toolpath, setup, target, limit);
        if (json) session.WriteText("-", text => text.Write(WorkReport.ToJson([file], target, [new("curves", count)], plan, written)));
        return ExitCode.Done;
    }

    // The memory of each stage is free for the next one: files can be large.
    private static (IReadOnlyList<Step> Steps, int Count) Steps(string file, CurveReadOptions reading, CurveOptions options, string? move, PrintSetup setup,
        Session session)
    {
        var curves = Moved(Curves(file, reading, session), move, setup.Printer);
        return (session.WithProgress("Dividing", progress => session.ValueOrFail(CurvePaths.ToSteps(curves, options, progress, session.Cancel))), curves.Count);
    }

    private static IReadOnlyList<UserCurve> Curves(string file, CurveReadOptions reading, Session session)
    {
        var bytes = session.ReadBytes(file);
        return session.WithProgress("Reading",
            progress => session.ValueOrFail(CurveReader.Read(bytes, Session.NameOf(file), reading, progress, session.Cancel)));
    }

    private static Plan Planned(IReadOnlyList<Step> steps, PrintSetup setup, PlanOptions planning, Session session)
        => session.WithProgress("Planning", progress => session.ValueOrFail(Planner.PlanWithReport(steps, setup, planning, progress, session.Cancel)));

    private static IReadOnlyList<UserCurve> Moved(IReadOnlyList<UserCurve> curves, string? text, Printer printer)
    {
        if (text is null) return curves;
        Vec3 shift;
        if (text == "center")
        {
            var bounds = curves.Aggregate(Bounds.Empty, (b, c) => b.Include(c.Curve.Bounds));
            shift = (printer.BuildBounds.Center - bounds.Center).WithZ(0);
        }
        else
        {
            var numbers = text.Split(',').Select(w => OptionValues.Number(w, "--move", double.NegativeInfinity)).ToArray();
            if (numbers.Length is not (2 or 3)) throw new CliException(ExitCode.Usage, "--move: give X,Y or X,Y,Z in mm, or center.");
            shift = new Vec3(numbers[0], numbers[1], numbers.Length > 2 ? numbers[2] : 0);
        }
        var map = Affine.Move(shift);
        return curves.Select(c => c with { Curve = c.Curve.Transformed(map) }).ToArray();
    }

    private static SortRule SortOf(string word) => word switch
    {
        "orient" => SortRule.Orient,
        "nearest" => SortRule.Nearest,
        "layer" => SortRule.Layer,
        "z" => SortRule.Z,
        "tour" => SortRule.Tour,
        _ => SortRule.None,
    };
}

namespace Caterpillar.Cli;

/// <summary>Prints curves as drawn, in the given order.</summary>
internal sealed class CurvesVerb : Verb
{
    private readonly Argument<string> _file =
        new("FILE") { Description = "Curves: CSV or JSON points, OBJ lines or SVG paths, also gzip; - = standard input." };

    private readonly CurveSettingOptions _extrusion = new();
    private readonly DivisionOptions _division = new();

    private readonly Described<string> _sort = new("--sort",
        "Print order. none: as given. orient: only reversed. nearest: nearest start next. layer, z: by layer or height. tour: short travel moves.",
        "none|orient|nearest|layer|z|tour") { DefaultValueFactory = _ => "none" };

    private readonly Described<string?> _move = new("--move", "Move the curves by an offset in mm, or to the center of the bed. "
        + "Default for SVG files without --onto and printers that extrude: center.", "X,Y[,Z]|center");

    private readonly Described<int?> _layers = new("--layers",
        "Stack a flat drawing N layers high: the first of first_layer_height_mm, the others of --height, by default layer_height_mm.", "N");

    private readonly Described<string[]> _map = new("--map",
        "Map a coordinate to an axis word, scaled, as axis_mappings of a printer. X=A*2.86 turns A by 2.86° per mm of X, Y=Y*0.5 scales Y. Repeatable.",
        "AXIS=WORD*SCALE");

    private readonly Described<string> _plan = CommonOptions.Plan("printer");

    private readonly Described<bool> _json = new("--json", "Print a report of plan and output as JSON.");

    private readonly OntoOptions _onto = new();
    private readonly TiltOptions _tilt = new();

    private readonly Described<string?> _maxSize = new("--max-size", "Maximum file size. Larger files are not written.", "MB");

    private readonly SetupOptions _setup = new();
    private readonly WriteOptions _write = new();

    public CurvesVerb()
        : base("curves", "Turn curves into G-code, as drawn and in the given order.", ["G-code"], ".gcode")
    {
        _sort.AcceptOnlyFromAmong("none", "orient", "nearest", "layer", "z", "tour");
        Arguments.Add(_file);
        Add([.. _write.All, .. _extrusion.All, .. _division.All, _sort, _move, _layers, _map, _plan, _json, _maxSize]);
        Add([.. _onto.OfDrawings, .. _tilt.All, .. _setup.All]);
        AllowBatches();
    }

    public override int Run(ParseResult arguments, Session session)
    {
        var file = arguments.GetValue(_file)!;
        var target = _write.FileFor(arguments, file);
        var json = arguments.GetValue(_json);
        if (json && target == "-") throw CliException.Usage("--json cannot be combined with G-code on standard output. Give -o FILE.");
        var limit = Numbers.MaybeAtLeast(arguments.GetValue(_maxSize), "--max-size", 0) * 1e6 ?? double.PositiveInfinity;
        _onto.Check(arguments);
        _tilt.Check(arguments, false);
        var setup = _setup.Resolve(arguments, session);
        var sort = Enum.Parse<SortRule>(arguments.GetValue(_sort)!, true);
        if (arguments.GetValue(_map) is { Length: > 0 } maps)
            setup = setup with { Printer = setup.Printer with { AxisMappings = new([.. maps.Select(Mapping)]) } };
        // Sorting of curves is an option of this verb, not a setting as for sliced parts.
        setup = setup with { Settings = setup.Settings with { SortPaths = sort != SortRule.None } };
        var curves = _division.Of(arguments, _extrusion.Of(arguments, setup)) with
        {
            Layers = LayersOf(arguments),
            Memory = session.Memory,
            Sorting = sort switch { SortRule.None => CurveSorting.None, SortRule.Layer or SortRule.Z => CurveSorting.All, _ => CurveSorting.WithinLayers },
        };
        var reading = CurveReadOptions.For(setup) with { Memory = session.Memory, UnitLength = _extrusion.UnitOf(arguments) };
        // Pages of SVG drawings have their corner at the corner of the bed, where start code prints.
        var isPage = curves.FlatHeight > 0 && !_onto.IsGiven(arguments) && file.EndsWith(".svg", StringComparison.OrdinalIgnoreCase);
        var (steps, count) = Steps(file, reading, curves, arguments.GetValue(_move) ?? (isPage ? "center" : null), setup, session);
        var options = new PrintJobOptions
        {
            Policy = arguments.GetValue(_plan) == "printer" ? PlanPolicy.Printer : PlanPolicy.AsDrawn, Sort = sort, Memory = session.Memory,
            Tilt = _tilt.Read(arguments, Affine.Identity, setup, session),
        };
        using var job = _onto.Draw(arguments, steps, setup, options, session);
        var written = _write.Write(arguments, session, job, target, limit);
        if (json) session.WriteText("-", text => text.Write(WorkReport.ToJson([file], target, [new("curves", count)], job.Plan, written)));
        return ExitCode.Done;
    }

    // The memory of each stage is free for the next one: files can be large.
    private static (IReadOnlyList<Step> Steps, int Count) Steps(string file, CurveReadOptions reading, CurveOptions options, string? move, PrintSetup setup,
        Session session)
    {
        var curves = Moved(Curves.Read(file, reading, session), move, setup.Printer);
        return (session.Run("Dividing", progress => CurvePaths.ToSteps(curves, options, progress, session.Cancel)), curves.Count);
    }

    private static IReadOnlyList<UserCurve> Moved(IReadOnlyList<UserCurve> curves, string? text, Printer printer)
    {
        if (text is null) return curves;
        var bounds = curves.Aggregate(Bounds.Empty, (b, c) => b.Include(c.Curve.Bounds));
        var shift = text == "center" ? (printer.BuildBounds.Center - bounds.Center).WithZ(0) : Numbers.Vector(text, "--move");
        var map = Affine.Move(shift);
        return curves.Select(c => c with { Curve = c.Curve.Transformed(map) }).ToArray();
    }

    private int LayersOf(ParseResult arguments)
        => arguments.GetValue(_layers) is not { } layers ? 0 : layers is >= 1 and <= 100_000 ? layers
            : throw CliException.Usage("--layers needs a whole number from 1 to 100000.");

    private static AxisMapping Mapping(string text) => AxisMapping.Parse(text)
        ?? throw CliException.Usage($"--map {text}: expected AXIS=WORD*SCALE, such as X=A*2.86 (degrees per mm) or Y=Y*0.5.");
}

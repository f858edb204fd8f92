namespace Caterpillar.Cli;

/// <summary>Slices meshes into G-code, in planar layers or along a surface.</summary>
internal sealed class SliceVerb : Verb
{
    private readonly Argument<string[]> _models = new("MODEL")
    {
        Description = CommonOptions.MeshInput + " Several files are parts of one print and keep their relative positions.",
        Arity = ArgumentArity.OneOrMore,
    };

    private readonly ModelOptions _placing = new();
    private readonly ModelSettingOptions _own = new();
    private readonly InfillCurveOptions _infill = new();
    private readonly CurvedOptionValues _curved = new();
    private readonly TiltOptions _tilt = new();
    private readonly Described<bool> _json = new("--json", "Print a report of plan and output as JSON.");
    private readonly SetupOptions _setup = new();
    private readonly WriteOptions _write = new();
    private readonly Option<int> _threads = CommonOptions.Threads();

    public SliceVerb()
        : base("slice", "Slice meshes into G-code.", ["G-code"], ".gcode")
    {
        Arguments.Add(_models);
        Add([.. _write.All, .. _setup.All, .. _placing.All, .. _own.All, .. _infill.All, .. _curved.All, .. _tilt.All, _threads, _json]);
        AllowBatches();
    }

    public override int Run(ParseResult arguments, Session session)
    {
        var files = arguments.GetValue(_models)!;
        var output = _write.FileFor(arguments, files[0]);
        var json = arguments.GetValue(_json);
        if (json && output == "-") throw CliException.Usage("--json cannot be combined with G-code on standard output. Give -o FILE.");
        _placing.Check(arguments);
        _curved.Check(arguments);
        _tilt.Check(arguments, _curved.HasField(arguments));
        using var job = Planned(files, arguments, session);
        var written = _write.Write(arguments, session, job, output);
        if (json) session.WriteText("-", text => text.Write(WorkReport.ToJson(files, output, [new("layers", job.Layers)], job.Plan, written)));
        return ExitCode.Done;
    }

    private PrintJob Planned(string[] files, ParseResult arguments, Session session)
    {
        var setup = _setup.Resolve(arguments, session);
        var (read, models) = Models(files, arguments, ref setup, session);
        var options = new PrintJobOptions { Threads = arguments.GetValue(_threads), Memory = session.Memory };
        options = options with { Tilt = _tilt.Read(arguments, models[0].Mesh.Placed, setup, session) };
        if (_curved.IsGiven(arguments)) return Curved(arguments, read.Count, models, setup, options, session);
        if (!_write.Overrides(arguments) && ModelCheck.IsTooLarge([.. models.Where(m => m.Settings.ModelType == ModelType.Part).Select(m => m.Mesh)], setup))
        {
            session.Print([new Diagnostic(Severity.Error, "write.refused",
                $"Nothing was sliced because the models do not fit. To slice them anyway, add --override REASON.{_placing.ScaleAdvice(arguments)}")]);
            throw new CliException(ExitCode.Refused);
        }
        return session.Run("Slicing", progress => PrintJob.Slice(models, setup, options, progress, session.Cancel));
    }

    // Along surfaces, or onto an object.
    private PrintJob Curved(ParseResult arguments, int originals, SliceModel[] models, PrintSetup setup, PrintJobOptions options, Session session)
    {
        var placed = models.Select(m => m.Mesh.Placed).Distinct().ToArray();
        if (placed.Length > 1 && originals > 1) throw Problem("several models cannot be arranged: the surface would not follow them.");
        if (placed.Length > 1 && !_curved.CanBeCopied(arguments)) throw Problem("formulas for --deform do not follow copies.");
        options = _curved.Onto.Of(arguments, placed, options, session);
        if (!_curved.HasField(arguments)) return session.Run("Slicing", progress => PrintJob.Slice(models, setup, options, progress, session.Cancel));
        // Together with an object the model is already where it belongs.
        if (options.Onto is not null)
            models = [.. models.Select(m => new SliceModel(m.Mesh.Moved(new Vec3(0, 0, -m.Mesh.Placed.Shift.Z)), m.Settings))];
        var meshes = models.Select(m => m.Mesh).ToArray();
        var first = placed.Length == 1 ? meshes : [meshes[0]];
        var field = _curved.Field(arguments, first, setup, session);
        if (placed.Length > 1) field = field.ForCopies(meshes);
        return session.Run("Slicing", progress => PrintJob.Slice(models, field, setup, options, progress, session.Cancel));

        static CliException Problem(string text) => CliException.Usage("With curved layers or --onto, " + text);
    }

    private (IReadOnlyList<NamedMesh> Read, SliceModel[] Models) Models(string[] files, ParseResult arguments, ref PrintSetup setup, Session session)
    {
        setup = _infill.Resolve(arguments, setup);
        var own = _own.Resolve(arguments, setup, session);
        var curves = _infill.Read(arguments, setup, session);
        var sources = new List<string>();
        var read = session.Run("Reading", progress => Meshes.Read(files, session, progress, sources, _placing.UnitOf(arguments)));
        var settings = own.For(read, sources, session);
        var placed = _placing.Placed(read, settings.Select(s => s.ModelType == ModelType.Part).ToArray(), arguments, setup, session);
        // Copies follow in the order of the originals.
        return (read, [.. ProjectModels.Models(placed, settings).Select(m => InfillCurveOptions.With(m, curves))]);
    }
}

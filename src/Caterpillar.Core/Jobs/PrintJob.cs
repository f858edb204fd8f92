namespace Caterpillar.Jobs;

/// <summary>
/// A planned print of models, paths, a turtle program or curves, ready to be checked and written. Planning and checks run while higher layers are still being
/// sliced, so dispose a job that is not written. For use by one thread.
/// </summary>
public sealed class PrintJob : IDisposable
{
    private PrintPipeline? _pipeline;
    private PlanTiming? _timing;

    private PrintJob(Plan plan, Toolpath toolpath, PrintSetup setup, int layers, PrintPipeline? pipeline)
        => (Plan, Toolpath, Setup, Layers, _pipeline) = (plan, toolpath, setup, layers, pipeline);

    /// <summary>The plan, with the number of uses of each rule.</summary>
    public Plan Plan { get; }

    /// <summary>The toolpath to write: the plan, with tilted tool if requested.</summary>
    public Toolpath Toolpath { get; }

    /// <summary>The setup for checks and output, with the object that is printed on.</summary>
    public PrintSetup Setup { get; }

    /// <summary>Number of sliced layers; 0 for drawings.</summary>
    public int Layers { get; }

    /// <summary>Slices a mesh file (STL, OBJ, PLY, 3MF) in the center of the bed.</summary>
    /// <inheritdoc cref="Slice(IReadOnlyList{string}, PrintSetup, ModelPlacing?, PrintJobOptions?, IProgress{double}?, CancellationToken)" path="/exception"/>
    public static Result<PrintJob> Slice(
        string model, PrintSetup setup, PrintJobOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
        => Slice([model], setup, null, options, progress, cancel);

    /// <summary>Slices mesh files. They keep their relative positions unless they are arranged.</summary>
    /// <exception cref="IOException">A file cannot be read.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static Result<PrintJob> Slice(
        IReadOnlyList<string> models, PrintSetup setup, ModelPlacing? placing = null, PrintJobOptions? options = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        var memory = (options ?? new PrintJobOptions()).Memory;
        var found = new List<Diagnostic>();
        var meshes = new List<NamedMesh>();
        for (var i = 0; i < models.Count; i++)
        {
            var part = progress.Part(0.1 * i / models.Count, 0.1 * (i + 1) / models.Count);
            var read = MeshReader.Read(File.ReadAllBytes(models[i]), models[i], new MeshReadOptions { Memory = memory }, part, cancel);
            found.AddRange(read.Diagnostics);
            if (read.Value is null) return new Result<PrintJob>(null, found);
            meshes.AddRange(read.Value);
        }
        var placed = (placing ?? new ModelPlacing()).Place(meshes, setup, null, cancel);
        found.AddRange(placed.Diagnostics);
        if (placed.Value is null) return new Result<PrintJob>(null, found);
        var parts = placed.Value.Select(m => new SliceModel(m, setup.Settings)).ToArray();
        return After(found, Slice(parts, setup, options, progress.Part(0.1, 1), cancel));
    }

    /// <summary>Slices models with their own settings at their print positions (Z = 0 is the bed), or onto an object.</summary>
    /// <inheritdoc cref="Slice(IReadOnlyList{string}, PrintSetup, ModelPlacing?, PrintJobOptions?, IProgress{double}?, CancellationToken)" path="/exception"/>
    public static Result<PrintJob> Slice(
        IReadOnlyList<SliceModel> models, PrintSetup setup, PrintJobOptions? options = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        options ??= new PrintJobOptions();
        if (options.Onto is not null) return SliceOnto(models, setup, options, progress, cancel);
        return Piped(setup, options, pipeline =>
        {
            var slicing = new SliceOptions
            {
                Threads = options.Threads, Memory = options.Memory, InfillLines = options.InfillLines,
                Printer = setup.Settings.PurgeTower ? PrimedArea.Excluded(setup, isForTower: true) : setup.Printer,
                Take = layers => pipeline.Add([.. layers.SelectMany(l => l.Steps)]),
            };
            return PlanarSlicer.SliceEach(models, setup.Settings, slicing, progress, cancel);
        }, cancel);
    }

    /// <summary>Slices models along the level sets of a field, on the bed or on an object.</summary>
    /// <inheritdoc cref="Slice(IReadOnlyList{string}, PrintSetup, ModelPlacing?, PrintJobOptions?, IProgress{double}?, CancellationToken)" path="/exception"/>
    public static Result<PrintJob> Slice(
        IReadOnlyList<SliceModel> models, LayerField field, PrintSetup setup, PrintJobOptions? options = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        options ??= new PrintJobOptions();
        return Piped(OverObjects(setup) with { PrintedOn = options.Onto }, options, pipeline =>
        {
            var curved = new CurvedOptions
            {
                Threads = options.Threads, Memory = options.Memory, InfillLines = options.InfillLines, Partial = options.Partial, Take = pipeline.Add,
                Onto = options.Onto is { } below ? PlanSurface.OnBed(below) : null, MaxTilt = Math.Min(options.Tilt?.MaxTilt ?? 0, 90),
            };
            var sliced = CurvedSlicer.SliceEach(models, field, setup, curved, progress, cancel);
            return new Result<SliceResult>(sliced.Value, sliced.Diagnostics);
        }, cancel);
    }

    /// <summary>Plans a drawing: the steps of a turtle, trace or curves, or paths of any points (<see cref="PathSteps.ToSteps"/>).</summary>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static Result<PrintJob> Draw(
        IReadOnlyList<Step> steps, PrintSetup setup, PrintJobOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
        => Draw(steps, setup, options ?? new PrintJobOptions(), 0, progress, cancel);

    /// <summary>Runs the turtle program of a file. The drawing is printed as it is, without added moves, unless the options request them.</summary>
    /// <param name="script">The file, which may include other files of its folder.</param>
    /// <param name="setup">The printer, material and settings.</param>
    /// <param name="variables">Values of parameters; missing ones keep their default.</param>
    /// <param name="options">What planning may add, and what is printed on.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels.</param>
    /// <inheritdoc cref="Slice(IReadOnlyList{string}, PrintSetup, ModelPlacing?, PrintJobOptions?, IProgress{double}?, CancellationToken)" path="/exception"/>
    public static Result<PrintJob> Turtle(
        string script, PrintSetup setup, IReadOnlyDictionary<string, double>? variables = null, PrintJobOptions? options = null,
        IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        options ??= new PrintJobOptions { Policy = PlanPolicy.AsDrawn };
        var compiled = TurtleScript.Compile(File.ReadAllText(script), script, new ScriptFiles(Path.GetDirectoryName(Path.GetFullPath(script))!));
        if (compiled.Value is null) return new Result<PrintJob>(null, compiled.Diagnostics);
        var run = compiled.Value.Run(TurtleOptions.For(setup), variables, 0, new TurtleLimits { Memory = options.Memory }, null, cancel);
        return run.Value is null ? new Result<PrintJob>(null, run.Diagnostics)
            : After(run.Diagnostics, Draw(run.Value.ToSteps(), setup, options, progress, cancel));
    }

    /// <summary>Draws the curves of a file (CSV, JSON, SVG, OBJ lines) in their order.</summary>
    /// <param name="file">The file.</param>
    /// <param name="setup">The printer, material and settings.</param>
    /// <param name="curves">Extrusion and division of the curves; null = from the settings.</param>
    /// <param name="options">What planning may add, and what is printed on.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels.</param>
    /// <inheritdoc cref="Slice(IReadOnlyList{string}, PrintSetup, ModelPlacing?, PrintJobOptions?, IProgress{double}?, CancellationToken)" path="/exception"/>
    public static Result<PrintJob> Curves(
        string file, PrintSetup setup, CurveOptions? curves = null, PrintJobOptions? options = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        options ??= new PrintJobOptions();
        var read = CurveReader.Read(file, CurveReadOptions.For(setup) with { Memory = options.Memory }, progress.Part(0, 0.2), cancel);
        if (read.Value is null) return new Result<PrintJob>(null, read.Diagnostics);
        var steps = CurvePaths.ToSteps(read.Value, curves ?? CurveOptions.For(setup), progress.Part(0.2, 0.5), cancel);
        Diagnostic[] found = [.. read.Diagnostics, .. steps.Diagnostics];
        return steps.Value is null ? new Result<PrintJob>(null, found) : After(found, Draw(steps.Value, setup, options, progress.Part(0.5, 1), cancel));
    }

    /// <summary>Checks the print and writes it as a file, whole or not at all.</summary>
    /// <param name="path">The output file; .bgcode = binary. An existing file is replaced.</param>
    /// <param name="reason">Reason to write despite errors of the checks, which the file keeps as a comment; null = refuse.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels. No partial file is left.</param>
    /// <returns>The written file, or none with the findings and <see cref="SafeWriter.Refused"/>.</returns>
    /// <exception cref="IOException">The disk failed.</exception>
    public Result<WrittenGCode> WriteFile(string path, string? reason = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        using var file = new AtomicFile(path);
        var written = Write(file.Stream, path, file.IsTemporary, reason, progress, cancel);
        if (written.Value is not null) file.Commit();
        return written;
    }

    /// <summary>Checks the print and writes it to a stream.</summary>
    /// <param name="stream">The output stream.</param>
    /// <param name="name">The name of the output; .bgcode = binary.</param>
    /// <param name="isDraft">True if a refused output is discarded, so that checks run during writing. Otherwise all checks run first.</param>
    /// <param name="reason">Reason to write despite errors of the checks; null = refuse.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels.</param>
    /// <inheritdoc cref="WriteFile" path="/returns"/>
    public Result<WrittenGCode> Write(
        Stream stream, string name, bool isDraft = false, string? reason = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        Result<WrittenGCode>? written = null;
        // What was checked before the file was written counts once.
        using var pipeline = Interlocked.Exchange(ref _pipeline, null);
        var timing = Interlocked.Exchange(ref _timing, null);
        BinaryGCode.WriteAs(name, stream, text => written = Text(text), cancel);
        return written!;

        Result<WrittenGCode> Text(Stream text) => pipeline is not null ? pipeline.Write(text, isDraft, reason, progress, cancel)
            : SafeWriter.Write(Toolpath, Setup, text, reason, progress, cancel, isDraft, (null, timing));
    }

    /// <summary>Stops checks that are still running.</summary>
    public void Dispose() => _pipeline?.Dispose();

    private static Result<PrintJob> Draw(
        IReadOnlyList<Step> steps, PrintSetup setup, PrintJobOptions options, int layers, IProgress<double>? progress, CancellationToken cancel)
    {
        if (steps is null) throw new ArgumentNullException(nameof(steps));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        IReadOnlyList<Diagnostic> found = [];
        if (options.Onto is { } below && !options.InPlace)
        {
            var surface = PlanSurface.Of(below);
            var projected = SurfaceProjection.Project(steps, surface, setup, options.Squeeze, options.Partial, progress.Part(0, 0.5), cancel);
            if (projected.Value is null) return new Result<PrintJob>(null, projected.Diagnostics);
            (steps, found) = (projected.Value, projected.Diagnostics);
            progress = progress.Part(0.5, 1);
        }
        if (options.Onto is not null) setup = OverObjects(setup) with { PrintedOn = options.Onto };
        var timing = new PlanTiming(setup, cancel);
        var plan = Planner.PlanWithReport(steps, setup, options.Planning with { Follow = timing.Take }, progress, cancel);
        var job = Planned(plan, setup, options, layers, null, null, cancel);
        if (job.Value is { } drawn && ReferenceEquals(drawn.Toolpath, drawn.Plan.Toolpath)) drawn._timing = timing;
        return After(found, job);
    }

    // Loops around the part, rafts and towers are for beds.
    private static Result<PrintJob> SliceOnto(
        IReadOnlyList<SliceModel> models, PrintSetup setup, PrintJobOptions options, IProgress<double>? progress, CancellationToken cancel)
    {
        static PrintSettings Plain(PrintSettings settings) => settings.WithoutSkirtAndBrim with { RaftLayers = 0, PurgeTower = false };
        var plain = models.Select(m => new SliceModel(m.Mesh, Plain(m.Settings))).ToArray();
        var slicing = new SliceOptions { Threads = options.Threads, Memory = options.Memory };
        var flat = PlanarSlicer.SliceEach(plain, Plain(setup.Settings), slicing, progress.Part(0, 0.6), cancel);
        return flat.Value is not { } layers ? new Result<PrintJob>(null, flat.Diagnostics)
            : After(flat.Diagnostics, Draw(layers.ToSteps(), setup, options, layers.Layers.Count, progress.Part(0.6, 1), cancel));
    }

    // Layers are planned and checked as soon as they are sliced.
    private static Result<PrintJob> Piped(
        PrintSetup setup, PrintJobOptions options, Func<PrintPipeline, Result<SliceResult>> slice, CancellationToken cancel)
    {
        var pipeline = new PrintPipeline(setup, options.Planning, cancel);
        try
        {
            var sliced = slice(pipeline);
            if (sliced.Value is not { } layers) return new Result<PrintJob>(null, sliced.Diagnostics);
            var field = (layers as CurvedResult)?.Field;
            var job = After(sliced.Diagnostics, Planned(pipeline.Finish(), setup, options, layers.Layers.Count, pipeline, field, cancel));
            // What was tilted is another toolpath than the one that has been checked so far.
            if (job.Value?._pipeline is not null) pipeline = null;
            return job;
        }
        finally
        {
            pipeline?.Dispose();
        }
    }

    private static Result<PrintJob> Planned(
        Result<Plan> planned, PrintSetup setup, PrintJobOptions options, int layers, PrintPipeline? pipeline, LayerField? field, CancellationToken cancel)
    {
        if (planned.Value is not { } plan) return new Result<PrintJob>(null, planned.Diagnostics);
        var toolpath = plan.Toolpath;
        var aim = options.Tilt is { Direction: null, MaxTilt: var most } && field is not null ? TiltedTool.Along(field, most) : options.Tilt;
        toolpath = aim?.Direction is not null && setup.Printer.Kinematics is not null ? TiltedTool.Apply(toolpath, setup, aim, null, cancel)
            : setup.Printer.Turned(toolpath, cancel);
        return new Result<PrintJob>(
            new PrintJob(plan, toolpath, setup, layers, ReferenceEquals(toolpath, plan.Toolpath) ? pipeline : null), planned.Diagnostics);
    }

    // Over objects and curved layers the head is lifted by what lies under its course, unless travels are not lifted at all.
    private static PrintSetup OverObjects(PrintSetup setup) => setup.Settings.ZHopType != ZHopType.AbovePrint ? setup
        : setup with { Settings = setup.Settings with { ZHopType = ZHopType.AbovePath } };

    private static Result<PrintJob> After(IReadOnlyList<Diagnostic> earlier, Result<PrintJob> job) => new(job.Value, [.. earlier, .. job.Diagnostics]);
}

namespace Caterpillar.Jobs;

/// <summary>Edits and converts a G-code file and writes it again. Unchanged lines keep their bytes. Immutable.</summary>
public sealed record FileJob
{
    private readonly DecodeOptions _reading;

    /// <param name="file">A file that was decoded with its document.</param>
    /// <param name="reading">The options it was decoded with. The result is read back with the same options.</param>
    /// <exception cref="ArgumentException">The file was decoded from a stream, without its document.</exception>
    public FileJob(DecodedGCode file, DecodeOptions? reading = null)
    {
        File = file ?? throw new ArgumentNullException(nameof(file));
        if (file.Document is null) throw new ArgumentException("The file has no document. Decode it with its document to write it again.", nameof(file));
        _reading = reading ?? new DecodeOptions();
        Toolpath = file.Toolpath;
    }

    /// <summary>The file as it was read.</summary>
    public DecodedGCode File { get; }

    /// <summary>The toolpath after all edits so far, which keep the order of its moves.</summary>
    public Toolpath Toolpath { get; init; }

    /// <summary>New start and end G-code.</summary>
    public EditOptions Code { get; init; } = new();

    /// <summary>True if an edit has moved, scaled, rotated or deformed the print.</summary>
    public bool IsMoved { get; private init; }

    /// <summary>Conversion of the edited file; null = same flavor and notation.</summary>
    public ConvertOptions? Target { get; init; }

    /// <summary>The flavor of the output.</summary>
    public FlavorRules Flavor => Target?.Flavor ?? File.Flavor;

    /// <summary>Reads a G-code file: text, gzip or binary. A file without a command is not G-code and an error.</summary>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static Result<FileJob> Open(string path, DecodeOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        var read = GCodeDecoder.DecodeFile(path, options, progress, cancel);
        if (read.Value?.NotGCode is { } none) return new Result<FileJob>(null, [none]);
        return new Result<FileJob>(read.Value is { } file ? new FileJob(file, options) : null, read.Diagnostics);
    }

    /// <summary>The job with edits.</summary>
    /// <inheritdoc cref="FileEdits.Apply" path="/returns"/>
    public Result<FileJob> Edit(FileEdits edits)
    {
        if (edits is null) throw new ArgumentNullException(nameof(edits));
        if (edits.Cut(Toolpath) is { } lower)
        {
            var rest = new FileEdits { PauseAtLayers = edits.PauseAtLayers, PauseFor = edits.PauseFor, AtLayers = edits.AtLayers, FitArcs = edits.FitArcs };
            var inserted = rest.Apply(Toolpath);
            return inserted.Value is { } all ? (this with { Toolpath = all }).KeepBelow(lower) : new Result<FileJob>(null, inserted.Diagnostics);
        }
        var edited = edits.Apply(Toolpath);
        return new Result<FileJob>(
            edited.Value is { } toolpath ? this with { Toolpath = toolpath, IsMoved = IsMoved || edits.Moves } : null, edited.Diagnostics);
    }

    /// <summary>The lower half of a print: the layers whose top is not above <paramref name="z"/> mm, a lift, and the end code.</summary>
    /// <returns>The job, or the error <c>cut.outside</c> or <c>cut.sequential</c>.</returns>
    public Result<FileJob> KeepBelow(double z)
    {
        var cut = PrintCut.At(Toolpath, z);
        return cut.Value is { } at ? new Result<FileJob>(WithCut(at.Lower(), new LineCut(at.Lines.LowerEnd + 1, at.Lines.PrintEnd, [])), [])
            : new Result<FileJob>(null, cut.Diagnostics);
    }

    /// <summary>
    /// The upper half of a print, on the lower half that stands on the bed. Before the file starts, the nozzle must touch the top of the lower half. The file
    /// states that height, homes only X and Y, heats and primes above the part, and reaches its first extrusion from above.
    /// </summary>
    /// <returns>The job and the note <c>cut.place_nozzle</c>, or an error: <c>cut.outside</c>, <c>cut.sequential</c>, or <c>cut.no_start</c> or
    /// <c>cut.no_temperature</c> if the job has no start G-code of its own (<see cref="Code"/>).</returns>
    public Result<FileJob> KeepAbove(double z)
    {
        var cut = PrintCut.At(Toolpath, z);
        if (cut.Value is not { } at) return new Result<FileJob>(null, cut.Diagnostics);
        var start = Code.Start is { } own ? new Result<IReadOnlyList<string>>(own, []) : new Continuation(File, at).Start();
        if (start.Value is not { } lines) return new Result<FileJob>(null, start.Diagnostics);
        var job = WithCut(at.Upper(), new LineCut(1, at.Lines.Upper - 1, lines, false, at.SafeHeight, true));
        return new Result<FileJob>(job, Code.Start is not null ? [] : [new Diagnostic(Severity.Note, "cut.place_nozzle",
            $"Before the upper half starts, lower the nozzle until it touches the lower half at Z {NumberFormatter.Format(at.Height, 3)} mm. "
            + $"The file homes only X and Y. {File.Flavor.HeightNeeds}".TrimEnd())]);
    }

    private FileJob WithCut(Toolpath toolpath, LineCut cut) => this with { Toolpath = toolpath, Code = Code with { Cuts = [.. Code.Cuts, cut] } };

    /// <summary>Writes the file, whole or not at all.</summary>
    /// <param name="path">The output file; .bgcode = binary. An existing file is replaced.</param>
    /// <param name="setup">The setup to check the result against before it is written; null = for an unknown printer,
    /// only whether a moved print stays on the bed, as far as the file knows it.</param>
    /// <param name="reason">Reason to write despite errors of the checks, which the file keeps as a comment; null = refuse.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels. No partial file is left.</param>
    /// <returns>The written file, or errors: <see cref="SafeWriter.Refused"/> if a check refused it.</returns>
    /// <exception cref="IOException">The disk failed.</exception>
    public Result<WrittenGCode> WriteFile(
        string path, PrintSetup? setup, string? reason = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        using var file = new AtomicFile(path);
        var written = Write(file.Stream, path, setup, reason, progress, cancel);
        if (written.Value is not null) file.Commit();
        return written;
    }

    /// <summary>Writes the file to a stream. If there is no value, discard the output.</summary>
    /// <param name="stream">The output stream.</param>
    /// <param name="name">The name of the output; .bgcode = binary.</param>
    /// <param name="setup">The setup to check the result against; null = only whether a moved print stays on the bed, as far as the file knows it.</param>
    /// <param name="reason">Reason to write despite errors of the checks; null = refuse.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels.</param>
    /// <inheritdoc cref="WriteFile" path="/returns"/>
    public Result<WrittenGCode> Write(
        Stream stream, string name, PrintSetup? setup, string? reason = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (setup is null && UnknownTool() is { } unknown) return new Result<WrittenGCode>(null, [unknown]);
        if (setup is null && IsMoved) return WriteMoved(stream, name, reason, progress, cancel);
        var source = Edited(progress.Part(0, Target is null ? 0 : 0.4), cancel);
        if (source.Value is not { } file) return new Result<WrittenGCode>(null, source.Diagnostics);
        var rest = progress.Part(Target is null ? 0 : 0.4, 1);
        // Directly into the stream, unless the whole text is needed first: for checks, or for a binary file.
        if (IsChanged && setup is null && !BinaryGCode.IsName(name))
        {
            using var counted = new CountingStream(stream);
            var problems = new Result<WrittenGCode>(null, Target is { } target ? GCodeConverter.Convert(file, target, Code, counted, rest, cancel)
                : GCodeEditor.Write(file, Toolpath, Code, counted, rest, cancel));
            return Written(problems.HasErrors ? null : new WrittenGCode(counted.Bytes, counted.Lines, 0), source.Diagnostics, problems.Diagnostics);
        }
        var (document, guard) = Whole(file, setup, reason, rest, cancel);
        if (document.Value is not { } text) return Written(null, source.Diagnostics, document.Diagnostics);
        BinaryGCode.WriteAs(name, text, stream, null, cancel);
        return Written(new WrittenGCode(text.Length, text.LineCount, guard?.Overridden ?? 0), source.Diagnostics, document.Diagnostics);
    }

    private Result<WrittenGCode> WriteMoved(Stream stream, string name, string? reason, IProgress<double>? progress, CancellationToken cancel)
    {
        var guard = new WriteGuard(PrintCheck.OfMoved(File, Toolpath, cancel), reason);
        if (guard.Refuses) return new Result<WrittenGCode>(null, guard.Refusal([]));
        var commented = guard.Comments().Aggregate(Toolpath, (toolpath, comment) => toolpath.Insert(0, new CommentEvent(comment)));
        var written = (this with { Toolpath = commented, IsMoved = false }).Write(stream, name, null, null, progress, cancel);
        return Written(written.Value is { } file ? file with { Overridden = guard.Overridden } : null, guard.Notes([]), written.Diagnostics);
    }

    // The whole text, checked if there is a setup.
    private (Result<GCodeDocument> Document, WriteGuard? Guard) Whole(
        DecodedGCode file, PrintSetup? setup, string? reason, IProgress<double>? progress, CancellationToken cancel)
    {
        // If there are only edits, they are compared with the output.
        if (setup is not null && IsEdited && Target is null && !HasOwnCode) return SafeWriter.Edited(file, Toolpath, setup, reason, null, progress, cancel);
        var text = !IsChanged ? new Result<GCodeDocument>(file.Document, []) : Target is null
            ? GCodeEditor.ToDocument(file, Toolpath, Code, progress, cancel) : GCodeConverter.ToDocument(file, Target, Code, progress.Part(0, 0.6), cancel);
        if (setup is null || text.Value is null) return (text, null);
        var (document, guard) = SafeWriter.Check(File, text.Value, _reading with { Flavor = Flavor }, setup, reason, progress.Part(0.6, 1), cancel);
        return (new Result<GCodeDocument>(document.Value, [.. text.Diagnostics, .. document.Diagnostics]), guard);
    }

    // Without a printer, the tools of the file are all that is known.
    private Diagnostic? UnknownTool()
    {
        var count = File.Toolpath.Tools.Count;
        foreach (var what in Toolpath.Events)
        {
            if (what.Event is ToolEvent { Tool: var tool } && tool >= count)
                return new Diagnostic(Severity.Error, CheckCodes.Tool, $"The edit uses tool {NumberFormatter.Format(tool)}, but the file has only "
                    + (count == 1 ? "tool 0" : $"tools 0 to {NumberFormatter.Format(count - 1)}") + ". Choose a printer with this tool (--printer).");
        }
        return null;
    }

    private bool HasOwnCode => Code.Start is not null || Code.End is not null || Code.Cuts.Count > 0;

    private bool IsEdited => !ReferenceEquals(Toolpath, File.Toolpath) || HasOwnCode;

    private bool IsChanged => IsEdited || Target is not null;

    // The file to convert, with the lines of the edited text, or else the file as it was read.
    private Result<DecodedGCode> Edited(IProgress<double>? progress, CancellationToken cancel)
    {
        if (Target is null || ReferenceEquals(Toolpath, File.Toolpath)) return new Result<DecodedGCode>(File, []);
        var edited = GCodeEditor.ToDocument(File, Toolpath, Code with { Start = null, End = null }, progress, cancel);
        return new Result<DecodedGCode>(
            edited.Value is { } text ? GCodeDecoder.Decode(text, _reading with { Flavor = File.Flavor }, null, cancel).Value : null, edited.Diagnostics);
    }

    private static Result<WrittenGCode> Written(WrittenGCode? written, IReadOnlyList<Diagnostic> first, IReadOnlyList<Diagnostic> then)
        => new(written, [.. first, .. then]);
}

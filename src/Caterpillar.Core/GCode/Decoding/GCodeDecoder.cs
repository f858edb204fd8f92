namespace Caterpillar.GCode;

/// <summary>
/// Decodes G-code into a toolpath. Any bytes can be decoded: unknown commands are counted and reported, never fatal. The rules of each firmware are data
/// (<see cref="FlavorRules"/>). The flavor <c>slicer</c> with <see cref="ExtrusionRule.Rising"/> reads files like the viewers of slicers.
/// </summary>
public static class GCodeDecoder
{
    // Without any E in this many bytes of a stream, the axis is decided from what was seen.
    private const long LongestSearch = 256L * 1024 * 1024;

    /// <summary>Decodes a document.</summary>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static Result<DecodedGCode> Decode(GCodeDocument document, DecodeOptions? options = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        if (document is null) throw new ArgumentNullException(nameof(document));
        options ??= new DecodeOptions();
        // Not worth another thread.
        if (document.Chunks.Count < 3) options = options with { Threads = 1 };
        var length = (double)document.Length;
        var input = new DecodeInput(document.Chunks, document.Chunks, ExtrusionAxis.Detect(document.Chunks), document.Name, () => document,
            done => done / length, () => document.Notes);
        return GCodeDocument.Guarded(document.Name, () => Run(input, options, progress, cancel));
    }

    /// <summary>Reads and decodes a file (plain, gzip, or binary G-code) and keeps its text, so that it can be edited or converted and written again.</summary>
    /// <exception cref="IOException">The file cannot be read.</exception>
    /// <inheritdoc cref="Decode(GCodeDocument, DecodeOptions?, IProgress{double}?, CancellationToken)" path="/exception"/>
    public static Result<DecodedGCode> DecodeFile(string path, DecodeOptions? options = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        if (path is null) throw new ArgumentNullException(nameof(path));
        using var stream = InputFile.Open(path);
        return DecodeStream(stream, (options ?? new DecodeOptions()) with { KeepsText = true }, Path.GetFileName(path), progress, cancel);
    }

    /// <summary>Decodes bytes: plain, gzip, or binary G-code.</summary>
    /// <inheritdoc cref="Decode(GCodeDocument, DecodeOptions?, IProgress{double}?, CancellationToken)" path="/exception"/>
    public static Result<DecodedGCode> Decode(byte[] bytes, DecodeOptions? options = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
        => GCodeDocument.Guarded("", () => Decode(GCodeDocument.FromBytes(bytes), options, progress, cancel));

    /// <summary>
    /// Decodes a stream while reading it. Only the moves are kept in memory, not the text. The stream may be gzip or binary G-code. It stays open. A broken
    /// stream gives an error. Progress is reported if the length of the stream is known.
    /// </summary>
    /// <exception cref="IOException">The stream cannot be read.</exception>
    /// <inheritdoc cref="Decode(GCodeDocument, DecodeOptions?, IProgress{double}?, CancellationToken)" path="/exception"/>
    public static Result<DecodedGCode> DecodeStream(
        Stream stream, DecodeOptions? options = null, string name = "", IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (stream is null) throw new ArgumentNullException(nameof(stream));
        return GCodeDocument.Guarded(name, () =>
        {
            using var source = new GCodeSource(stream);
            return DecodeSource(source, options ?? new DecodeOptions(), name, progress, cancel);
        });
    }

    private static Result<DecodedGCode> DecodeSource(GCodeSource source, DecodeOptions options, string name, IProgress<double>? progress,
        CancellationToken cancel)
    {
        var tail = source.Tail();
        var text = options.KeepsText ? new List<GCodeChunk>() : null;
        var read = ChunkReader.Read(source.Text, options.ChunkSize, cancel);
        if (tail is not null && options.OnlyEnds) read = read.Take((1 << 20) / options.ChunkSize).Append(tail);
        using var chunks = (text is null ? read : GCodeDocument.Kept(read, text, options.Memory)).GetEnumerator();
        var head = new List<GCodeChunk>();
        var seen = 0L;
        IEnumerable<GCodeChunk> Head()
        {
            while (seen < LongestSearch && chunks.MoveNext())
            {
                head.Add(chunks.Current);
                seen += chunks.Current.Length;
                yield return chunks.Current;
            }
        }
        IEnumerable<GCodeChunk> All()
        {
            for (var i = 0; i < head.Count; i++)
            {
                yield return head[i];
                head[i] = null!;
            }
            foreach (var chunk in Rest()) yield return chunk;
        }
        IEnumerable<GCodeChunk> Rest()
        {
            while (chunks.MoveNext()) yield return chunks.Current;
        }
        var axis = ExtrusionAxis.Detect(Head());
        // The end of binary G-code is known once reading has begun, and that of a pipe or packed text when all of it is read.
        tail ??= source.Tail();
        if (tail is null && options.Flavor is null && FlavorDetector.Detect(head, axis).IsDefault)
            head.AddRange(text is null ? GCodeDocument.Kept(Rest(), [], options.Memory) : Rest());
        var searched = new List<GCodeChunk>(head);
        if (tail is not null) searched.Add(tail);
        // The style of the file is that of its first lines.
        while (options.Follow is not null && head.Sum(c => c.CountLines()) < LineStyle.Sample && chunks.MoveNext()) head.Add(chunks.Current);
        Func<GCodeDocument>? document = text is null ? null : () => new GCodeDocument(text.ToArray(), name, source.Notes());
        return Run(new DecodeInput(All(), searched, axis, name, document, source.Done, source.Notes, head.ToArray()), options, progress, cancel);
    }

    private static Result<DecodedGCode> Run(DecodeInput input, DecodeOptions options, IProgress<double>? progress, CancellationToken cancel)
    {
        var name = input.Name;
        var detected = options.Flavor is null ? FlavorDetector.Detect(input.Searched, input.Axis) : (Detection?)null;
        var rules = options.Flavor ?? detected!.Value.Flavor;
        var axis = input.Axis.In(rules);
        var interpreter = new GCodeInterpreter(rules, options.Rule, axis);
        interpreter.Machine.Moves.Begin(options.NewBlocks, options.Take, options.Sums);
        interpreter.Machine.Moves.Layers.Heights = options.Heights;
        interpreter.Machine.Moves.Layers.AreAlike = options is { KeepsMoves: false, Take: not null };
        interpreter.Machine.Moves.Layers.Numbers = options.Before?.LayerNumbers;
        var problems = interpreter.Machine.Diagnostics.List;
        if (axis != input.Axis && (input.Axis == ExtrusionAxis.E || input.Axis == ExtrusionAxis.Switched))
            problems.Add(Severity.Warning, "gcode.no_extruder", rules.Title + " has no extruder on " + input.Axis.Name + ". Extrusion is left out.");
        var lines = 0;
        var mark = false;
        var checkpoints = input.Document is not null ? new List<Checkpoint>() : null;
        var follow = options.Follow?.Invoke(
            new DecodedGCode(
                options.Before?.Toolpath ?? new Toolpath([], [], [], [new ToolpathTool(null)], null, MoveSource.Lines), new DecodeReport(interpreter), rules)
            {
                Document = new GCodeDocument(input.First!, name), Rule = options.Rule, Axis = axis, LastModeLine = int.MaxValue,
            });
        long bytes = 0;
        ChunkPipeline.Run(
            input.Chunks,
            axis.Letter,
            options.Degree,
            _ => true,
            (parsed, done) =>
            {
                var parser = parsed.Value;
                if (lines == 0) mark = TextEncoding.MarkLength(parser.Chunk!) > 0;
                checkpoints?.Add(new Checkpoint(lines, interpreter.Save()));
                follow?.Invoke(parser, new Checkpoint(lines, interpreter.Save()));
                interpreter.Run(parser, lines);
                lines = GCodeDocument.AddLines(lines, parser.Count);
                bytes = done;
                if (progress is not null && input.Share(done) is >= 0 and var part) progress.Report(part);
            },
            cancel);
        problems.AddRange(input.Notes());
        interpreter.Machine.Log.Report();
        if (detected is { IsDefault: true }) ReportDefault(rules, interpreter.Comments.Settings, problems);
        var settings = interpreter.Comments.Settings.ToDictionary(p => p.Key, p => p.Value, StringComparer.Ordinal);
        var toolpath = interpreter.ToToolpath(FilamentFactors.Of(settings, options.FilamentDiameter));
        var none = FileKind.NotGCode(input.Searched.Count > 0 ? input.Searched[0] : null, bytes, lines, interpreter.Machine.Counters.Commands);
        IReadOnlyList<Diagnostic> diagnostics = problems.ToList();
        if (name.Length > 0) diagnostics = diagnostics.Select(d => d with { Source = (d.Source ?? new SourceLocation()) with { File = name } }).ToList();
        var hasAmounts = axis.HasAmounts || axis == ExtrusionAxis.None;
        var report = new DecodeReport(interpreter) { File = name, Bytes = bytes, ExtrusionAxis = axis.Name, HasAmounts = hasAmounts, ByteOrderMark = mark };
        return new Result<DecodedGCode>(
            new DecodedGCode(toolpath, report, rules)
            {
                Document = input.Document?.Invoke(),
                Evidence = detected?.Evidence ?? [],
                Settings = settings,
                Ignored = interpreter.Machine.Log.Ignored.ToDictionary(p => p.Key, p => p.Value, StringComparer.Ordinal),
                Problems = diagnostics,
                Used = interpreter.Machine.Log.Used,
                Rule = options.Rule,
                Checkpoints = checkpoints?.ToArray() ?? [],
                Axis = axis,
                LastModeLine = interpreter.Machine.LastModeLine,
                FirstLayerLine = interpreter.Comments.FirstLayerLine,
                HasExpectedLayers = interpreter.Machine.Moves.Layers.AreExpected,
                LayerNumbers = interpreter.Machine.Moves.Layers.Numbers,
                NotGCode = none is null || name.Length == 0 ? none : none with { Source = new SourceLocation(name) },
            },
            diagnostics);
    }

    private static void ReportDefault(FlavorRules rules, IReadOnlyDictionary<string, string> settings, DiagnosticList problems)
    {
        problems.Add(Severity.Note, "gcode.flavor_default", FlavorDetector.NotStated + " It was read as " + rules.Title + ".");
        if (!settings.TryGetValue("gcode_flavor", out var flavor) || FlavorDetector.OfSlicerFlavor(flavor) is not { } meant || meant == rules.Name) return;
        problems.Add(Severity.Warning, "gcode.flavor_mismatch", "The settings at the end of the file name the G-code flavor \"" + flavor
            + "\", but the file was read as " + rules.Title + ". Choose the flavor.");
    }

    // What is decoded: the chunks of a text, those in which the flavor is looked for, the document if the text is kept, the part that is done after a number of
    // bytes (less than 0 if unknown), what its source knows of it in the end, and the first chunks of a stream.
    private sealed record DecodeInput(
        IEnumerable<GCodeChunk> Chunks, IReadOnlyList<GCodeChunk> Searched, ExtrusionAxis Axis, string Name, Func<GCodeDocument>? Document,
        Func<long, double> Share, Func<IReadOnlyList<Diagnostic>> Notes, GCodeChunk[]? First = null);
}

namespace Caterpillar.Checks;

/// <summary>
/// Checks G-code, new or edited, and writes it if the checks find no error. A reason in words overrides errors; it is written into the file as a comment.
/// </summary>
public static class SafeWriter
{
    /// <summary>Code of the error if nothing was written.</summary>
    public const string Refused = "write.refused";

    /// <summary>Code of the error about a number that cannot be written; no reason overrides it.</summary>
    public const string InvalidNumber = "write.invalid_number";

    /// <summary>Checks a toolpath and writes it as a file, whole or not at all.</summary>
    /// <param name="toolpath">The toolpath.</param>
    /// <param name="setup">Its printer, material and settings.</param>
    /// <param name="path">The file: binary G-code if the name ends in .bgcode. An existing file is replaced.</param>
    /// <param name="reason">Why errors of the checks are ignored; null = do not write if there are errors.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels; no part of the file is left.</param>
    /// <returns>The size of the file. If it was refused: no value, the findings and <see cref="Refused"/>.</returns>
    /// <exception cref="IOException">The file cannot be written.</exception>
    public static Result<WrittenGCode> WriteFile(
        Toolpath toolpath, PrintSetup setup, string path, string? reason = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        using var file = new AtomicFile(path);
        Result<WrittenGCode>? written = null;
        BinaryGCode.WriteAs(path, file.Stream, text => written = Write(toolpath, setup, text, reason, progress, cancel, true), cancel);
        if (written!.Value is not null) file.Commit();
        return written;
    }

    /// <summary>
    /// Checks a toolpath and writes it to a stream, as text; nothing is written if it is refused. A draft, for temporary files, is checked while it is written,
    /// in one pass: if it is refused, delete what was written.
    /// </summary>
    /// <inheritdoc cref="WriteFile(Toolpath, PrintSetup, string, string?, IProgress{double}?, CancellationToken)" path="/param"/>
    internal static Result<WrittenGCode> Write(
        Toolpath toolpath, PrintSetup setup, Stream stream, string? reason = null, IProgress<double>? progress = null, CancellationToken cancel = default,
        bool isDraft = false, (PrintDraft? Draft, PlanTiming? Timing) begun = default, bool isChecked = false)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        if (stream is null) throw new ArgumentNullException(nameof(stream));
        if (PrintableNumbers.Check(toolpath) is { } unprintable)
        {
            // Places far away are outside every machine, which the checks say in other words; they can compute with numbers below this.
            const double Finite = 1e100;
            var found = new WriteGuard(PrintableNumbers.Check(toolpath, Finite) is null ? PrintCheck.Run(toolpath, setup, progress, cancel) : [], null);
            return new Result<WrittenGCode>(null, found.Refusal(found.Refuses ? [] : [unprintable]));
        }
        var format = SetupFormat.Of(setup, toolpath);
        if (format.Value is null) return new Result<WrittenGCode>(null, new WriteGuard([], reason).Refusal(format.Diagnostics));
        var (timed, seconds) = ProgressCommands.Add(toolpath, setup, begun.Timing?.Finish(), cancel);
        foreach (var mapping in setup.Printer.AxisMappings) timed = mapping.Apply(timed, null, cancel);
        timed = setup.Printer.ToMachine(timed, cancel);
        var plain = format.Value with { Facts = FileFacts.Of(timed, setup, format.Value, seconds, cancel) };
        // With a reason what was found stands at the top of the file: it is written again, where something was.
        var isOverridden = WriteGuard.IsReason(reason);
        var direct = isDraft && (!isOverridden || stream.CanSeek);
        var part = progress.Part(0, direct ? 1 : 0.7);
        var (findings, lines, bytes, read) = begun.Draft is { } draft ? draft.Finish(toolpath, timed, plain, direct ? stream : null, part)
            : WriteAndCheck(timed, setup, plain, direct ? stream : null, part, isChecked, cancel);
        if (findings is null) (findings, _, _, read) = WriteAndCheck(timed, setup, plain, null, null, isChecked, cancel);
        var guard = new WriteGuard(findings!, reason);
        if (guard.Refuses) return new Result<WrittenGCode>(null, guard.Refusal(format.Diagnostics));
        if (!direct || guard.Overridden > 0)
        {
            // The position goes back with the end.
            if (direct) stream.SetLength(stream.Position - bytes);
            var writer = new GCodeWriter(timed, plain with { Header = [.. guard.Comments(), .. plain.Header] });
            writer.WriteAll(stream, direct ? null : progress.Part(0.7, 1), cancel);
            (lines, bytes) = (writer.Lines, writer.Bytes);
        }
        var tail = FileComments.Tail(setup, toolpath, seconds);
        stream.Write(tail.Bytes, 0, tail.Bytes.Length);
        var file = new WrittenGCode(bytes + tail.Bytes.Length, lines + tail.Lines, guard.Overridden, read?.Seconds) { File = read?.File };
        return new Result<WrittenGCode>(file, guard.Notes(format.Diagnostics));
    }

    private static CheckedGCode WriteAndCheck(
        Toolpath toolpath, PrintSetup setup, GCodeFormat format, Stream? stream, IProgress<double>? progress, bool isChecked, CancellationToken cancel)
    {
        if (!ReadBack.IsAsked(setup))
        {
            var writer = new GCodeWriter(toolpath, format);
            if (stream is not null) writer.WriteAll(stream, progress, cancel);
            return new CheckedGCode([], writer.Lines, writer.Bytes, null);
        }
        using var back = new ReadBack(toolpath, setup, format, stream, true, cancel, isChecked);
        back.Write(toolpath, progress.Part(0, 0.5));
        back.End(format);
        return new CheckedGCode(back.Finish(progress.Part(0.5, 1)), back.Size.Lines, back.Size.Bytes, back.Read);
    }

    /// <summary>
    /// Checks a toolpath and writes it as a document in memory. If <see cref="PrintCheck"/> found no error in this toolpath with this setup
    /// (<paramref name="isChecked"/>), collisions and extrusions are not checked again, unless the start or end code prints.
    /// </summary>
    /// <inheritdoc cref="WriteFile(Toolpath, PrintSetup, string, string?, IProgress{double}?, CancellationToken)" path="/param"/>
    public static Result<GCodeDocument> ToDocument(
        Toolpath toolpath, PrintSetup setup, string? reason = null, IProgress<double>? progress = null, CancellationToken cancel = default,
        bool isChecked = false)
    {
        using var memory = new MemoryStream();
        var written = Write(toolpath, setup, memory, reason, progress, cancel, true, default, isChecked);
        return new Result<GCodeDocument>(written.Value is null ? null : GCodeDocument.FromBytes(memory.ToArray()), written.Diagnostics);
    }

    /// <summary>Checks an edited toolpath and writes its file again. Lines that no edit touches keep their bytes.</summary>
    /// <param name="decoding">The decoded file.</param>
    /// <param name="edited">Its toolpath after the edits.</param>
    /// <param name="setup">The printer, material and settings to check against.</param>
    /// <param name="reason">Why errors of the checks are ignored, as a comment for the file; null = do not write if there are errors.</param>
    /// <param name="code">New start and end code. Messages then name the lines of the new file.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels.</param>
    /// <returns>The file. If it was refused: no value, the findings and <see cref="Refused"/>.</returns>
    /// <exception cref="ArgumentException">The file was decoded from a stream, without its document.</exception>
    public static Result<GCodeDocument> ToDocument(
        DecodedGCode decoding, Toolpath edited, PrintSetup setup, string? reason = null, EditOptions? code = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
        => Edited(decoding, edited, setup, reason, code, progress, cancel).Document;

    /// <summary>Checks an edited file and compares it with the edits.</summary>
    internal static (Result<GCodeDocument> Document, WriteGuard? Guard) Edited(
        DecodedGCode decoding, Toolpath edited, PrintSetup setup, string? reason, EditOptions? code, IProgress<double>? progress, CancellationToken cancel)
    {
        if (decoding is null) throw new ArgumentNullException(nameof(decoding));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        var before = decoding;
        if (code is { Start: not null } or { End: not null })
        {
            var replaced = GCodeEditor.ToDocument(decoding, edited, code, null, cancel);
            if (replaced.Value is null) return (replaced, null);
            var options = new DecodeOptions { Flavor = decoding.Flavor, Rule = decoding.Rule, FilamentDiameter = setup.Material.FilamentDiameter };
            decoding = GCodeDecoder.Decode(replaced.Value, options, null, cancel).Value!;
            edited = decoding.Toolpath;
        }
        var written = GCodeEditor.ToDocument(decoding, edited, null, progress.Part(0, 0.4), cancel);
        if (written.Value is null) return (written, null);
        var findings = EditCheck.Run(decoding, edited, written.Value, setup, progress.Part(0.4, 0.8), cancel, before);
        var guard = new WriteGuard(findings, reason);
        if (guard.Refuses) return (new Result<GCodeDocument>(null, guard.Refusal(written.Diagnostics)), guard);
        if (guard.Overridden > 0)
        {
            foreach (var comment in guard.Comments()) edited = edited.Insert(0, new CommentEvent(comment));
            written = GCodeEditor.ToDocument(decoding, edited, null, progress.Part(0.8, 1), cancel);
        }
        progress?.Report(1);
        return (new Result<GCodeDocument>(written.Value, guard.Notes(written.Diagnostics)), guard);
    }

    /// <summary>Checks the text of a file that was edited or converted before. Messages name its lines.</summary>
    internal static (Result<GCodeDocument> Document, WriteGuard? Guard) Check(
        DecodedGCode before, GCodeDocument text, DecodeOptions reading, PrintSetup setup, string? reason, IProgress<double>? progress, CancellationToken cancel)
    {
        var file = GCodeDecoder.Decode(text, reading with { FilamentDiameter = setup.Material.FilamentDiameter }, null, cancel).OrThrow();
        var checks = PrintCheck.RunFile(file, setup, before, progress, cancel);
        var guard = new WriteGuard([.. checks, .. DecodingNotes.Of(file, before)], reason);
        if (guard.Refuses) return (new Result<GCodeDocument>(null, guard.Refusal([])), guard);
        var commented = new Result<GCodeDocument>(text, []);
        if (guard.Overridden > 0)
        {
            var edited = guard.Comments().Aggregate(file.Toolpath, (toolpath, comment) => toolpath.Insert(0, new CommentEvent(comment)));
            commented = GCodeEditor.ToDocument(file, edited, cancel: cancel);
        }
        return (new Result<GCodeDocument>(commented.Value, guard.Notes(commented.Diagnostics)), guard);
    }
}

namespace Caterpillar.GCode;

/// <summary>
/// Converts a decoded file to another G-code flavor or notation. Lines with the same meaning do not change. The others change in the style of the file.
/// </summary>
internal static class GCodeConverter
{
    /// <summary>Converts a file that was decoded with its document, perhaps with start and end G-code for the target.</summary>
    /// <returns>The diagnostics. If they contain errors, nothing was written.</returns>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static IReadOnlyList<Diagnostic> Convert(DecodedGCode decoding, ConvertOptions options, EditOptions? code, Stream stream,
        IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        var problems = new DiagnosticList();
        using var splicer = Begin(decoding, options, code, stream, problems);
        if (splicer is null) return problems.ToList();
        if (Rounded(decoding, options) is { } rounded) return [.. problems.ToList(), rounded];
        splicer.Run(progress, cancel);
        problems.AddRange(splicer.Diagnostics.ToList());
        return problems.ToList();
    }

    /// <summary>
    /// Converts a file to another notation of its own flavor, edits it, or copies it without options, while it is decoded, so that its text is parsed once, and
    /// neither text nor moves are kept. If there are errors, discard the output.
    /// </summary>
    public static Result<DecodedGCode> WhileDecoding(
        Func<DecodeOptions, DecodedGCode> decode, DecodeOptions reading, ConvertOptions? options, Stream stream, FollowingEditor? editor = null)
    {
        var problems = new DiagnosticList();
        Splicer? splicer = null;
        // Of one chunk, while the next is decoded.
        var work = Task.CompletedTask;
        void Later(ChunkParser parsed, Action write)
        {
            work.GetAwaiter().GetResult();
            work = Task.Run(() =>
            {
                write();
                parsed.IsHeld = false;
            });
        }
        void Follow(ChunkParser parsed, Checkpoint before)
        {
            parsed.IsHeld = true;
            if (editor is not null) editor.Take(parsed, before);
            else if (splicer is null) Later(parsed, () => parsed.Chunk!.WriteTo(stream));
            else Later(parsed, () => splicer.Write(parsed, before, null, null));
        }
        try
        {
            var decoding = decode(reading with
            {
                KeepsMoves = false,
                Before = editor?.Whole.Before,
                Take = editor is null ? null : editor.Take,
                Follow = known =>
                {
                    if (editor is null) splicer = options is null ? null : Begin(known, options, null, stream, problems);
                    else
                    {
                        splicer = new Splicer(known, editor.Whole.After ?? known.Toolpath, new SplicePlan(), stream);
                        editor.Writer = (parsed, before, moves, edited) => Later(parsed, () => splicer.Write(parsed, before, moves, edited));
                    }
                    return Follow;
                },
            });
            editor?.Finish();
            work.GetAwaiter().GetResult();
            splicer?.Finish();
            problems.AddRange(splicer?.Diagnostics.ToList() ?? []);
            var rounded = options is null ? null : Rounded(decoding, options);
            return rounded is null ? new Result<DecodedGCode>(decoding, problems.ToList()) : new Result<DecodedGCode>(null, [rounded]);
        }
        finally
        {
            OwnThread.Wait(work);
            splicer?.Dispose();
        }
    }

    private static Splicer? Begin(DecodedGCode decoding, ConvertOptions options, EditOptions? code, Stream stream, DiagnosticList problems)
        => ConvertTarget.Of(decoding, options, problems) is not { } target ? null
            : new Splicer(decoding, decoding.Toolpath, new SplicePlan(), stream, target,
                (code ?? new EditOptions()) with { Cuts = [], Threads = options.Threads });

    private static Diagnostic? Rounded(DecodedGCode decoding, ConvertOptions options)
        => options.DecimalsXyz is { } decimals ? LayerRounding.Check(decoding.Toolpath, decimals, new SourceLocation(decoding.Report.File)) : null;

    /// <inheritdoc cref="Convert" path="/summary"/>
    public static Result<GCodeDocument> ToDocument(DecodedGCode decoding, ConvertOptions options, EditOptions? code = null,
        IProgress<double>? progress = null, CancellationToken cancel = default)
        => DocumentStream.Collect(stream => Convert(decoding, options, code, stream, progress, cancel), decoding.Document?.Name);
}

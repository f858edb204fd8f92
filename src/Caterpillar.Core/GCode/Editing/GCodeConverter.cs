namespace Caterpillar.GCode;

/// <summary>
/// Converts a decoded file to another G-code flavor or notation. Lines with the same meaning do not change. The others change in the style of the file.
/// </summary>
internal static class GCodeConverter
{
    /// <summary>Converts a file that was decoded with its document, perhaps with start and end G-code for the target.</summary>
    /// <returns>The diagnostics. If they contain errors, nothing was written.</returns>
    /// <exception cref="ArgumentException">The file was decoded from a stream, without its document.</exception>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static IReadOnlyList<Diagnostic> Convert(DecodedGCode decoding, ConvertOptions options, EditOptions? code, Stream stream,
        IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (decoding.Document is null) throw new ArgumentException(GCodeEditor.NoDocument, nameof(decoding));
        var problems = new DiagnosticList();
        var target = ConvertTarget.Of(decoding, options, problems);
        if (target is null) return problems.ToList();
        if (options.DecimalsXyz is { } decimals && LayerRounding.Check(decoding.Toolpath, decimals, new SourceLocation(decoding.Document.Name)) is { } rounded)
            return [.. problems.ToList(), rounded];
        using var splicer = new Splicer(decoding, decoding.Toolpath, SplicePlan.Of(decoding, decoding.Toolpath), stream, target,
            (code ?? new EditOptions()) with { Cuts = [], Threads = options.Threads });
        splicer.Run(progress, cancel);
        problems.AddRange(splicer.Diagnostics.ToList());
        return problems.ToList();
    }

    /// <inheritdoc cref="Convert" path="/summary"/>
    public static Result<GCodeDocument> ToDocument(DecodedGCode decoding, ConvertOptions options, EditOptions? code = null,
        IProgress<double>? progress = null, CancellationToken cancel = default)
        => DocumentStream.Collect(stream => Convert(decoding, options, code, stream, progress, cancel), decoding.Document?.Name);
}

using Caterpillar.Basics;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>What else is changed in a file that is written again.</summary>
public sealed record EditOptions
{
    /// <summary>
    /// Lines in place of everything before the first layer (its first comment, or the first extrusion where there are none); null keeps it. After them the
    /// modes, E, feed rate and position that the rest of the file expects are stated.
    /// </summary>
    public IReadOnlyList<string>? Start { get; init; }

    /// <summary>Lines in place of everything after the last extrusion of the last layer; null keeps it.</summary>
    public IReadOnlyList<string>? End { get; init; }

    /// <summary>Threads; 0 for all cores. The result does not depend on it.</summary>
    public int Threads { get; init; }

    /// <summary>Every number of every motion is written again, also of those that did not change.</summary>
    internal bool RewriteAll { get; init; }

    /// <summary>For comparison: every line takes the general path.</summary>
    internal bool GeneralPath { get; init; }
}

/// <summary>
/// Writes a decoded file again with an edited toolpath: untouched lines byte for byte, changed ones in the file's own style, and at the splices the state that
/// the rest of the file expects.
/// </summary>
internal static class GCodeEditor
{
    public const string NoDocument = "The decoded file has no document. Decode it from a document or a file, not from a stream.";

    /// <summary>
    /// Writes the file with the moves of <paramref name="edited"/>, which comes from the decoding's toolpath by edits that keep the order of its moves.
    /// </summary>
    /// <returns>What was noticed; with errors nothing was written.</returns>
    /// <exception cref="ArgumentException">The file was decoded from a stream, without its document.</exception>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static IReadOnlyList<Diagnostic> Write(
        DecodedGCode decoding, Toolpath edited, EditOptions options, Stream stream, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (decoding is null) throw new ArgumentNullException(nameof(decoding));
        if (edited is null) throw new ArgumentNullException(nameof(edited));
        if (options is null) throw new ArgumentNullException(nameof(options));
        if (decoding.Document is null) throw new ArgumentException(NoDocument, nameof(decoding));
        var plan = SplicePlan.Of(decoding, edited);
        if (!plan.InOrder || edited.Source != MoveSource.Lines)
            return [new Diagnostic(Severity.Error, "gcode.reordered",
                "The moves are not in the order of the file's lines. Write the toolpath as new G-code instead.")];
        var splicer = new Splicer(decoding, edited, plan, stream, options: options);
        splicer.Run(progress, cancel);
        return splicer.Diagnostics.ToList();
    }

    /// <inheritdoc cref="Write" path="/summary"/>
    public static Result<GCodeDocument> ToDocument(DecodedGCode decoding, Toolpath edited, IProgress<double>? progress = null,
        CancellationToken cancel = default)
        => ToDocument(decoding, edited, new EditOptions(), progress, cancel);

    /// <inheritdoc cref="ToDocument(DecodedGCode, Toolpath, IProgress{double}?, CancellationToken)"/>
    public static Result<GCodeDocument> ToDocument(DecodedGCode decoding, Toolpath edited, EditOptions options, IProgress<double>? progress = null,
        CancellationToken cancel = default)
    {
        using var memory = new DocumentStream();
        var problems = Write(decoding, edited, options, memory, progress, cancel);
        var failed = new Result<GCodeDocument>(null, problems);
        return failed.HasErrors ? failed : new Result<GCodeDocument>(memory.ToDocument(decoding.Document!.Name), problems);
    }
}

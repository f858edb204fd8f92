namespace Caterpillar.GCode;

/// <summary>Options for writing an edited file.</summary>
public sealed record EditOptions
{
    /// <summary>
    /// Start G-code in place of everything before the first layer (its first comment, or the first extrusion). Null = no change. The modes, E, feed rate and
    /// position that the rest of the file expects are written after it.
    /// </summary>
    public IReadOnlyList<string>? Start { get; init; }

    /// <summary>End G-code in place of everything after the last extrusion of the last layer. Null = no change.</summary>
    public IReadOnlyList<string>? End { get; init; }

    /// <summary>Number of threads. 0 = all cores. The result does not depend on it.</summary>
    public int Threads { get; init; }

    /// <summary>Lines that are left out.</summary>
    internal IReadOnlyList<LineCut> Cuts { get; init; } = [];

    /// <summary>Disables the fast path, for comparison.</summary>
    internal bool GeneralPath { get; init; }
}

/// <summary>
/// Writes a decoded file with an edited toolpath: unchanged lines byte for byte, changed lines in the style of the file, and at the splices the state that the
/// rest of the file expects.
/// </summary>
internal static class GCodeEditor
{
    /// <summary>Writes the file with the moves of <paramref name="edited"/>: the decoded toolpath after edits that keep the order of its moves.</summary>
    /// <returns>The diagnostics. If they contain errors, nothing was written.</returns>
    /// <exception cref="IOException">The stream cannot be written.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public static IReadOnlyList<Diagnostic> Write(
        DecodedGCode decoding, Toolpath edited, EditOptions options, Stream stream, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (!SplicePlan.IsInOrder(edited) || edited.Source != MoveSource.Lines)
            return [new Diagnostic(Severity.Error, "gcode.reordered",
                "The moves are not in the order of the file's lines. Write the toolpath as new G-code instead.")];
        using var splicer = new Splicer(decoding, edited, SplicePlan.Of(decoding, edited), stream, options: options);
        splicer.Run(progress, cancel);
        return splicer.Diagnostics.ToList();
    }

    /// <inheritdoc cref="Write" path="/summary"/>
    public static Result<GCodeDocument> ToDocument(DecodedGCode decoding, Toolpath edited, EditOptions? options = null, IProgress<double>? progress = null,
        CancellationToken cancel = default)
        => DocumentStream.Collect(stream => Write(decoding, edited, options ?? new EditOptions(), stream, progress, cancel), decoding.Document?.Name);
}

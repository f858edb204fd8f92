using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Files;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>
/// The guard in front of the G-code writer: what would hurt the machine is not written. An override is a reason in words, which stays in the file as a comment.
/// </summary>
public static class SafeWriter
{
    /// <summary>Code of the error that says that nothing was written.</summary>
    public const string Refused = "write.refused";

    /// <summary>Checks a toolpath and writes it as a file, whole or not at all.</summary>
    /// <param name="toolpath">What to write.</param>
    /// <param name="setup">The printer, material and settings it is for.</param>
    /// <param name="path">The file, binary where its name ends in .bgcode; an older one is replaced.</param>
    /// <param name="reason">Why findings of the checks are to be ignored; null where they are not.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels; nothing is left behind.</param>
    /// <returns>What was written, or none with the findings and <see cref="Refused"/>.</returns>
    /// <exception cref="IOException">The disk failed.</exception>
    public static Result<WrittenGCode> WriteFile(
        Toolpath toolpath, PrintSetup setup, string path, string? reason = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (Prepare(toolpath, setup, reason, progress.Part(0, 0.2), cancel, out var problems,
            out var overridden) is not { } format) return new Result<WrittenGCode>(null, problems.ToList());
        using var file = new AtomicFile(path);
        using var text = BinaryGCode.IsName(path) ? new MemoryStream() : null;
        var written = Write(toolpath, format, text ?? file.Stream, overridden, progress.Part(0.2, 1), cancel);
        if (text is not null) BinaryGCode.Write(GCodeDocument.FromBytes(text.ToArray()), file.Stream, null, cancel);
        file.Commit();
        return new Result<WrittenGCode>(written, problems.ToList());
    }

    /// <summary>Checks a toolpath and writes it to a stream; nothing is written where it is refused.</summary>
    /// <inheritdoc cref="WriteFile" path="/param"/>
    public static Result<WrittenGCode> Write(
        Toolpath toolpath, PrintSetup setup, Stream stream, string? reason = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (stream is null) throw new ArgumentNullException(nameof(stream));
        if (Prepare(toolpath, setup, reason, progress.Part(0, 0.2), cancel, out var problems,
            out var overridden) is not { } format) return new Result<WrittenGCode>(null, problems.ToList());
        return new Result<WrittenGCode>(Write(toolpath, format, stream, overridden, progress.Part(0.2, 1), cancel), problems.ToList());
    }

    /// <summary>Checks a toolpath and writes it as a document in memory.</summary>
    /// <inheritdoc cref="WriteFile" path="/param"/>
    public static Result<GCodeDocument> ToDocument(
        Toolpath toolpath, PrintSetup setup, string? reason = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        using var memory = new MemoryStream();
        var written = Write(toolpath, setup, memory, reason, progress, cancel);
        return new Result<GCodeDocument>(written.Value is null ? null : GCodeDocument.FromBytes(memory.ToArray()), written.Diagnostics);
    }

    private static WrittenGCode Write(Toolpath toolpath, GCodeFormat format, Stream stream, int overridden, IProgress<double>? progress,
        CancellationToken cancel)
    {
        var writer = new GCodeWriter(toolpath, format);
        writer.WriteStart(stream);
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            cancel.ThrowIfCancellationRequested();
            progress?.Report((double)block / toolpath.Blocks.Count);
            writer.WriteBlock(stream, block);
        }
        writer.WriteEnd(stream);
        progress?.Report(1);
        return new WrittenGCode(writer.Bytes, writer.Lines, overridden);
    }

    private static GCodeFormat? Prepare(
        Toolpath toolpath, PrintSetup setup, string? reason, IProgress<double>? progress, CancellationToken cancel, out DiagnosticList problems,
            out int overridden)
    {
        problems = new DiagnosticList();
        overridden = 0;
        var findings = LimitCheck.Run(toolpath, setup, progress, cancel);
        var errors = findings.Where(d => d.Severity == Severity.Error).ToArray();
        var format = SetupFormat.Of(setup, toolpath);
        if (format.Value is null || (errors.Length > 0 && !IsReason(reason)))
        {
            problems.AddRange(findings);
            problems.AddRange(format.Diagnostics);
            var why = reason is not null && !IsReason(reason) ? "An override needs a reason in words." : "Nothing was written.";
            problems.Add(Severity.Error, Refused, why);
            return null;
        }
        problems.AddRange(findings.Select(d => d.Severity == Severity.Error ? d with { Severity = Severity.Warning } : d));
        problems.AddRange(format.Diagnostics);
        if (errors.Length == 0) return format.Value;
        overridden = errors.Sum(e => e.Count);
        return format.Value with { Header = [.. format.Value.Header, .. Comments(errors, reason!)] };
    }

    // A word has a letter; "1" or "!!!" say nothing to the one who reads the file later.
    internal static bool IsReason(string? reason) => reason is not null && reason.Any(char.IsLetter);

    internal static IEnumerable<string> Comments(IReadOnlyList<Diagnostic> errors, string reason)
    {
        yield return "Written in spite of these findings. Reason: "
            + string.Join(" ", reason.Split([' ', '\t', '\r', '\n'], StringSplitOptions.RemoveEmptyEntries));
        foreach (var error in errors) yield return error.ToString();
    }
}

using System;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>
/// The guard in front of <see cref="GCodeEditor"/>: a decoded file is written again around its edits only where nothing in it would hurt the machine, or a
/// reason says why all the same.
/// </summary>
public static class SafeEditor
{
    /// <summary>Checks an edited toolpath and writes the file that it was decoded from again: untouched lines byte for byte.</summary>
    /// <param name="decoding">The decoded file.</param>
    /// <param name="edited">Its toolpath after the edits.</param>
    /// <param name="setup">The printer, material and settings that it is checked against.</param>
    /// <param name="reason">Why findings of the checks are to be ignored, in words that stay in the file as a comment; null where they are not.</param>
    /// <param name="code">Other start and end code; with it what is written is what is checked, and lines in messages are its.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels.</param>
    /// <returns>The file, or none with the findings and <see cref="SafeWriter.Refused"/>.</returns>
    /// <exception cref="ArgumentException">The file was decoded from a stream, without its document.</exception>
    public static Result<GCodeDocument> ToDocument(
        DecodedGCode decoding, Toolpath edited, PrintSetup setup, string? reason = null, EditOptions? code = null, IProgress<double>? progress = null,
            CancellationToken cancel = default)
    {
        if (decoding is null) throw new ArgumentNullException(nameof(decoding));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        if (code is { Start: not null } or { End: not null })
        {
            var replaced = GCodeEditor.ToDocument(decoding, edited, code, null, cancel);
            if (replaced.Value is null) return replaced;
            var options = new DecodeOptions { Dialect = decoding.Dialect, Rule = decoding.Rule, FilamentDiameter = setup.Material.FilamentDiameter };
            decoding = GCodeDecoder.Decode(replaced.Value, options, null, cancel).Value!;
            edited = decoding.Toolpath;
        }
        var findings = LimitCheck.Run(edited, ForFile(setup, edited), progress.Part(0, 0.2), cancel);
        var errors = findings.Where(d => d.Severity == Severity.Error).ToArray();
        var problems = new DiagnosticList();
        if (errors.Length > 0 && !SafeWriter.IsReason(reason))
        {
            problems.AddRange(findings);
            problems.Add(Severity.Error, SafeWriter.Refused, reason is null ? "Nothing was written." : "An override needs a reason in words.");
            return new Result<GCodeDocument>(null, problems.ToList());
        }
        problems.AddRange(findings.Select(d => d.Severity == Severity.Error ? d with { Severity = Severity.Warning } : d));
        if (errors.Length > 0)
        {
            foreach (var comment in SafeWriter.Comments(errors, reason!).Reverse()) edited = edited.Insert(0, new CommentEvent(comment));
        }
        var written = GCodeEditor.ToDocument(decoding, edited, progress.Part(0.2, 1), cancel);
        problems.AddRange(written.Diagnostics);
        return new Result<GCodeDocument>(written.Value, problems.ToList());
    }

    /// <summary>
    /// The setup to check a file against that may heat by itself: one that does begins cold; one that leaves the heating to a macro of the firmware is taken as
    /// hot.
    /// </summary>
    public static PrintSetup ForFile(PrintSetup setup, Toolpath toolpath)
    {
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        return toolpath.Events.Any(e => e.Event is NozzleTemperatureEvent) ? setup with { Material = setup.Material with { NozzleTemperature = 0 } } : setup;
    }
}

using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;

namespace Caterpillar.Cli;

/// <summary>Where G-code is written, and the reason to write despite the checks; for every verb that makes G-code.</summary>
internal sealed class WriteOptions
{
    private readonly Option<string?> _output = new("--output", "-o")
    {
        Description = "The G-code file, binary where its name ends in .bgcode, or - for standard output. By default the name of the first input with .gcode, "
            + "in the current folder.",
        HelpName = "FILE",
    };

    private readonly Option<string?> _reason = Override();

    public static Option<string?> Override() => new("--override")
    {
        Description = "Write despite what the checks found; the reason is kept in the file as a comment.",
        HelpName = "REASON",
    };

    public void AddTo(Verb verb)
    {
        verb.Options.Add(_output);
        verb.Options.Add(_reason);
    }

    /// <summary>Whether to write despite what checks find.</summary>
    public bool Overrides(ParseResult arguments) => arguments.GetValue(_reason) is not null;

    /// <summary>The file to write: the one asked for, or named after an input (standard output for standard input).</summary>
    public string FileFor(ParseResult arguments, string input)
    {
        if (arguments.GetValue(_output) is { } given) return given.Length > 0 ? given : throw new CliException(ExitCode.Usage, "--output needs a name.");
        if (input == "-") return "-";
        var name = Path.GetFileName(input);
        if (name.EndsWith(".gz", StringComparison.OrdinalIgnoreCase)) name = Path.GetFileNameWithoutExtension(name);
        var file = Path.GetFileNameWithoutExtension(name) + ".gcode";
        return Path.GetFullPath(file) != Path.GetFullPath(input) ? file
            : throw new CliException(ExitCode.Usage, $"{input} would be overwritten: choose another file with -o.");
    }

    /// <summary>Checks and writes a toolpath, and says what was written.</summary>
    /// <exception cref="CliException">A check refused.</exception>
    public int Write(ParseResult arguments, Session session, Toolpath toolpath, PrintSetup setup, string file)
    {
        WriteGCode(arguments, session, toolpath, setup, file);
        return ExitCode.Done;
    }

    /// <summary>
    /// The same, returning details of the file; one larger than <paramref name="maxBytes"/> is not written. Where the toolpath is the plan of a pipeline, that
    /// writes it.
    /// </summary>
    /// <exception cref="CliException">A check refused, or the file would be too large.</exception>
    public WrittenFile WriteGCode(ParseResult arguments, Session session, Toolpath toolpath, PrintSetup setup, string file,
        double maxBytes = double.PositiveInfinity, PrintPipeline? pipeline = null)
    {
        WrittenGCode? written = null;
        IReadOnlyList<Diagnostic> findings = [];
        // While it is being written.
        var figures = Task.Run(() => PrintFigures.Of(toolpath, setup, double.NaN));
        session.Write(file, (stream, isDraft) => BinaryGCode.WriteAs(file, stream, text =>
        {
            var reason = arguments.GetValue(_reason);
            Result<WrittenGCode> Write(IProgress<double>? progress) => pipeline is not null
                ? pipeline.Write(text, isDraft, reason, progress)
                : isDraft ? SafeWriter.WriteDraft(toolpath, setup, text, reason, progress, session.Cancel)
                : SafeWriter.Write(toolpath, setup, text, reason, progress, session.Cancel);
            // A progress bar and the G-code would mix on a terminal.
            var result = file == "-" ? Write(null) : session.WithProgress("Writing", Write);
            // What the checks merely remark on is for "caterpillar check".
            session.Print(result.Diagnostics.Where(d => d.Severity != Severity.Remark || CheckCodes.Find(d.Code) is null));
            if (FindingSummary.Of(result.Diagnostics) is { } summary) session.Say(() => summary);
            findings = result.Diagnostics.Where(d => CheckCodes.Find(d.Code) is not null).ToArray();
            written = result.Value ?? throw new CliException(result.Diagnostics.Any(d => d.Code == SafeWriter.Refused) ? ExitCode.Refused : ExitCode.BadInput);
            if (written.Bytes > maxBytes)
                throw new CliException(ExitCode.Refused,
                    $"{file}: {Count(written.Lines)} lines, {Count(written.Bytes)} bytes are more than --max-size allows; nothing was written.");
        }, session.Cancel));
        session.Made(() => figures.GetAwaiter().GetResult() with { Seconds = Time(written!, toolpath, setup, session) }, written!.Lines, written.Bytes,
            print => $"{Session.NameOfOutput(file)}: {PrintSummary.Of(print)}; {Count(written.Lines)} lines, {PrintSummary.Size(written.Bytes)}");
        return new WrittenFile(written!, findings);
    }

    // Start and end code apart; written files of some printers are not timed.
    private static double Time(WrittenGCode written, Toolpath toolpath, PrintSetup setup, Session session)
        => written.PrintTime ?? Timeline.Of(toolpath, setup, null, session.Cancel).Duration;

    private static string Count(long number) => NumberFormatter.Format(number);
}

/// <summary>A G-code file that was written, and what the checks found in it.</summary>
internal sealed record WrittenFile(WrittenGCode GCode, IReadOnlyList<Diagnostic> Findings);

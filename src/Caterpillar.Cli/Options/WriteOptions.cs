namespace Caterpillar.Cli;

/// <summary>The output file, and the reason to write despite the checks; for every verb that makes G-code.</summary>
internal sealed class WriteOptions
{
    /// <summary>Description of the output file.</summary>
    public const string Description = "Output G-code file; .bgcode = binary, - = standard output.";

    private readonly Described<string?> _output = new("--output", Description + " " + CommonOptions.DefaultOutput, "FILE", "-o");

    private readonly Described<string?> _reason = Override();

    public Option[] All => [_output, _reason];

    public static Described<string?> Override()
        => new("--override", "Write despite errors of the checks. The file keeps the reason as a comment.", "REASON");

    /// <summary>Whether to write despite errors of the checks.</summary>
    public bool Overrides(ParseResult arguments) => arguments.GetValue(_reason) is not null;

    /// <summary>The output file: as given, or named after an input (standard output for standard input).</summary>
    public string FileFor(ParseResult arguments, string input)
    {
        if (arguments.GetValue(_output) is { } given) return given.Length > 0 ? given : throw CliException.Usage("--output needs a file name.");
        if (input == "-") return "-";
        var file = Path.GetFileNameWithoutExtension(GzipReader.PlainName(input)) + ".gcode";
        return Path.GetFullPath(file) != Path.GetFullPath(input) ? file
            : throw CliException.Usage($"The output would replace the input {input}. Give another name with -o.");
    }

    /// <summary>Checks and writes a print and prints a summary. Files larger than <paramref name="maxBytes"/> are not written.</summary>
    /// <exception cref="CliException">A check refused the print, or the file would be too large.</exception>
    public WrittenFile Write(ParseResult arguments, Session session, PrintJob job, string file, double maxBytes = double.PositiveInfinity)
    {
        WrittenGCode? written = null;
        IReadOnlyList<Diagnostic> findings = [];
        var reason = arguments.GetValue(_reason);
        // While it is being written.
        var planned = Task.Run(() => PrintFigures.Of(job.Toolpath, job.Setup));
        session.Write(file, (stream, isDraft) =>
        {
            Result<WrittenGCode> Write(IProgress<double>? progress) => job.Write(stream, file, isDraft, reason, progress, session.Cancel);
            // A progress bar and the G-code would mix on a terminal.
            var result = file == "-" ? Write(null) : session.WithProgress("Writing", Write);
            // Notes of the checks are for "caterpillar check", except those about commands.
            session.Print(result.Diagnostics.Where(d => d.Severity != Severity.Note || CheckCodes.Find(d.Code) is null
                || d.Code.StartsWith("command.", StringComparison.Ordinal)));
            if (FindingSummary.Of(result.Diagnostics) is { } summary) session.Say(() => summary);
            findings = result.Diagnostics.Where(d => CheckCodes.Find(d.Code) is not null).ToArray();
            written = session.WrittenOrFail(result);
            if (written.Bytes > maxBytes)
                throw new CliException(ExitCode.Refused,
                    $"{file}: {Count(written.Bytes)} bytes ({Count(written.Lines)} lines) exceed --max-size. Nothing was written.");
        });
        session.Made(() => Figures(planned.Result, written!, job, session),
            written!.Lines, written.Bytes,
            print => $"{Session.NameOfOutput(file)}: {PrintSummary.Of(print)}; {Count(written.Lines)} lines, {PrintSummary.Size(written.Bytes)}");
        return new WrittenFile(written, findings);
    }

    private static PrintFigures Figures(PrintFigures planned, WrittenGCode written, PrintJob job, Session session)
        => written is { File: { } file, PrintTime: { } seconds } ? PrintFigures.Of(file, job.Setup, planned) with { Seconds = seconds }
            : planned with { Seconds = Timeline.Of(job.Toolpath, job.Setup, null, session.Cancel).Duration };

    private static string Count(long number) => NumberFormatter.Format(number);
}

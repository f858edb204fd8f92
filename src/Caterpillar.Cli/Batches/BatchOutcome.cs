namespace Caterpillar.Cli;

/// <summary>State of a run.</summary>
internal enum BatchStatus
{
    NotStarted,
    Done,
    Skipped,
    Failed,
    Interrupted,
}

/// <summary>Outcome of a run, with its messages.</summary>
internal sealed record BatchOutcome(BatchJob Job, BatchStatus Status, int Code = ExitCode.Done, string Messages = "", byte[]? Output = null)
{
    /// <summary>Code of the first error, such as <c>mesh.empty</c>.</summary>
    public string ErrorCode { get; init; } = "";

    /// <summary>The error as a sentence.</summary>
    public string Error { get; init; } = "";

    /// <summary>The figures of the written file, as text in the order of <see cref="BatchSummary.FigureNames"/>.</summary>
    public IReadOnlyList<string> Figures { get; init; } = [];

    /// <summary>Time of the run, s.</summary>
    public double Seconds { get; init; }

    public string Fingerprint { get; init; } = "";

    /// <summary>It needs more than its share of the memory.</summary>
    public bool NeedsMemory { get; init; }

    /// <summary>Its inputs, for messages.</summary>
    public string Title => string.Join(" ", Job.Inputs) + (Job.Cells.Count > 0 ? $" ({string.Join(", ", Job.Cells)})" : "");

    /// <summary>Figures of a written file.</summary>
    public static IReadOnlyList<string> FiguresOf(WrittenFigures? written, string? file)
    {
        var bytes = file is not null && File.Exists(file) ? NumberFormatter.Format(new FileInfo(file).Length) : "";
        var print = written?.Print.Values ?? PrintFigures.Names.Select(_ => (double?)null);
        return [.. print.Select(v => v is { } value ? NumberFormatter.Format(value, 3) : ""), written is null ? ""
            : NumberFormatter.Format(written.Lines), bytes];
    }
}

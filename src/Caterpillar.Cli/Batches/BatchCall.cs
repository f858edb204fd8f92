using System.Diagnostics;

namespace Caterpillar.Cli;

/// <summary>Runs one job of a batch like a single run. Messages and output are kept until its turn.</summary>
internal sealed class BatchCall(Verb verb, Session session, BatchSummary? earlier, bool hashes)
{
    /// <param name="job">The job.</param>
    /// <param name="memory">Its share of the memory.</param>
    /// <param name="threads">Its share of the cores.</param>
    public BatchOutcome Run(BatchJob job, MemoryLimit memory, int threads)
    {
        var watch = Stopwatch.StartNew();
        var fingerprint = "";
        using var messages = new StringWriter();
        using var output = new MemoryStream();
        var inner = new Session(() => Stream.Null, () => output, messages)
        {
            Unfinished = session.Unfinished,
            Cancel = session.Cancel, Profiles = session.Profiles, Quiet = session.Quiet, Memory = memory, Collects = true,
        };
        var code = Guard.Run(inner, () =>
        {
            if (hashes) fingerprint = Fingerprint.Of(verb, job);
            if (earlier?.Earlier(fingerprint) is not null) return ExitCode.Done;
            var fresh = Verbs.Named(verb.Name);
            return fresh.Run(fresh.Parse(Words(verb, job, threads)), inner);
        });
        if (code == ExitCode.Done && earlier?.Earlier(fingerprint) is { } figures)
            return new BatchOutcome(job, BatchStatus.Skipped) { Figures = figures, Fingerprint = fingerprint, Seconds = watch.Elapsed.TotalSeconds };
        if (code == ExitCode.Interrupted) return new BatchOutcome(job, BatchStatus.Interrupted);
        var done = code == ExitCode.Done;
        var error = inner.FirstError;
        return new BatchOutcome(job, done ? BatchStatus.Done : BatchStatus.Failed, code, messages.ToString(), output.ToArray())
        {
            ErrorCode = done ? "" : error?.Code ?? "",
            Error = done ? "" : error?.Message ?? messages.ToString().Split('\n').Select(l => l.Trim()).FirstOrDefault(l => l.Length > 0) ?? "",
            Figures = done ? BatchOutcome.FiguresOf(inner.Written, job.Output) : [],
            Seconds = watch.Elapsed.TotalSeconds,
            Fingerprint = done ? fingerprint : "",
            NeedsMemory = inner.LacksMemory || error?.Code == MemoryLimit.Code,
        };
    }

    /// <summary>The command line of a job, without the verb.</summary>
    public static string[] Words(Verb verb, BatchJob job, int threads)
    {
        var takesThreads = verb.Options.Any(o => o.Name == "--threads") && !job.Words.Contains("--threads");
        return
        [
            .. job.Words, .. job.Output is { } output ? (string[])["--output", output] : [],
            .. takesThreads ? (string[])["--threads", NumberFormatter.Format(threads)] : [],
        ];
    }
}

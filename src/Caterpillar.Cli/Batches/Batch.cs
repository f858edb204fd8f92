using System.Diagnostics;

namespace Caterpillar.Cli;

/// <summary>Many runs in one process. Each writes the same output as a single run.</summary>
internal sealed class Batch
{
    // As large as that of a main thread: designs may nest deeply.
    private const int StackBytes = 16 << 20;

    // The summary takes no more than this share of the time.
    private const double SummaryShare = 0.05;

    private readonly Verb _verb;
    private readonly ParseResult _parsed;
    private readonly Session _session;
    private readonly IReadOnlyList<BatchJob> _jobs;
    private readonly BatchOutcome[] _outcomes;
    private readonly BatchSummary _summary;
    private readonly BatchCall _call;
    private readonly object _turn = new();
    private readonly Stopwatch _watch = Stopwatch.StartNew();
    private TimeSpan _nextSummary;
    private volatile bool _hasNews;
    private int _next;

    private Batch(Verb verb, ParseResult parsed, Session session)
    {
        (_verb, _parsed, _session) = (verb, parsed, session);
        var list = new BatchList(verb, parsed, session);
        _jobs = list.Jobs();
        _outcomes = _jobs.Select(j => new BatchOutcome(j, BatchStatus.NotStarted)).ToArray();
        _summary = new BatchSummary(list.Columns);
        _call = new BatchCall(verb, session, Earlier(), SummaryFile is not null);
    }

    private string? SummaryFile => _parsed.GetValue(_verb.Batch!.Summary);

    /// <summary>Runs all runs, prints their outcomes in the order of the list, and returns the exit code of the first that failed.</summary>
    /// <exception cref="CliException">The command line is wrong; nothing was done.</exception>
    public static int Run(Verb verb, ParseResult parsed, Session session) => new Batch(verb, parsed, session).Run();

    private int Run()
    {
        // For the table of what is done.
        _session.Grace = TimeSpan.FromSeconds(5);
        var checker = Verbs.Named(_verb.Name);
        foreach (var job in _jobs) CheckCall(job, checker);
        foreach (var folder in _jobs.Select(j => j.Output is { } o ? Path.GetDirectoryName(Path.GetFullPath(o)) : null).OfType<string>().Distinct())
            Directory.CreateDirectory(folder);
        WriteSummary();
        var workers = _verb.Batch!.Workers(_parsed, _jobs.Count);
        var share = new MemoryLimit(Math.Max(1, _session.Memory.Bytes / workers));
        var threads = Math.Max(1, Environment.ProcessorCount / workers);
        var all = Enumerable.Range(0, workers).Select(_ => new Thread(() => Work(share, threads), StackBytes)).ToArray();
        foreach (var thread in all) thread.Start();
        Report(workers > 1);
        foreach (var thread in all) thread.Join();
        WriteSummary(isLast: true);
        return Close();
    }

    // Wrong usage is found before any work begins.
    private static void CheckCall(BatchJob job, Verb verb)
    {
        var parsed = verb.Parse(BatchCall.Words(verb, job, 1));
        var problems = parsed.Errors.Count > 0 || UsageMessages.UnknownOption(parsed) is not null ? UsageMessages.Of(parsed, verb).ToArray() : [];
        if (problems.Length > 0) throw CliException.Usage(string.Join("\n", problems) + $"\nSee: caterpillar {verb.Name} --help");
        FileGuard.Check(verb, parsed);
    }

    private void Work(MemoryLimit share, int threads)
    {
        while (!_session.Cancel.IsCancellationRequested)
        {
            var index = Interlocked.Increment(ref _next) - 1;
            if (index >= _jobs.Count) return;
            var outcome = _call.Run(_jobs[index], share, threads);
            lock (_turn)
            {
                _outcomes[index] = outcome;
                _hasNews = true;
                Monitor.PulseAll(_turn);
            }
        }
    }

    // Prints the outcomes in order. Runs that need more than their share of the memory are repeated alone, with all of it.
    private void Report(bool shared)
    {
        for (var i = 0; i < _jobs.Count; i++)
        {
            if (!WaitFor(i)) return;
            if (!shared || !_outcomes[i].NeedsMemory) Say(i);
        }
        for (var i = 0; shared && i < _jobs.Count && !_session.Cancel.IsCancellationRequested; i++)
        {
            if (!_outcomes[i].NeedsMemory) continue;
            _outcomes[i] = _call.Run(_jobs[i], _session.Memory, Environment.ProcessorCount);
            Say(i);
        }
    }

    // False if it will not be started any more.
    private bool WaitFor(int index)
    {
        while (true)
        {
            if (_hasNews && _watch.Elapsed >= _nextSummary) WriteSummary();
            lock (_turn)
            {
                if (_outcomes[index].Status != BatchStatus.NotStarted) return true;
                if (_session.Cancel.IsCancellationRequested && index >= Volatile.Read(ref _next)) return false;
                Monitor.Wait(_turn, 100);
            }
        }
    }

    private void Say(int index)
    {
        var outcome = _outcomes[index];
        if (outcome.Output is { Length: > 0 } bytes) _session.Write("-", stream => stream.Write(bytes));
        var messages = outcome.Status == BatchStatus.Skipped && !_session.Quiet ? (outcome.Job.Output ?? outcome.Title) + ": already done, skipped"
            : outcome.Messages;
        foreach (var line in messages.Split('\n', StringSplitOptions.RemoveEmptyEntries))
            _session.Messages.WriteLine($"[{Count(index + 1)}/{Count(_jobs.Count)}] {line.TrimEnd('\r')}");
    }

    private void WriteSummary(bool isLast = false)
    {
        if (SummaryFile is not { } file || (file == "-" && !isLast)) return;
        BatchOutcome[] now;
        lock (_turn)
        {
            now = [.. _outcomes];
            _hasNews = false;
        }
        var begin = _watch.Elapsed;
        _summary.Write(_session, file, now);
        _nextSummary = _watch.Elapsed + TimeSpan.FromTicks((long)((_watch.Elapsed - begin).Ticks / SummaryShare));
    }

    private int Close()
    {
        var failed = _outcomes.Where(o => o.Status == BatchStatus.Failed).ToArray();
        var (done, skipped) = (Of(BatchStatus.Done), Of(BatchStatus.Skipped));
        _session.Say(() => $"{Count(done)} of {Count(_jobs.Count)} done" + (skipped > 0 ? $", {Count(skipped)} skipped" : "")
            + (failed.Length > 0 ? $", {Count(failed.Length)} failed:" : ""));
        foreach (var outcome in failed)
        {
            _session.Messages.WriteLine($"  {outcome.Title}: exit code {Count(outcome.Code)}, "
                + $"{(outcome.ErrorCode.Length > 0 ? outcome.ErrorCode + ": " : "")}{outcome.Error}");
        }
        if (done + skipped + failed.Length < _jobs.Count)
        {
            _session.Messages.WriteLine("Interrupted. " + (SummaryFile is null ? "With --summary, an interrupted list can be continued with --resume."
                : "To continue, repeat the command with --resume."));
            return ExitCode.Interrupted;
        }
        return failed.Length > 0 ? failed[0].Code : ExitCode.Done;
    }

    private int Of(BatchStatus status) => _outcomes.Count(o => o.Status == status);

    private BatchSummary? Earlier()
    {
        if (!_parsed.GetValue(_verb.Batch!.Resume)) return null;
        if (SummaryFile is not { } file || file == "-") throw CliException.Usage("--resume needs the summary of the earlier run. Give --summary FILE.csv.");
        if (_verb.ReplacesInput(_parsed)) throw CliException.Usage("--resume cannot be combined with --in-place. Use --output.");
        if (File.Exists(file)) _summary.ReadEarlier(File.ReadAllText(file), file);
        return _summary;
    }

    private static string Count(int number) => NumberFormatter.Format(number);
}

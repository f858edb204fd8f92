namespace Caterpillar.Checks;

/// <summary>
/// Plans a print while the steps of higher layers are still being made; what is planned is timed and checked at once. The plan is that of
/// <see cref="Planner"/>, the file that of <see cref="SafeWriter"/>. To be used by one thread.
/// </summary>
internal sealed class PrintPipeline : IDisposable
{
    // Batches that wait to be planned, at most: their steps take more memory than their moves.
    private const int Waiting = 16;
    private readonly BlockingCollection<IReadOnlyList<Step>> _batches = new(Waiting);
    private readonly CancellationTokenSource _stop;
    private readonly PrintSetup _setup;
    private readonly Task<Result<Plan>> _planning;
    private PlanTiming? _timing;
    private PrintDraft? _draft;

    /// <param name="setup">The printer, material and settings.</param>
    /// <param name="options">Options of planning.</param>
    /// <param name="cancel">Cancels.</param>
    public PrintPipeline(PrintSetup setup, PlanOptions? options = null, CancellationToken cancel = default)
    {
        _setup = setup;
        _stop = CancellationTokenSource.CreateLinkedTokenSource(cancel);
        _timing = new PlanTiming(setup, _stop.Token);
        _planning = OwnThread.Run(() => Plan(setup, options));
    }

    /// <summary>
    /// The paths of the next layers, as slicers make them; paths are sorted among those that are given together. Waits while many are not planned yet.
    /// </summary>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public void Add(IReadOnlyList<Step> steps)
    {
        _stop.Token.ThrowIfCancellationRequested();
        while (!_planning.IsCompleted && !_batches.TryAdd(steps, 20, _stop.Token))
        {
        }
    }

    /// <summary>The plan of all steps, or none and the errors.</summary>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public Result<Plan> Finish()
    {
        _batches.CompleteAdding();
        return OwnThread.Join(_planning);
    }

    /// <summary>Checks and writes the plan as <see cref="SafeWriter"/> does.</summary>
    /// <param name="stream">Where to write.</param>
    /// <param name="isDraft">True if the caller deletes a refused file.</param>
    /// <param name="reason">Why errors of the checks are ignored; null = do not write if there are errors.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels.</param>
    /// <exception cref="InvalidOperationException">There is no plan.</exception>
    /// <exception cref="OperationCanceledException">Canceled.</exception>
    public Result<WrittenGCode> Write(
        Stream stream, bool isDraft, string? reason = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        using var canceled = cancel.Register(_stop.Cancel);
        var plan = Finish().Value ?? throw new InvalidOperationException("Planning failed, so nothing can be written.");
        using var draft = _draft;
        var begun = (draft, _timing);
        // Good for one file: the next is timed and checked from the beginning.
        (_draft, _timing) = (null, null);
        return SafeWriter.Write(plan.Toolpath, _setup, stream, reason, progress, _stop.Token, isDraft, begun);
    }

    /// <summary>Stops unfinished work and waits for its end.</summary>
    public void Dispose()
    {
        _stop.Cancel();
        _batches.CompleteAdding();
        OwnThread.Wait(_planning);
        _draft?.Dispose();
        _batches.Dispose();
        _stop.Dispose();
    }

    private Result<Plan> Plan(PrintSetup setup, PlanOptions? options)
    {
        try
        {
            var run = Planner.Begin(setup, options, Take, _stop.Token);
            foreach (var steps in _batches.GetConsumingEnumerable()) run.Add(steps, null);
            _stop.Token.ThrowIfCancellationRequested();
            return run.Finish();
        }
        catch (DiagnosticException tooMuch)
        {
            return new Result<Plan>(null, tooMuch.Diagnostics);
        }
    }

    private void Take(Toolpath soFar)
    {
        if (soFar.Blocks.Count == 1) _draft = PrintDraft.Begin(soFar, _setup, _stop.Token);
        _timing?.Take(soFar);
        _draft?.Take(soFar);
    }
}

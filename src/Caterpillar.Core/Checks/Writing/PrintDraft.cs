namespace Caterpillar.Checks;

/// <summary>
/// The text of a print while the rest of it is still being planned: written, read back and checked at once, and not kept. The file has the same text and, in
/// addition, the lines that only the whole print tells: its time, images, objects and progress. Whether it is the same is seen when the file is written.
/// </summary>
internal sealed class PrintDraft : IDisposable
{
    // Parts of the plan that wait to be written, at most.
    private const int Waiting = 8;
    private readonly BlockingCollection<Toolpath> _planned = new(Waiting);
    private readonly CancellationToken _cancel;
    private readonly TextDigest _text = new(null);
    private readonly ReadBack _back;
    private readonly Task _writing;
    private (Toolpath Plan, GCodeFormat Format)? _whole;
    private volatile bool _isStopped;

    private PrintDraft(Toolpath soFar, PrintSetup setup, GCodeFormat format, CancellationToken cancel)
    {
        _cancel = cancel;
        _back = new ReadBack(soFar, setup, format, _text, false, cancel);
        _writing = OwnThread.Run(Write);
    }

    /// <summary>Begins; null if all checks are off, axes are mapped or turn, or a template of the printer needs the whole print first.</summary>
    public static PrintDraft? Begin(Toolpath soFar, PrintSetup setup, CancellationToken cancel)
        => ReadBack.IsAsked(setup) && setup.Printer.AxisMappings.Count == 0 && setup.Printer.RotaryAxes.Count == 0
            && SetupFormat.OfUnknown(setup) is { } format ? new PrintDraft(soFar, setup, format, cancel) : null;

    /// <summary>The toolpath as far as it is planned. Waits while much of it is not checked yet: else the checks would go on alone in the end.</summary>
    public void Take(Toolpath soFar)
    {
        while (!_writing.IsCompleted && !_planned.TryAdd(soFar, 20))
        {
        }
    }

    /// <summary>
    /// Writes the file, and returns what was found in it, with the number of its lines and bytes; no findings if its text differs from the draft.
    /// </summary>
    /// <param name="plan">All that was planned.</param>
    /// <param name="timed">The same with progress events.</param>
    /// <param name="format">The format of the file.</param>
    /// <param name="stream">The file; null = only check.</param>
    /// <param name="progress">0 to 1.</param>
    public CheckedGCode Finish(Toolpath plan, Toolpath timed, GCodeFormat format, Stream? stream, IProgress<double>? progress)
    {
        _whole = (plan, format);
        _planned.CompleteAdding();
        var writer = new GCodeWriter(timed, format);
        var text = new TextDigest(stream);
        writer.WriteAll(text, progress.Part(0, 0.5), _cancel, stream ?? Stream.Null);
        OwnThread.Wait(_writing);
        _writing.GetAwaiter().GetResult();
        NoteAdded(plan, timed, format);
        var findings = _back.Finish(progress.Part(0.5, 1));
        return new CheckedGCode(text.Sum == _text.Sum ? findings : null, writer.Lines, writer.Bytes, _back.Read);
    }

    /// <summary>Stops unfinished work and waits for its end.</summary>
    public void Dispose()
    {
        _isStopped = true;
        _planned.CompleteAdding();
        _back.Stop();
        OwnThread.Wait(_writing);
        _back.Dispose();
        _planned.Dispose();
    }

    private void Write()
    {
        foreach (var soFar in _planned.GetConsumingEnumerable())
        {
            if (_isStopped) return;
            _back.Write(soFar);
        }
        if (_whole is not { } whole) return;
        _back.Write(whole.Plan);
        _back.End(whole.Format);
    }

    // The lines that the file has and the draft has not.
    private void NoteAdded(Toolpath plan, Toolpath timed, GCodeFormat format)
    {
        foreach (var _ in format.Facts) _back.Lines.Add(format.Header.Count);
        var next = 0;
        foreach (var entry in timed.Events)
        {
            var isOwn = next < plan.Events.Count && ReferenceEquals(entry.Event, plan.Events[next].Event);
            if (isOwn) next++;
            else _back.Lines.Add(_back.Lines.Before(entry.Move, next < plan.Events.Count && plan.Events[next].Move == entry.Move ? next : -1));
        }
    }
}

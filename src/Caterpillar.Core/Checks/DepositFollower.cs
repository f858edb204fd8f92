using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>
/// Checks what is printed on a thread of its own, block by block, while the rest of the file is still being written and read: by far the longest of all checks.
/// </summary>
internal sealed class DepositFollower : IDisposable
{
    private readonly BlockingCollection<DecodedBlock> _queue = [];
    private readonly List<DecodedBlock> _shown = [];
    private readonly CancellationToken _cancel;
    private readonly CancellationTokenSource _stop;
    private readonly IReadOnlyList<ToolpathTool> _tools;
    private readonly PrintSetup _setup;
    private readonly Findings _findings;
    private Task? _work;
    private bool _isLate;
    private int _blocks;
    private int _events;
    private volatile IProgress<double>? _progress;
    private Toolpath? _whole;

    /// <param name="plan">What is written; its tools are those of what is read.</param>
    /// <param name="setup">The printer, material and settings.</param>
    /// <param name="lines">The lines of the plan, which are being written.</param>
    /// <param name="cancel">Cancels.</param>
    public DepositFollower(Toolpath plan, PrintSetup setup, WrittenLines lines, CancellationToken cancel)
    {
        _cancel = cancel;
        _stop = CancellationTokenSource.CreateLinkedTokenSource(cancel);
        _tools = plan.Tools;
        var places = new WrittenPlaces(plan, LineOf, lines, setup.Printer);
        _findings = new Findings(setup.Printer, places.Of, places.Of);
        _setup = setup;
    }

    /// <summary>A block that is full; in order, on the thread that reads.</summary>
    public void Take(DecodedBlock block)
    {
        // As long as the file does not say how thick its layers are, all of it must be known.
        _isLate |= block.Thicknesses is null;
        if (_isLate) return;
        _blocks++;
        _events += block.Events.Length;
        _queue.Add(block);
        _work ??= Task.Factory.StartNew(Work, CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
    }

    /// <summary>What was found in the whole file; null where nothing was checked so far, or by other tools.</summary>
    public IReadOnlyList<Diagnostic>? Finish(Toolpath read, IProgress<double>? progress)
    {
        if (_work is null || !read.Tools.SequenceEqual(_tools)) return null;
        _progress = progress;
        _whole = read;
        foreach (var block in CheckRun.BlocksOf(read, _blocks, _events)) _queue.Add(block);
        _queue.CompleteAdding();
        ((IAsyncResult)_work).AsyncWaitHandle.WaitOne();
        _cancel.ThrowIfCancellationRequested();
        _work.GetAwaiter().GetResult();
        return _findings.ToList();
    }

    /// <summary>Stops where it is not finished, and waits for that.</summary>
    public void Dispose()
    {
        _stop.Cancel();
        _queue.CompleteAdding();
        if (_work is not null) ((IAsyncResult)_work).AsyncWaitHandle.WaitOne();
        _queue.Dispose();
        _stop.Dispose();
    }

    private void Work()
    {
        var run = new CheckRun([new DepositCheck(_setup, _findings)], _tools, _stop.Token);
        foreach (var block in _queue.GetConsumingEnumerable())
        {
            _shown.Add(block);
            run.Block(block, at =>
            {
                if (_progress is { } progress && _whole is { } whole) progress.Report(at / (double)whole.Count);
            });
        }
        _stop.Token.ThrowIfCancellationRequested();
        run.End(_whole!);
    }

    private int? LineOf(int move)
    {
        for (var i = _shown.Count - 1; i >= 0 && move >= 0; i--)
        {
            var at = move - _shown[i].First;
            if (at >= 0) return at < _shown[i].Columns.Count ? _shown[i].Columns.Source[at] : null;
        }
        return null;
    }
}

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
    private readonly BlockingCollection<DecodedBlock> _queue;
    private readonly CancellationToken _cancel;
    private readonly CancellationTokenSource _stop;
    private readonly IReadOnlyList<ToolpathTool> _tools;
    private readonly PrintSetup _setup;
    private readonly Findings _findings;
    private Task<Findings>? _work;
    private bool _isLate;
    private int _blocks;
    private volatile IProgress<double>? _progress;
    private volatile bool _namesPlaces;
    private Toolpath? _whole;

    // Where its findings are; with what has been shown, where lines are known at once.
    private readonly List<DecodedBlock> _shown = [];
    private WrittenPlaces? _places;

    /// <param name="tools">The tools of what is read.</param>
    /// <param name="setup">The printer, material and settings.</param>
    /// <param name="waiting">Number of blocks that wait at most; whoever brings more waits, too.</param>
    /// <param name="cancel">Cancels.</param>
    public DepositFollower(IReadOnlyList<ToolpathTool> tools, PrintSetup setup, int waiting, CancellationToken cancel)
    {
        _cancel = cancel;
        _stop = CancellationTokenSource.CreateLinkedTokenSource(cancel);
        _queue = new BlockingCollection<DecodedBlock>(waiting);
        _tools = tools;
        _setup = setup;
        _findings = new Findings(setup.Printer, PlaceOf, what => _places!.Of(what));
    }

    /// <summary>The file is that of a plan, whose lines are being taken down. Without this, findings that name other places are left to the end.</summary>
    public void Locate(Toolpath plan, WrittenLines lines) => _places = new WrittenPlaces(plan, LineOf, lines, _setup.Printer);

    /// <summary>A block that is full; in order, on the thread that reads. False where it has to wait for the whole file.</summary>
    public bool Take(DecodedBlock block)
    {
        // As long as the file does not say how thick its layers are, all of it must be known.
        _isLate |= block.Thicknesses is null;
        if (_isLate) return false;
        _work ??= OwnThread.Run(Work);
        _blocks++;
        Put(block);
        return true;
    }

    /// <summary>What was found in the whole file; null where nothing was checked so far, by other tools, or without places that had to be named.</summary>
    public IReadOnlyList<Diagnostic>? Finish(Toolpath read, WrittenPlaces places, IProgress<double>? progress)
    {
        if (_work is null || !read.Tools.SequenceEqual(_tools)) return null;
        (_progress, _whole) = (progress, read);
        foreach (var block in CheckRun.BlocksOf(read, _blocks)) Put(block);
        _queue.CompleteAdding();
        OwnThread.Wait(_work);
        _cancel.ThrowIfCancellationRequested();
        var findings = _work.GetAwaiter().GetResult();
        if (_namesPlaces) return null;
        _places = places;
        return findings.ToList();
    }

    /// <summary>Nothing more is checked.</summary>
    public void Stop() => _stop.Cancel();

    /// <summary>Stops where it is not finished, and waits for that.</summary>
    public void Dispose()
    {
        Stop();
        _queue.CompleteAdding();
        if (_work is not null) OwnThread.Wait(_work);
        _queue.Dispose();
        _stop.Dispose();
    }

    private void Put(DecodedBlock block)
    {
        // Where the work has failed or was stopped nobody makes room.
        while (!_work!.IsCompleted && !_queue.TryAdd(block, 20))
        {
        }
    }

    private SourceLocation? PlaceOf(int move)
    {
        if (_places is null) _namesPlaces = true;
        return _places?.Of(move);
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

    private Findings Work()
    {
        var run = new CheckRun([new DepositCheck(_setup, _findings)], _tools, _stop.Token);
        var keeps = _places is not null;
        foreach (var block in _queue.GetConsumingEnumerable())
        {
            if (keeps) _shown.Add(block);
            run.Block(block, at =>
            {
                if (_progress is { } progress && _whole is { } whole) progress.Report(at / (double)whole.Count);
            });
        }
        _stop.Token.ThrowIfCancellationRequested();
        run.End(_whole!);
        return _findings;
    }
}

using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Threading;
using System.Threading.Tasks;
using Caterpillar.Basics;
using Caterpillar.Files;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>
/// Checks what is printed while the rest is still being planned. What is planned is written as a draft, which lacks what only the whole print tells: its
/// time and progress, the end code. The draft is read back and checked at once and not kept. What was found holds if the file, once it is read back, begins
/// with exactly the same moves; else it is thrown away.
/// </summary>
internal sealed class EarlyCheck : IDisposable
{
    // Blocks that wait to be checked, at most; and such that wait to be written.
    private const int Waiting = 8;
    private readonly BlockingCollection<Toolpath> _planned = new(Waiting);
    private readonly List<ulong> _digests = [];
    private readonly BytePipe _pipe = new();
    private readonly CancellationTokenSource _stop;
    private readonly DepositFollower _follower;
    private readonly Task _both;
    private volatile bool _isOver;
    private volatile int _blocks;

    private EarlyCheck(PrintSetup setup, GCodeFormat format, IReadOnlyList<ToolpathTool> tools, CancellationToken cancel)
    {
        _stop = CancellationTokenSource.CreateLinkedTokenSource(cancel);
        _follower = new DepositFollower(tools, setup, Waiting, cancel);
        _both = Task.WhenAll(OwnThread.Run(() => Write(format)), OwnThread.Run(() => Read(setup)));
    }

    /// <summary>Begins; null where nothing is looked for, or a template of the printer needs to know the whole print first.</summary>
    public static EarlyCheck? Begin(PrintSetup setup, IReadOnlyList<ToolpathTool> tools, CancellationToken cancel)
        => DepositCheck.IsAsked(setup.Printer) && SetupFormat.OfUnknown(setup) is { } format ? new EarlyCheck(setup, format, tools, cancel) : null;

    /// <summary>Number of blocks of the draft that have been read so far.</summary>
    public int Blocks => _blocks;

    /// <summary>The toolpath as far as it is planned. Waits while much of it is not checked yet: else the checks would go on alone in the end.</summary>
    public void Take(Toolpath soFar)
    {
        while (!_both.IsCompleted && !_planned.TryAdd(soFar, 20))
        {
        }
    }

    /// <summary>The draft ends: the file itself is being written.</summary>
    public void End()
    {
        _isOver = true;
        if (!_planned.IsAddingCompleted) _planned.CompleteAdding();
    }

    /// <summary>What was found in the whole file; null where it does not begin as the draft does, or where there is no draft.</summary>
    public IReadOnlyList<Diagnostic>? Finish(Toolpath read, WrittenPlaces places, IProgress<double>? progress)
    {
        End();
        OwnThread.Wait(_both);
        if (_both.Status != TaskStatus.RanToCompletion) return null;
        var same = 0;
        foreach (var block in CheckRun.BlocksOf(read, 0))
        {
            if (same == _digests.Count || MoveDigest.Of(block) != _digests[same]) break;
            same++;
        }
        return same == _digests.Count ? _follower.Finish(read, places, progress) : null;
    }

    /// <summary>Stops where it is not finished, and waits for that.</summary>
    public void Dispose()
    {
        _stop.Cancel();
        End();
        _pipe.Stop();
        _follower.Stop();
        OwnThread.Wait(_both);
        _follower.Dispose();
        _pipe.Dispose();
        _planned.Dispose();
        _stop.Dispose();
    }

    private void Write(GCodeFormat format)
    {
        GCodeWriter? writer = null;
        var next = 0;
        try
        {
            using var stream = new PipedStream(null, _pipe);
            foreach (var soFar in _planned.GetConsumingEnumerable())
            {
                if (writer is null) (writer = new GCodeWriter(soFar, format)).WriteStart(stream);
                writer.GoOn(soFar);
                for (; next < soFar.Blocks.Count && !_isOver; next++) writer.WriteBlock(stream, next);
            }
        }
        finally
        {
            _pipe.Complete();
        }
    }

    private void Read(PrintSetup setup)
        => ReadBack.Decode(_pipe, setup, new DecodeOptions { Threads = 1, ChunkSize = ReadBack.ChunkSize, KeepsBlocks = false, Follow = Follow }, _stop.Token)
            .OrThrow();

    private void Follow(DecodedBlock block)
    {
        if (!_follower.Take(block)) return;
        _digests.Add(MoveDigest.Of(block));
        _blocks++;
    }
}

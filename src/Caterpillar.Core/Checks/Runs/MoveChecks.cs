namespace Caterpillar.Checks;

/// <summary>
/// All checks of a print, which may see its blocks while the rest of it is still being planned, written and read: single moves at once, what is printed on a
/// thread of its own (by far the longest of all checks), and what a whole file must do in the end.
/// </summary>
internal sealed class MoveChecks : IDisposable
{
    /// <summary>How many blocks of a whole toolpath may wait for the check of the print: all of them might not fit into memory.</summary>
    public const int FewBlocks = 8;

    private readonly PrintSetup _setup;
    private readonly IReadOnlyList<ToolpathTool> _tools;
    private readonly Func<Findings> _findings;
    private readonly CancellationToken _cancel;
    private readonly CancellationTokenSource _stop;
    private readonly BlockingCollection<DecodedBlock> _waiting;
    private readonly Findings _ofMoves;
    private readonly Findings _ofPrint;
    private readonly Findings _ofUser;
    private readonly CheckRun? _moves;
    private readonly OwnChecks _own;
    private readonly bool _looksAtPrint;
    private Task? _printing;
    private int _shown;
    private int _printed;
    private bool _isLate;
    private volatile Toolpath? _whole;
    private volatile IProgress<double>? _progress;

    /// <param name="setup">The printer, material and settings.</param>
    /// <param name="tools">The tools of the moves.</param>
    /// <param name="findings">Makes empty lists of findings.</param>
    /// <param name="cancel">Cancels.</param>
    /// <param name="waiting">Number of blocks that wait at most; whoever brings more waits, too.</param>
    /// <param name="looksAtPrint">False if what is printed was looked at before.</param>
    public MoveChecks(
        PrintSetup setup, IReadOnlyList<ToolpathTool> tools, Func<Findings> findings, CancellationToken cancel, int waiting = int.MaxValue,
        bool looksAtPrint = true)
    {
        (_setup, _tools, _findings, _cancel) = (setup, tools, findings, cancel);
        _stop = CancellationTokenSource.CreateLinkedTokenSource(cancel);
        _waiting = new BlockingCollection<DecodedBlock>(waiting);
        (_ofMoves, _ofPrint, _ofUser) = (findings(), findings(), findings());
        _own = new OwnChecks(setup, _ofUser);
        _looksAtPrint = looksAtPrint && _ofPrint.LooksFor(DepositCheck.AllCodes);
        MoveCheck[] checks =
        [
            new PositionCheck(setup.Printer, _ofMoves), new RateCheck(tools, setup, _ofMoves), new ExtruderCheck(setup, _ofMoves),
            new GapCheck(_ofMoves),
        ];
        checks = Asked(checks, _ofMoves);
        if (checks.Length > 0) _moves = new CheckRun(checks, tools, cancel);
    }

    /// <summary>The next block that is full.</summary>
    public void Take(DecodedBlock block)
    {
        _shown++;
        Look(block);
        // As long as the file does not say how thick its layers are, all of it must be known.
        _isLate |= block.Thicknesses is null;
        if (!_isLate) Print(block);
    }

    /// <summary>The findings of the whole toolpath, which starts with the blocks taken so far.</summary>
    public IReadOnlyList<Diagnostic> Finish(Toolpath whole, CheckScope scope, IProgress<double>? progress)
    {
        // A file may have other tools than were planned.
        if (!whole.Tools.SequenceEqual(_tools))
        {
            using var again = new MoveChecks(_setup, whole.Tools, _findings, _cancel, FewBlocks);
            return again.Finish(whole, scope, progress);
        }
        (_whole, _progress) = (whole, progress);
        var ofFile = _findings();
        MoveCheck[] checks = [new HeatCheck(_setup, scope, ofFile), new FileCheck(whole, scope, ofFile)];
        if (!scope.IsPlanned) checks = [.. checks, new ModeCheck(_setup.Printer, ofFile)];
        var file = new CheckRun(Asked(checks, ofFile), whole.Tools, _cancel);
        var (number, shown, printed) = (0, _shown, _printed);
        foreach (var block in CheckRun.BlocksOf(whole))
        {
            if (number >= printed) Print(block);
            if (number >= shown) Look(block);
            file.Block(block, _ => { });
            number++;
        }
        _waiting.CompleteAdding();
        _moves?.End(whole);
        file.End(whole);
        new CommandCheck(whole, _setup.Printer, scope, ofFile).Run();
        if (_printing is not null)
        {
            OwnThread.Wait(_printing);
            _cancel.ThrowIfCancellationRequested();
            _printing.GetAwaiter().GetResult();
        }
        progress?.Report(1);
        return [.. _ofMoves.ToList(whole.Count), .. ofFile.ToList(), .. _ofPrint.ToList(whole.Count), .. _ofUser.ToList()];
    }

    /// <summary>Nothing more is checked.</summary>
    public void Stop() => _stop.Cancel();

    /// <summary>Stops unfinished work and waits for its end.</summary>
    public void Dispose()
    {
        Stop();
        _waiting.CompleteAdding();
        if (_printing is not null) OwnThread.Wait(_printing);
        _waiting.Dispose();
        _stop.Dispose();
    }

    private static MoveCheck[] Asked(MoveCheck[] checks, Findings findings) => Array.FindAll(checks, c => findings.LooksFor(c.Codes));

    private void Look(DecodedBlock block)
    {
        _moves?.Block(block, _ => { });
        _own.Take(block);
    }

    private void Print(DecodedBlock block)
    {
        if (!_looksAtPrint) return;
        _printing ??= OwnThread.Run(Print);
        _printed++;
        // Where the work has failed or was stopped nobody makes room.
        while (!_printing.IsCompleted && !_waiting.TryAdd(block, 20))
        {
        }
    }

    private void Print()
    {
        var run = new CheckRun([new DepositCheck(_setup, _ofPrint, _stop.Token)], _tools, _stop.Token);
        foreach (var block in _waiting.GetConsumingEnumerable())
        {
            run.Block(block, at =>
            {
                if (_progress is { } progress && _whole is { } whole) progress.Report(at / (double)whole.Count);
            });
        }
        _stop.Token.ThrowIfCancellationRequested();
        run.End(_whole!);
    }
}

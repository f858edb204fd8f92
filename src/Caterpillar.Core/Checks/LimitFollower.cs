using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>Checks single moves against the limits of the printer, block by block as they are read, on the thread that reads.</summary>
internal sealed class LimitFollower
{
    private readonly IReadOnlyList<ToolpathTool> _tools;
    private readonly Findings _findings;
    private readonly IMoveCheck[] _checks;
    private readonly CheckRun _run;
    private int _blocks;

    /// <param name="tools">The tools of what is read.</param>
    /// <param name="setup">The printer, material and settings.</param>
    /// <param name="findings">Where findings go.</param>
    /// <param name="cancel">Cancels.</param>
    public LimitFollower(IReadOnlyList<ToolpathTool> tools, PrintSetup setup, Findings findings, CancellationToken cancel)
    {
        _tools = tools;
        _findings = findings;
        IMoveCheck[] checks =
        [
            new PositionCheck(setup.Printer, findings), new RateCheck(tools, setup, findings), new StationaryCheck(setup.Printer, findings),
            new GapCheck(findings),
        ];
        _checks = Array.FindAll(checks, c => findings.LooksFor(c.Codes));
        _run = new CheckRun(_checks, tools, cancel);
    }

    /// <summary>The next block.</summary>
    public void Take(DecodedBlock block)
    {
        _blocks++;
        if (_checks.Length > 0) _run.Block(block, _ => { });
    }

    /// <summary>What was found in the whole toolpath; null where it has other tools.</summary>
    public IReadOnlyList<Diagnostic>? Finish(Toolpath whole)
    {
        if (!whole.Tools.SequenceEqual(_tools)) return null;
        foreach (var block in CheckRun.BlocksOf(whole, _blocks)) Take(block);
        _run.End(whole);
        return _findings.ToList();
    }
}

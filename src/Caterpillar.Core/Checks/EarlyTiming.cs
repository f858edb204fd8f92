using System.Collections.Generic;
using System.Threading;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>Times a print while the rest of it is still being planned.</summary>
internal sealed class EarlyTiming(PrintSetup setup)
{
    private readonly List<ToolpathColumns> _blocks = [];
    private Toolpath? _soFar;
    private MotionPlanner? _planner;

    /// <summary>The toolpath as far as it is planned.</summary>
    public void Take(Toolpath soFar, CancellationToken cancel)
    {
        _planner ??= new MotionPlanner(soFar, setup, timesOnly: true);
        _planner.Take(soFar, null, cancel);
        for (var i = _blocks.Count; i < soFar.Blocks.Count; i++) _blocks.Add(soFar.Blocks[i].Columns);
        _soFar = soFar;
    }

    /// <summary>The times of the whole toolpath, once; null where it does not begin with what was planned, or nothing was.</summary>
    public MotionColumns? Finish(Toolpath whole, CancellationToken cancel)
    {
        if (_planner is not { } planner || _soFar is not { } soFar || !Begins(whole, soFar)) return null;
        _planner = null;
        planner.Take(whole, null, cancel);
        return planner.End().Motion;
    }

    private bool Begins(Toolpath whole, Toolpath soFar)
    {
        if (whole.Blocks.Count < _blocks.Count || whole.Start != soFar.Start || whole.Tools.Count != soFar.Tools.Count) return false;
        for (var i = 0; i < _blocks.Count; i++)
        {
            if (!ReferenceEquals(whole.Blocks[i].Columns, _blocks[i])) return false;
        }
        for (var i = 0; i < soFar.Tools.Count; i++)
        {
            if (whole.Tools[i] != soFar.Tools[i]) return false;
        }
        // Those at the very end of what was planned have not been looked at.
        var events = 0;
        for (; events < soFar.Events.Count && soFar.Events[events].Move < soFar.Count; events++)
        {
            if (events >= whole.Events.Count || whole.Events[events] != soFar.Events[events]) return false;
        }
        return events == whole.Events.Count || whole.Events[events].Move >= soFar.Count;
    }
}

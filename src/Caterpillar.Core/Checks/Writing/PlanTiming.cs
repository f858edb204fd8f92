namespace Caterpillar.Checks;

/// <summary>Times a plan on another thread while it is still being made.</summary>
internal sealed class PlanTiming(PrintSetup setup, CancellationToken cancel)
{
    private Task<MotionPlanner>? _timed;

    /// <summary>The toolpath as far as it is planned.</summary>
    public void Take(Toolpath soFar)
        => _timed = _timed?.ContinueWith(before => Timed(before.GetAwaiter().GetResult(), soFar), TaskScheduler.Default)
            ?? Task.Run(() => Timed(new MotionPlanner(soFar, setup, timesOnly: true), soFar));

    /// <summary>Has timed the beginning; null for a short plan.</summary>
    public MotionPlanner? Finish() => _timed is null ? null : OwnThread.Join(_timed);

    private MotionPlanner Timed(MotionPlanner planner, Toolpath soFar)
    {
        planner.Take(soFar, null, cancel);
        return planner;
    }
}

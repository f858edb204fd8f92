namespace Caterpillar.Checks;

/// <summary>Times a print and adds progress commands for the display. Start and end code are not timed.</summary>
internal static class ProgressCommands
{
    /// <summary>
    /// The toolpath with a <see cref="ProgressEvent"/> wherever the percent or the minutes left change, unchanged where the printer wants none; and the
    /// seconds that it takes, null for nothing.
    /// </summary>
    /// <param name="toolpath">The toolpath.</param>
    /// <param name="setup">The printer, material and settings.</param>
    /// <param name="begun">Has timed the beginning; null for nobody.</param>
    /// <param name="cancel">Cancels.</param>
    public static (Toolpath Toolpath, double? Seconds) Add(Toolpath toolpath, PrintSetup setup, MotionPlanner? begun, CancellationToken cancel)
    {
        var planner = begun ?? new MotionPlanner(toolpath, setup, timesOnly: true);
        planner.Take(toolpath, null, cancel);
        var motion = planner.End().Motion;
        if (!(motion.TotalTime > 0)) return (toolpath, null);
        var isShown = setup.Printer.ProgressCommands && setup.Printer.Flavor.Progress != ProgressCommand.None;
        return (isShown ? toolpath.With(events: Events(toolpath, motion)) : toolpath, motion.TotalTime);
    }

    private static List<MoveEvent> Events(Toolpath toolpath, MotionColumns motion)
    {
        var all = new List<MoveEvent>();
        var next = 0;
        var shown = ((int, int)?)null;
        for (var move = 0; move <= toolpath.Count; move++)
        {
            var now = move == toolpath.Count ? (Percent: 100, Minutes: 0) : At(motion.TotalTime, motion.StartTime(motion.First[move]));
            // Before what happens at the move: a tool, a dwell.
            if (now != shown)
            {
                shown = now;
                all.Add(new MoveEvent(move, new ProgressEvent(now.Percent, now.Minutes)));
            }
            for (; next < toolpath.Events.Count && toolpath.Events[next].Move <= move; next++) all.Add(toolpath.Events[next]);
        }
        return all;
    }

    // Whole percents that are over; minutes to the nearest.
    private static (int Percent, int Minutes) At(double all, double time)
        => ((int)Math.Floor(100 * time / all), (int)Math.Floor((all - time) / 60 + 0.5));
}

namespace Caterpillar.Simulation;

/// <summary>Finds the speeds of a run of segments, which begins and ends at rest, so that none has to change faster than its acceleration allows.</summary>
internal abstract class LookAhead
{
    /// <summary>
    /// Sets start, peak and end of the first segments of a run and says how many are final: all where the run ends here, else those whose speeds nothing
    /// that follows can change.
    /// </summary>
    public abstract int Plan(MotionSegment[] run, int count, bool ends);
}

/// <summary>
/// As Marlin and firmware like it: the speed at the start of a segment is the highest from which all that is in the queue can still be braked, and which the
/// segment before can reach. A queue of n moves holds the one that runs and n − 1 more.
/// </summary>
/// <remarks>
/// Braking over a segment is the map v² → min(entry, v² + gain). Such maps combine to maps of the same form, min(cap, v² + rise), so a window over the
/// queue is the end of one stretch of
/// n − 1 segments and the beginning of the next, whose maps are kept: constant work for each segment, whatever the length of the queue.
/// </remarks>
internal sealed class QueueLookAhead(int queue) : LookAhead
{
    private const int LeastStretch = 1024;
    private readonly int _window = queue == 0 ? int.MaxValue : Math.Max(queue - 1, 1);
    private double[] _caps = [];
    private double[] _rises = [];

    public override int Plan(MotionSegment[] run, int count, bool ends)
    {
        if (!ends && count - _window < LeastStretch) return 0;
        if (_window >= count) WholeQueue(run, count);
        else Windows(run, count, ends);
        var done = ends ? count : count - _window;
        var start2 = run[0].Start2;
        for (var i = 0; i < done; i++)
        {
            ref var s = ref run[i];
            var gain = s.Gain;
            s.Start2 = start2;
            s.End2 = i + 1 < count ? Math.Min(run[i + 1].Start2, start2 + gain) : Math.Min(s.Rest2, start2 + gain);
            s.Peak2 = Math.Max(Math.Min(s.Speed2, (start2 + s.End2 + gain) / 2), Math.Max(start2, s.End2));
            start2 = s.End2;
        }
        if (done < count) run[done].Entry2 = start2;
        return done;
    }

    // Start2 becomes the highest speed from which the rest of the run can be braked.
    private static void WholeQueue(MotionSegment[] run, int count)
    {
        var next = run[count - 1].Rest2;
        for (var i = count - 1; i >= 0; i--)
        {
            ref var s = ref run[i];
            next = Math.Min(s.Entry2, next + s.Gain);
            s.Start2 = next;
        }
    }

    private void Windows(MotionSegment[] run, int count, bool ends)
    {
        if (_caps.Length == 0) (_caps, _rises) = (new double[_window], new double[_window]);
        for (var from = 0; from < count; from += _window)
        {
            var to = Math.Min(from + _window, count);
            // Maps from each segment of this stretch to its end.
            double cap = double.PositiveInfinity, rise = 0;
            for (var i = to - 1; i >= from; i--)
            {
                var gain = run[i].Gain;
                cap = Math.Min(run[i].Entry2, cap + gain);
                rise += gain;
                (_caps[i - from], _rises[i - from]) = (cap, rise);
            }
            // For each start one segment more after that end, until the run is over. What the queue does not hold yet may be a stop.
            cap = double.PositiveInfinity;
            rise = 0;
            var last = to - 1;
            for (var i = from; i < to; i++)
            {
                if (i > from && last + 1 < count)
                {
                    last++;
                    cap = Math.Min(cap, run[last].Entry2 + rise);
                    rise += run[last].Gain;
                }
                var rest = ends && last == count - 1 ? run[last].Rest2 : 0;
                run[i].Start2 = Math.Min(_caps[i - from], Math.Min(cap, rest + rise) + _rises[i - from]);
            }
        }
    }
}

/// <summary>
/// As Klipper: the whole run is known. A second profile with less acceleration, from rest to rest, gives the highest speed that the first may use, so that
/// short moves do not speed up and brake without pause (minimum_cruise_ratio).
/// </summary>
/// <remarks>
/// Where both profiles are limited by what lies before a segment, and the peak begins afresh, nothing that follows changes what lies before: there a long run
/// is divided, so that few segments are kept.
/// </remarks>
internal sealed class CruiseLookAhead : LookAhead
{
    private const int FirstTry = 1024;
    private int _tryAt = FirstTry;

    // Segments whose highest starts are known, what the next can be reached with, and the peak of the last that is final.
    private int _entered;
    private double _reach, _slowReach, _before;

    public override int Plan(MotionSegment[] run, int count, bool ends)
    {
        Enter(run, count);
        var done = ends ? count : FinalCount(run, count);
        if (done < count) Brake(run, done, run[done].Start2, run[done].Slow2);
        else Brake(run, done, 0, 0);
        Cruise(run, done);
        // The next run begins at rest, whatever was before.
        if (ends) _tryAt = FirstTry;
        _entered -= done;
        return done;
    }

    private void Enter(MotionSegment[] run, int count)
    {
        for (; _entered < count; _entered++)
        {
            ref var s = ref run[_entered];
            s.Start2 = Math.Min(s.Entry2, _reach);
            s.Slow2 = Math.Min(s.Start2, _slowReach);
            _reach = s.Start2 + s.Gain;
            _slowReach = s.Slow2 + s.SlowGain;
        }
    }

    // Segments that nothing changes any more, also if the run could go on at any speed.
    private int FinalCount(MotionSegment[] run, int count)
    {
        if (count < _tryAt) return 0;
        double next = 0, slowNext = 0;
        for (var i = count - 1; i > 0; i--)
        {
            ref var s = ref run[i];
            var reach = next + s.Gain;
            var slowReach = slowNext + s.SlowGain;
            if (s.Start2 <= reach && s.Slow2 < slowReach && HasTop(run[i - 1], s.Slow2))
            {
                _tryAt = count - i + FirstTry;
                return i;
            }
            next = Math.Min(s.Start2, reach);
            slowNext = Math.Min(s.Slow2, slowReach);
        }
        // So that all tries together take no longer than the run.
        _tryAt = 2 * count;
        return 0;
    }

    private static bool HasTop(in MotionSegment s, double slowNext) => s.Slow2 < slowNext + s.SlowGain && s.Slow2 + s.SlowGain > slowNext;

    // From the last to the first; the peak of segments in which the slower profile only falls stays open (NaN): it is that of the segment before.
    private static void Brake(MotionSegment[] run, int count, double next, double slowNext)
    {
        var highest = double.NaN;
        var open = 0;
        for (var i = count - 1; i >= 0; i--)
        {
            ref var s = ref run[i];
            var reach = next + s.Gain;
            var slowReach = slowNext + s.SlowGain;
            var start = Math.Min(s.Start2, reach);
            var slow = Math.Min(s.Slow2, slowReach);
            open++;
            s.Peak2 = double.NaN;
            if (slow < slowReach)
            {
                // Here the slower profile has its top, or it rises to one that lies farther on.
                if (open > 1 || slow + s.SlowGain > slowNext) highest = (slow + slowReach) / 2;
                s.Peak2 = Math.Min(Math.Min(s.Speed2, highest), (start + reach) / 2);
                open = 0;
            }
            s.Start2 = start;
            s.End2 = next;
            next = start;
            slowNext = slow;
        }
    }

    private void Cruise(MotionSegment[] run, int count)
    {
        for (var i = 0; i < count; i++)
        {
            ref var s = ref run[i];
            if (double.IsNaN(s.Peak2)) s.Peak2 = Math.Min(_before, s.Start2);
            s.Start2 = Math.Min(s.Start2, s.Peak2);
            s.End2 = Math.Min(s.End2, s.Peak2);
            _before = s.Peak2;
        }
    }
}

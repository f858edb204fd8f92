using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Simulation;
using NUnit.Framework;

namespace Caterpillar.Tests.Simulation;

/// <summary>Long runs that are planned in parts, against the same runs planned at once.</summary>
public class LookAheadTests
{
    [Test]
    public void A_long_run_in_parts_has_the_speeds_of_the_run_at_once([Range(1, 12)] int seed)
    {
        var random = new Random(seed);
        var run = Run(random, 6000, slow: seed % 4 == 0 ? 1 : 0.2 + 0.7 * random.NextDouble());
        var once = (MotionSegment[])run.Clone();
        Assert.That(new CruiseLookAhead().Plan(once, once.Length, ends: true), Is.EqualTo(once.Length));
        var (parts, most) = InParts(new CruiseLookAhead(), run, 100 + random.Next(400));
        Assert.That(most, Is.LessThan(4000), "segments that wait");
        for (var i = 0; i < run.Length; i++)
        {
            Assert.That((parts[i].Start2, parts[i].Peak2, parts[i].End2), Is.EqualTo((once[i].Start2, once[i].Peak2, once[i].End2)), $"{i}");
            if (i > 0) Assert.That(parts[i].Start2, Is.EqualTo(parts[i - 1].End2).Within(1e-9));
            Assert.That(parts[i].Peak2, Is.InRange(Math.Max(parts[i].Start2, parts[i].End2), parts[i].Speed2));
            // What the acceleration allows: up to the peak and down from it.
            Assert.That(2 * parts[i].Peak2 - parts[i].Start2 - parts[i].End2, Is.LessThanOrEqualTo(parts[i].Gain + 1e-9));
        }
    }

    [Test]
    public void Several_runs_after_each_other_know_nothing_of_each_other()
    {
        var planner = new CruiseLookAhead();
        var first = Run(new Random(3), 5000, 0.5);
        var alone = InParts(new CruiseLookAhead(), first, 256).Segments;
        InParts(planner, Run(new Random(4), 3000, 0.5), 256);
        var after = InParts(planner, first, 256).Segments;
        Assert.That(after.Select(s => (s.Start2, s.Peak2, s.End2)), Is.EqualTo(alone.Select(s => (s.Start2, s.Peak2, s.End2))));
    }

    // While a run speeds up for long nothing is final; after that few segments wait again.
    [Test]
    public void A_long_rise_holds_segments_only_while_it_lasts()
    {
        var rise = Enumerable.Range(0, 5000)
            .Select(i => new MotionSegment { Length = 0.1, Acceleration = 1000, Speed2 = 1e6, Entry2 = i > 0 ? 1e6 : 0, SlowGain = 100 });
        var random = Run(new Random(5), 20_000, 0.5).Select((s, i) => s with { Entry2 = i > 0 ? s.Entry2 : s.Speed2 });
        var run = rise.Concat(random).ToArray();
        var once = (MotionSegment[])run.Clone();
        new CruiseLookAhead().Plan(once, once.Length, ends: true);
        var (parts, most) = InParts(new CruiseLookAhead(), run, 256);
        Assert.That(most, Is.InRange(5000, 10_500));
        Assert.That(parts.Select(s => (s.Start2, s.Peak2, s.End2)), Is.EqualTo(once.Select(s => (s.Start2, s.Peak2, s.End2))));
        var planner = new CruiseLookAhead();
        InParts(planner, rise.ToArray(), 256);
        Assert.That(InParts(planner, random.ToArray(), 256).Most, Is.LessThan(4000), "the run before is over");
    }

    // A queue of 16: the last 15 of a run may still change, and fewer than 1024 are not worth it.
    [TestCase(1038, false, 0)]
    [TestCase(1039, false, 1024)]
    [TestCase(2000, false, 1985)]
    [TestCase(20, true, 20)]
    [TestCase(15, true, 15)]
    [TestCase(2000, true, 2000)]
    public void What_a_queue_has_passed_is_final(int count, bool ends, int final)
        => Assert.That(new QueueLookAhead(16).Plan(Run(new Random(1), count, 1), count, ends), Is.EqualTo(final));

    // As the planner does: segments are added, and what is final leaves.
    private static (List<MotionSegment> Segments, int Most) InParts(CruiseLookAhead planner, MotionSegment[] run, int step)
    {
        var result = new List<MotionSegment>();
        var waiting = new MotionSegment[run.Length];
        var (count, most) = (0, 0);
        for (var i = 0; i < run.Length; i++)
        {
            waiting[count++] = run[i];
            most = Math.Max(most, count);
            var ends = i == run.Length - 1;
            if (!ends && i % step != 0) continue;
            var done = planner.Plan(waiting, count, ends);
            result.AddRange(waiting.Take(done));
            Array.Copy(waiting, done, waiting, 0, count - done);
            count -= done;
        }
        return (result, most);
    }

    // Long and short, fast and slow, with corners of all speeds; now and then a stretch of very short ones.
    private static MotionSegment[] Run(Random random, int count, double slow)
    {
        var run = new MotionSegment[count];
        var tiny = 0;
        for (var i = 0; i < count; i++)
        {
            if (random.Next(300) == 0) tiny = random.Next(60);
            var length = tiny-- > 0 ? 0.02 : Math.Exp(4 * random.NextDouble() - 2);
            var acceleration = random.Next(4) == 0 ? 500 : 3000;
            var speed = random.Next(3) == 0 ? 20 : 20 + 180 * random.NextDouble();
            run[i] = new MotionSegment { Length = length, Acceleration = acceleration, Speed2 = speed * speed, SlowGain = 2 * length * acceleration * slow };
            var corner = random.Next(3) == 0 ? 5 + 5 * random.NextDouble() : 200;
            if (i > 0) run[i].Entry2 = Math.Min(corner * corner, Math.Min(run[i].Speed2, run[i - 1].Speed2));
        }
        return run;
    }
}

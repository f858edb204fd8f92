using System;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>States of a machine read alike only if every following line would do the same.</summary>
[Category("Arithmetic")]
public class StateTests
{
    private static Modes With(Func<Modes, Modes> change) => change(default);

    [Test]
    public void Modes_read_alike_if_all_words_that_a_file_can_say_are_the_same()
    {
        Modes[] all =
        [
            default,
            With(m => { m.Motion = 1; return m; }),
            With(m => { m.Plane = ArcPlane.YZ; return m; }),
            With(m => { m.Relative = true; return m; }),
            With(m => { m.Inches = true; return m; }),
            With(m => { m.AbsoluteCenters = true; return m; }),
            With(m => { m.Volumetric = true; return m; }),
            With(m => { m.M83 = true; return m; }),
            With(m => { m.LastRelative = true; return m; }),
        ];
        for (var i = 0; i < all.Length; i++)
        {
            for (var k = 0; k < all.Length; k++) Assert.That(all[i].ReadsLike(all[k]), Is.EqualTo(i == k), $"{i}, {k}");
        }
    }

    [TestCase(false, false, false, false, false, false, false)]
    [TestCase(true, false, false, true, false, false, true)]
    [TestCase(false, true, true, true, true, true, false)]
    [TestCase(true, true, false, true, false, true, true)]
    public void Firmwares_resolve_the_mode_of_E_each_in_its_own_manner(
        bool relative, bool m83, bool last, bool either, bool lastWins, bool only, bool own)
    {
        var modes = With(m => { (m.Relative, m.M83, m.LastRelative) = (relative, m83, last); return m; });
        bool By(RelativeERule rule)
        {
            modes.ResolveE(rule);
            return modes.RelativeE;
        }
        Assert.That((By(RelativeERule.EitherG91OrM83), By(RelativeERule.LastWins), By(RelativeERule.OnlyM82M83)), Is.EqualTo((either, lastWins, only)));
        Assert.That(Enum.GetValues(typeof(RelativeERule)).Cast<RelativeERule>()
            .Where(r => r is not (RelativeERule.EitherG91OrM83 or RelativeERule.LastWins or RelativeERule.OnlyM82M83)).Select(By), Is.All.EqualTo(own));
        Assert.That(modes.IsRelativeEDisputed, Is.EqualTo(either != last || either != m83));
    }

    [Test]
    public void Saved_states_come_back_in_reverse_and_by_name()
    {
        SavedState Of(string name, double speed) => new(name, default, new FeedState { Rate = speed }, default, default, Vec3.Zero, 0);
        var saved = SavedStates.None;
        Assert.That(saved.Pop(), Is.Null);
        saved.Push(Of("", 1));
        saved.Push(Of("", 2));
        var before = saved;
        Assert.That((saved.Pop()!.Feed.Rate, saved.Pop()!.Feed.Rate), Is.EqualTo((2.0, 1.0)));
        Assert.That((before.ReadsLike(saved), before.ReadsLike(before), saved.ReadsLike(SavedStates.None)), Is.EqualTo((false, true, true)));
        saved.SetNamed(Of("a", 3));
        saved.SetNamed(Of("b", 4));
        saved.SetNamed(Of("a", 5));
        Assert.That((saved.Named("a")!.Feed.Rate, saved.Named("b")!.Feed.Rate, saved.Named("c")), Is.EqualTo((5.0, 4.0, (SavedState?)null)));
        Assert.That(saved.ReadsLike(SavedStates.None), Is.False);
        for (var i = 0; i < 150; i++) saved.Push(Of("", i));
        var count = 0;
        while (saved.Pop() is not null) count++;
        Assert.That(count, Is.EqualTo(100));
        var none = SavedStates.None;
        Assert.That((none with { Offset = new Vec3(1, 0) }).ReadsLike(none), Is.False);
        Assert.That((none with { Babysteps = 1 }).ReadsLike(none), Is.False);
        Assert.That((none with { OffsetE = 1 }).ReadsLike(none), Is.False);
    }

    [TestCase(0, 0, 0, true)]
    [TestCase(1, 0, 0, false)]
    [TestCase(0, 1, 0, false)]
    [TestCase(0, 0, 1, false)]
    public void Heads_read_alike_at_the_same_place_with_the_same_shifts(double x, double y, double z, bool alike)
    {
        var head = new HeadPosition { X = 5, Y = 6, Z = 7, ShiftX = 1, ShiftY = 2, ShiftZ = 3 };
        Assert.That(head.ReadsLike(head with { X = 5 + x, Y = 6 + y, Z = 7 + z }), Is.EqualTo(alike));
        Assert.That(head.ReadsLike(head with { ShiftX = 1 + x, ShiftY = 2 + y, ShiftZ = 3 + z }), Is.EqualTo(alike));
        Assert.That(head.HasShiftOf(head with { X = 9 }), Is.True);
    }
}

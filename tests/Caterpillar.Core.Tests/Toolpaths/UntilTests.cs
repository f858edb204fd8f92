using System;
using System.Linq;
using System.Threading;
using Caterpillar.Geometry;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>The beginning of a toolpath, and edits that are canceled.</summary>
internal sealed class UntilTests
{
    private static readonly Toolpath Whole = Make(70_000);

    private static Toolpath Make(int moves)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.AddLayer(new Layer(0, 0.2, 0.2));
        for (var i = 0; i < moves; i++)
        {
            if (i % 1000 == 0) builder.AddEvent(new CommentEvent("move " + i));
            var arc = i % 100 == 99 ? new Arc(new Vec3(i - 0.5, 0, 0.2), 180) : (Arc?)null;
            builder.Add(new Vec3(i, i % 2, 0.2), 0.5, 0.4, 40, i % 10 == 0 ? MoveKind.Travel : MoveKind.Print, Role.Infill, 0, 0, i, arc);
        }
        return builder.Build([new ToolpathTool(2.4)]);
    }

    [TestCase(0, 0.0)]
    [TestCase(0, 0.5)]
    [TestCase(99, 0.25)]
    [TestCase(1000, 0.0)]
    [TestCase(1000, 0.5)]
    [TestCase(65_536, 0.0)]
    [TestCase(65_536, 0.5)]
    [TestCase(69_999, 0.99)]
    public void It_has_the_moves_before_and_a_part_of_the_next(int move, double done)
    {
        var until = Whole.Until(move, new Vec3(1, 2, 3), done);
        var count = done > 0 ? move + 1 : move;
        Assert.That(until.Count, Is.EqualTo(count));
        Assert.That(until.Moves().Take(move).SequenceEqual(Whole.Moves().Take(move)), Is.True);
        Assert.That(until.Events.Select(e => e.Move), Is.EqualTo(Whole.Events.Select(e => e.Move).Where(m => m < count)));
        if (done == 0) return;
        var (last, whole) = (until[move], Whole[move]);
        Assert.That((last.End, last.E, last.Deposited), Is.EqualTo((new Vec3(1, 2, 3), 0.5 * done, 0.4 * done)));
        Assert.That(last.Arc?.Sweep, Is.EqualTo(whole.Arc?.Sweep * done));
        Assert.That(Whole[move], Is.EqualTo(whole), "The whole one stays.");
    }

    [Test]
    public void At_the_end_it_is_the_toolpath_and_before_it_shares_blocks()
    {
        Assert.That(Whole.Until(Whole.Count, Vec3.Zero, 0), Is.SameAs(Whole));
        Assert.That(Whole.Until(66_000, Vec3.Zero, 0.5).Blocks[0], Is.SameAs(Whole.Blocks[0]));
        Assert.That(() => Whole.Until(-1, Vec3.Zero, 0), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void Edits_can_be_canceled()
    {
        var (all, canceled) = (new MoveFilter(), new CancellationToken(canceled: true));
        Action[] edits =
        [
            () => Whole.ScaleSpeed(all, 2, canceled), () => Whole.ScaleFlow(all, 2, canceled), () => Whole.Keep(all, canceled),
            () => Whole.Remove(all, canceled), () => Whole.Transform(all, Affine.Identity, cancel: canceled),
            () => Whole.Deform(all, Deformation.Cartesian(p => p), cancel: canceled),
        ];
        foreach (var edit in edits) Assert.That(edit, Throws.InstanceOf<OperationCanceledException>());
    }

    [Test]
    public void An_edit_of_the_speed_shares_all_else()
    {
        var faster = Whole.ScaleSpeed(new MoveFilter { Kinds = [MoveKind.Print] }, 2);
        Assert.That(faster.Blocks[0].Columns.X, Is.SameAs(Whole.Blocks[0].Columns.X));
        Assert.That((faster[1].Speed, faster[0].Speed, Whole[1].Speed), Is.EqualTo((80.0, 40.0, 40.0)));
    }
}

using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>The comparer sees every kind of difference, and none if rounding is all.</summary>
public class SameMovesTests
{
    private static IEnumerable<TestCaseData> Changes()
    {
        yield return Change("place", m => m with { End = m.End + new Vec3(0, 0.003, 0) });
        yield return Change("amount", m => m with { E = m.E + 3e-5, Deposited = m.Deposited + 3e-5 });
        yield return Change("speed", m => m with { Speed = m.Speed + 0.01 });
        yield return Change("kind", m => m with { Kind = MoveKind.Travel });
        yield return Change("role", m => m with { Role = Role.Infill });
        yield return Change("layer", m => m with { Layer = 1 });
        yield return Change("tool", m => m with { Tool = 1 });
        yield return Change("arc", m => m with { Arc = new Arc(m.Start + (m.End - m.Start) / 2, 180) });
    }

    [TestCaseSource(nameof(Changes))]
    public void A_change_of_one_move_is_seen(Func<Move, Move> change)
    {
        for (var at = 2; at < 20; at += 6)
        {
            var changed = Path((m, i) => i == at ? change(m) : m);
            Assert.That(SameMoves.Difference(Path(), changed), Is.Not.Null);
            Assert.That(SameMoves.Difference(changed, Path()), Is.Not.Null);
        }
    }

    [Test]
    public void Lost_doubled_and_swapped_moves_and_events_are_seen()
    {
        Assert.That(SameMoves.Difference(Path(), Path(skip: 7)), Is.Not.Null);
        Assert.That(SameMoves.Difference(Path(skip: 7), Path()), Is.Not.Null);
        Assert.That(SameMoves.Difference(Path(), Path(skip: 19)), Is.Not.Null, "the last one");
        Assert.That(SameMoves.Difference(Path(), Path().Insert(5, new FanEvent(1))), Is.Not.Null);
        Assert.That(SameMoves.Difference(Path().Insert(5, new FanEvent(1)), Path().Insert(6, new FanEvent(1))), Is.Not.Null);
        Assert.That(SameMoves.Difference(Path().Insert(5, new PauseEvent()).Insert(5, new FanEvent(1)),
            Path().Insert(5, new FanEvent(1)).Insert(5, new PauseEvent())), Is.Not.Null);
    }

    [Test]
    public void Drift_below_a_unit_each_is_seen()
        => Assert.That(SameMoves.Difference(Path(), Path((m, _) => m with { E = m.E + 2e-6, Deposited = m.Deposited + 2e-6 })), Does.Contain("drift"));

    [Test]
    public void Rounding_is_no_difference()
    {
        static double Round(double value, int decimals) => Math.Round(value, decimals);
        var sum = 0.0;
        var printed = 0.0;
        var rounded = Path((m, _) =>
        {
            sum += m.E;
            var e = Round(sum, 5) - printed;
            printed += e;
            return m with { End = new Vec3(Round(m.End.X, 3), Round(m.End.Y, 3), Round(m.End.Z, 3)), E = e, Deposited = e };
        });
        Assert.That(SameMoves.Difference(Path(), rounded), Is.Null);
        Assert.That(SameMoves.Difference(Path(), Path()), Is.Null);
    }

    private static TestCaseData Change(string name, Func<Move, Move> change) => new TestCaseData(change).SetArgDisplayNames(name);

    private static Toolpath Path(Func<Move, int, Move>? change = null, int skip = -1)
    {
        var builder = new ToolpathBuilder(MoveSource.Lines, Vec3.Zero);
        builder.AddLayer(new Layer(0, 0.3, 0.3, ""));
        builder.AddLayer(new Layer(1, 0.6, 0.3, ""));
        for (var i = 0; i < 20; i++)
        {
            var move = new Move(i, builder.Position, new Vec3(10 * Math.Sqrt(i + 2), 7 * (i % 3) + 0.12345, 0.3), 0.123456 * (1 + i % 4),
                0.123456 * (1 + i % 4), 30, MoveKind.Print, Role.OuterWall, 0, 0, i + 1, null);
            if (i == skip) continue;
            if (change is not null) move = change(move, i);
            builder.Add(move.End, move.E, move.Deposited, move.Speed, move.Kind, move.Role, move.Layer, move.Tool, move.Source, move.Arc);
        }
        return builder.Build(Enumerable.Repeat(new ToolpathTool(null), 2));
    }
}

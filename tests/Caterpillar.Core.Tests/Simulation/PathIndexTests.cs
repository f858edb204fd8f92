using System;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Simulation;

/// <summary>Searches in paths of any number of blocks, layers and fan speeds, against walks through all moves.</summary>
public class PathIndexTests
{
    [TestCase(1)]
    [TestCase(2)]
    [TestCase(3)]
    [TestCase(7)]
    [TestCase(50)]
    public void Every_height_is_found_at_the_extrusion_that_reaches_it_first(int layers)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 0; i < layers; i++)
        {
            // Down again in every layer, and a travel far above.
            builder.Add(new Vec3(0, 0, 100), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, -1);
            builder.Add(new Vec3(10, i, i + 1), 1, 1, 50, MoveKind.Print, Role.Infill, -1, 0, -1);
            builder.Add(new Vec3(0, i, 0.5), 1, 1, 50, MoveKind.Print, Role.Infill, -1, 0, -1);
        }
        var index = new PathIndex(builder.Build([new ToolpathTool(1)]));
        for (var i = 0; i < layers; i++)
        {
            Assert.That(new[] { i + 0.01, i + 0.5, i + 1 }.Select(index.FirstAbove), Is.All.EqualTo(3 * i + 1), $"{i}");
        }
        Assert.That(index.FirstAbove(-1), Is.EqualTo(1));
        Assert.That(index.FirstAbove(layers + 0.01), Is.EqualTo(3 * layers));
    }

    [TestCase(0)]
    [TestCase(1)]
    [TestCase(2)]
    [TestCase(9)]
    public void The_fan_is_as_the_last_event_before_says(int events)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 0; i < 30; i++)
        {
            // The first is overwritten at once.
            if (i % 3 == 1 && i / 3 < events)
            {
                builder.AddEvent(new FanEvent(1), i);
                builder.AddEvent(new FanEvent((i / 3 + 1) / 16.0), i);
            }
            builder.Add(new Vec3(i + 1, 0), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, i);
        }
        var index = new PathIndex(builder.Build([new ToolpathTool(1)]));
        for (var i = 0; i < 30; i++) Assert.That(index.FanAt(i), Is.EqualTo(Math.Min((i + 2) / 3, events) / 16.0), $"{i}");
    }

    // Lengths without rounding; blocks hold 65,536 moves.
    [TestCase(1)]
    [TestCase(128)]
    [TestCase(129)]
    [TestCase(300)]
    [TestCase(65_536)]
    [TestCase(65_537)]
    [TestCase(140_000)]
    [TestCase(270_000)]
    public void Every_length_is_found_in_its_move(int moves)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 1; i <= moves; i++) builder.Add(new Vec3(0.5 * (i % 2), 0), 0.25, 0.25, 50, MoveKind.Print, Role.Infill, -1, i % 2, i);
        var toolpath = builder.Build([new ToolpathTool(2), new ToolpathTool(4)]);
        var index = new PathIndex(toolpath);
        Assert.That(index.Total, Is.EqualTo(new PathSums(0.5 * moves, 0.25 * moves, 0.5 * (moves / 2) + (moves + 1) / 2)));
        foreach (var i in Enumerable.Range(0, moves).Where(i => i < 3 || i > moves - 3 || i % 128 is 0 or 1 or 127 && i % 997 < 99 || Math.Abs(i % 65_536) < 2))
        {
            var sums = new PathSums(0.5 * i, 0.25 * i, 0.5 * (i / 2) + (i + 1) / 2);
            Assert.That(index.Before(i), Is.EqualTo(sums), $"{i}");
            Assert.That(index.AtLength(0.5 * i + 0.25), Is.EqualTo((i, sums)), $"{i}");
            Assert.That(index.AtLength(0.5 * i), Is.EqualTo((i, sums)), $"{i}");
        }
        Assert.That(index.AtLength(0.5 * moves), Is.EqualTo((moves, index.Total)));
        Assert.That(index.Before(moves), Is.EqualTo(index.Total));
    }

    [Test]
    public void Layers_begin_at_their_first_move()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 0; i < 3; i++) builder.AddLayer(new Layer(i, i + 1, 1));
        foreach (var layer in new[] { -1, 0, 0, 2, -1, 0, 2 })
            builder.Add(builder.Position + Vec3.UnitX, 0, 0, 50, MoveKind.Travel, Role.Unspecified, layer, 0, -1);
        var index = new PathIndex(builder.Build([new ToolpathTool(1)]));
        Assert.That(Enumerable.Range(0, 3).Select(index.StartOfLayer), Is.EqualTo(new[] { 1, 7, 3 }));
        Assert.That((index.SourcesAscend, index.SourcedMoves), Is.EqualTo((true, 0)));
    }

    // A move that neither moves nor pushes anything has no flow, also where its tool is known.
    [Test]
    public void A_move_without_length_and_E_has_no_flow()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(10, 0), 1, 1, 50, MoveKind.Print, Role.Infill, -1, 0, 0);
        builder.Add(new Vec3(10, 0), 0, 0, 50, MoveKind.Print, Role.Infill, -1, 0, 1);
        builder.Add(new Vec3(20, 0), 1, 1, 50, MoveKind.Print, Role.Infill, -1, 0, 2);
        var timeline = Timeline.Of(builder.Build([new ToolpathTool(1)]), new PrintSetup());
        Assert.That((timeline.AtMove(1).Flow, timeline.AtMove(1).Speed), Is.EqualTo(((double?)0, 0.0)));
    }
}

using System;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>Moves are chosen and changed in a toolpath.</summary>
public class ToolpathEditTests
{
    [Test]
    public void All_conditions_of_a_filter_must_hold()
    {
        var sample = Sample();
        void Chosen(MoveFilter filter, params int[] moves)
        {
            Assert.That(sample.Moves().Where(m => filter.Matches(sample, m)).Select(m => m.Index), Is.EqualTo(moves));
            // The same in columns.
            var doubled = sample.ScaleSpeed(filter, 2);
            Assert.That(doubled.Moves().Where(m => m.Speed != sample[m.Index].Speed).Select(m => m.Index), Is.EqualTo(moves));
        }
        Chosen(new MoveFilter(), 0, 1, 2, 3, 4, 5);
        Chosen(new MoveFilter { Roles = [Role.Infill] }, 2, 4);
        Chosen(new MoveFilter { Kinds = [MoveKind.Travel] }, 0, 3);
        Chosen(new MoveFilter { FirstLayer = 4 }, 1, 2, 3, 4);
        Chosen(new MoveFilter { FirstLayer = 5 }, 3, 4);
        Chosen(new MoveFilter { FirstLayer = 6 });
        Chosen(new MoveFilter { LastLayer = 5 }, 1, 2, 3, 4);
        Chosen(new MoveFilter { LastLayer = 4 }, 1, 2);
        Chosen(new MoveFilter { LastLayer = 3 });
        Chosen(new MoveFilter { Objects = ["b"] }, 3, 4);
        Chosen(new MoveFilter { Tool = 1 }, 4, 5);
        Chosen(new MoveFilter { Box = new Bounds(new Vec3(1, 0, 0), new Vec3(3, 0, 0)) }, 1, 2, 3);
        Chosen(new MoveFilter { Roles = [Role.Infill], Tool = 0 }, 2);
        Chosen(new MoveFilter().InLayersOf(sample), 1, 2, 3, 4);
        Chosen(new MoveFilter { FirstLayer = 5 }.InLayersOf(sample), 3, 4);
        Assert.That(MoveFilter.Prints.InLayersOf(new ToolpathBuilder(MoveSource.Steps, null).Build([])).FirstLayer, Is.Null);
    }

    [Test]
    public void The_box_of_chosen_moves_holds_their_starts_ends_and_arcs()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(5, 0, 1));
        builder.Add(new Vec3(-5, 0, 1), 1, 1, 10, MoveKind.Print, Role.Infill, -1, 0, 0, new Arc(Vec3.Zero, 180));
        builder.Add(new Vec3(-9, -7, 2), 0, 0, 10, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(-8, -7, 2), 1, 1, 10, MoveKind.Print, Role.Support, -1, 0, 0);
        var toolpath = builder.Build([]);
        Assert.That(new MoveFilter { Roles = [Role.Infill] }.BoundsIn(toolpath), Is.EqualTo(new Bounds(new Vec3(-5, 0, 1), new Vec3(5, 5, 1))));
        Assert.That(new MoveFilter { Roles = [Role.Support] }.BoundsIn(toolpath), Is.EqualTo(new Bounds(new Vec3(-9, -7, 2), new Vec3(-8, -7, 2))));
        Assert.That(new MoveFilter { Kinds = [MoveKind.Travel] }.BoundsIn(toolpath), Is.EqualTo(new Bounds(new Vec3(-9, -7, 1), new Vec3(-5, 0, 2))));
        Assert.That(new MoveFilter { Tool = 7 }.BoundsIn(toolpath).IsEmpty, Is.True);
    }

    [Test]
    public void Flow_scales_what_is_deposited_and_leaves_restored_E()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        void Add(double x, double e, double deposited, MoveKind kind) => builder.Add(new Vec3(x, 0), e, deposited, 10, kind, Role.Infill, -1, 0, 0);
        Add(1, 3, 1, MoveKind.Print);
        Add(1, 0.5, 0.5, MoveKind.Prime);
        Add(1, -2, 0, MoveKind.Retract);
        Add(2, 2, 0.5, MoveKind.MovingDeretract);
        var before = builder.Build([new ToolpathTool(1)]);
        Assert.That(before.ScaleFlow(new MoveFilter(), 3).Moves().Select(m => (m.E, m.Deposited)), Is.EqualTo(new[]
        {
            (5, 3), (1.5, 1.5), (-2, 0), (2, 0.5),
        }));
        Assert.That(before.ScaleFlow(new MoveFilter(), 0)[0].E, Is.EqualTo(2));
        foreach (var wrong in new[] { -1, double.NaN, double.PositiveInfinity })
        {
            Assert.That(() => before.ScaleFlow(new MoveFilter(), wrong), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => before.ScaleSpeed(new MoveFilter(), wrong), Throws.InstanceOf<ArgumentOutOfRangeException>());
            Assert.That(() => before.Deform(new MoveFilter(), p => p, wrong), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }
        Assert.That(() => before.ScaleSpeed(new MoveFilter(), 0), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void An_event_comes_before_the_dwell_or_the_homing_of_its_move()
    {
        var before = Decode("G0 X1 F600\nM106 S255\nG4 P500\nG28 X\nM106 S0\nG0 X5\n");
        string[] Kinds(Toolpath t) => t.Events.Select(e => e.Move + " " + e.Event.GetType().Name.Replace("Event", "")).ToArray();
        Assert.That(Kinds(before), Is.EqualTo(new[] { "1 Fan", "1 Dwell", "2 Home", "3 Fan" }));
        var what = new CommentEvent("x");
        Assert.That(Kinds(before.Insert(0, what)), Is.EqualTo(new[] { "0 Comment", "1 Fan", "1 Dwell", "2 Home", "3 Fan" }));
        Assert.That(Kinds(before.Insert(1, what)), Is.EqualTo(new[] { "1 Fan", "1 Comment", "1 Dwell", "2 Home", "3 Fan" }));
        Assert.That(Kinds(before.Insert(2, what)), Is.EqualTo(new[] { "1 Fan", "1 Dwell", "2 Comment", "2 Home", "3 Fan" }));
        Assert.That(Kinds(before.Insert(3, what)), Is.EqualTo(new[] { "1 Fan", "1 Dwell", "2 Home", "3 Fan", "3 Comment" }));
        Assert.That(Kinds(before.Insert(4, what)), Is.EqualTo(new[] { "1 Fan", "1 Dwell", "2 Home", "3 Fan", "4 Comment" }));
        Assert.That(() => before.Insert(5, what), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => before.Insert(-1, what), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void A_tool_keeps_its_own_balance_after_moves_are_given_to_it()
    {
        // Tool 0 retracts, then tool 1 makes the rest: what restored tool 0 primes tool 1.
        var before = Decode("G0 X1 F600\nG1 X5 E1\nG1 E-2 F1200\nG0 X9\nG1 E2 F1200\nG1 X20 E1 F600\n");
        var after = before.Insert(3, new ToolEvent(1));
        Assert.That(after.Moves().Select(m => (m.Tool, m.Kind, m.E, m.Deposited)), Is.EqualTo(new[]
        {
            (0, MoveKind.Travel, 0.0, 0.0), (0, MoveKind.Print, 1, 1), (0, MoveKind.Retract, -2, 0), (1, MoveKind.Travel, 0, 0),
            (1, MoveKind.Prime, 2, 2), (1, MoveKind.Print, 1, 1),
        }));
        Assert.That(after.Tools.Select(t => t.VolumePerE), Is.EqualTo(new[] { before.Tools[0].VolumePerE, before.Tools[0].VolumePerE }));
        // Given back, it restores again.
        var back = after.Insert(4, new ToolEvent(0));
        Assert.That((back[4].Tool, back[4].Kind, back[4].Deposited), Is.EqualTo((0, MoveKind.Deretract, 0.0)));
    }

    [Test]
    public void Moving_restores_become_extrusions_of_a_tool_that_was_not_retracted_and_the_other_way_around()
    {
        var before = Decode("G0 X1 F600\nG1 E-2\nG1 X5 E1.5\nG1 X9 E1\nG1 X12 E1\n");
        Assert.That(before.Moves().Select(m => (m.Kind, m.Deposited)), Is.EqualTo(new[]
        {
            (MoveKind.Travel, 0.0), (MoveKind.Retract, 0), (MoveKind.MovingDeretract, 0), (MoveKind.Print, 0.5), (MoveKind.Print, 1),
        }));
        Assert.That(before.Insert(2, new ToolEvent(1)).Moves().Select(m => (m.Kind, m.Deposited)), Is.EqualTo(new[]
        {
            (MoveKind.Travel, 0.0), (MoveKind.Retract, 0), (MoveKind.Print, 1.5), (MoveKind.Print, 1), (MoveKind.Print, 1),
        }));
        // One move of the other tool: what it restored is restored by the next ones.
        Assert.That(before.Insert(2, new ToolEvent(1)).Insert(3, new ToolEvent(0)).Moves().Select(m => (m.Kind, m.Deposited)), Is.EqualTo(new[]
        {
            (MoveKind.Travel, 0.0), (MoveKind.Retract, 0), (MoveKind.Print, 1.5), (MoveKind.MovingDeretract, 0), (MoveKind.MovingDeretract, 0),
        }));
    }

    [Test]
    public void Balances_change_in_later_blocks_too()
    {
        // Tool 0 retracts in the first block and restores in the second; the retraction is given to tool 1.
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(Vec3.Zero, -2, 0, 30, MoveKind.Retract, Role.Unspecified, -1, 0, 0);
        while (builder.Count < ToolpathBlock.Capacity) builder.Add(Vec3.UnitX, 0, 0, 30, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.AddEvent(new ToolEvent(0));
        builder.Add(Vec3.UnitX, 2, 0, 30, MoveKind.Deretract, Role.Unspecified, -1, 0, 0);
        var before = builder.Build([new ToolpathTool(1)]);
        var after = before.Insert(0, new ToolEvent(1));
        Assert.That((after[0].Tool, after[0].Kind, after[ToolpathBlock.Capacity - 1].Tool), Is.EqualTo((1, MoveKind.Retract, 1)));
        var last = after[ToolpathBlock.Capacity];
        Assert.That((last.Tool, last.Kind, last.Deposited), Is.EqualTo((0, MoveKind.Prime, 2.0)), "nothing was pulled out of it");
        Assert.That(before[ToolpathBlock.Capacity].Kind, Is.EqualTo(MoveKind.Deretract));
    }

    [Test]
    public void Material_that_was_thinned_stays_thin_with_another_tool()
    {
        var before = Decode("G0 X1 F600\nG1 E-2\nG1 X9 E3\n").ScaleFlow(MoveFilter.Prints, 0.5);
        Assert.That((before[2].E, before[2].Deposited), Is.EqualTo((2.5, 0.5)));
        var after = before.Insert(2, new ToolEvent(1));
        // All of it is deposited now, for nothing is restored.
        Assert.That(after[2].Deposited, Is.EqualTo(2.5));
    }

    [Test]
    public void A_tool_event_reaches_to_the_next_one()
    {
        var before = Decode("G0 X1 F600\nG1 X2 E1\nT1\nG1 X3 E1\nT0\nG1 X4 E1\n");
        Assert.That(before.Insert(1, new ToolEvent(3)).Moves().Select(m => m.Tool), Is.EqualTo(new[] { 0, 3, 1, 0 }));
        Assert.That(before.Insert(0, new ToolEvent(3)).Tools, Has.Count.EqualTo(4));
        Assert.That(before.Insert(3, new ToolEvent(0)).Moves().Select(m => m.Tool), Is.EqualTo(new[] { 0, 0, 1, 0 }));
        Assert.That(before.Insert(0, new ToolEvent(-1)).Moves().Select(m => m.Tool), Is.EqualTo(new[] { 0, 0, 1, 0 }), "no tool is chosen");
    }

    [Test]
    public void A_layer_is_found_by_its_number_in_its_object()
    {
        var sample = Sample();
        Assert.That(sample.InsertAtLayer(5, new FanEvent(1)).Value!.Events.Single().Move, Is.EqualTo(3));
        var none = sample.InsertAtLayer(0, new FanEvent(1));
        Assert.That((none.Value, none.Diagnostics.Single().Code, none.Diagnostics.Single().Message),
            Is.EqualTo(((Toolpath?)null, "toolpath.no_layer", "Layer 0 not found.")));
        Assert.That(sample.NumbersOfLayers(), Is.EqualTo(new[] { 4, 5 }));
        Assert.That(sample.Moves().Select(sample.NumberOfLayer), Is.EqualTo(new int?[] { null, 4, 4, 5, 5, null }));
        Assert.That(sample.CountLayers(), Is.EqualTo(2));
    }

    // Moves to x = 0 to 5 by turns in and out of layers 4 and 5.
    private static Toolpath Sample()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(-1, 0));
        builder.AddLayer(new Layer(5, 1, 0.2, "b"));
        builder.AddLayer(new Layer(4, 1, 0.2, "a"));
        void Add(MoveKind kind, Role role, int layer, int tool)
            => builder.Add(new Vec3(builder.Count, 0), 1, kind == MoveKind.Print ? 1 : 0, 10, kind, role, layer, tool, builder.Count);
        Add(MoveKind.Travel, Role.Unspecified, -1, 0);
        Add(MoveKind.Print, Role.OuterWall, 1, 0);
        Add(MoveKind.Print, Role.Infill, 1, 0);
        Add(MoveKind.Travel, Role.Unspecified, 0, 0);
        Add(MoveKind.Print, Role.Infill, 0, 1);
        Add(MoveKind.Print, Role.Purge, -1, 1);
        return builder.Build([new ToolpathTool(1), new ToolpathTool(1)]);
    }

    private static Toolpath Decode(string text)
        => GCodeDecoder.Decode(GCodeDocument.FromText("G90\nM83\n" + text), new DecodeOptions { Flavor = FlavorTable.Marlin2, FilamentDiameter = 1.75 })
            .Value!.Toolpath;
}

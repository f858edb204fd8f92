using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>Cuts in a toolpath are repaired: travels, retraction and events.</summary>
public class MoveRemovalTests
{
    private static readonly MoveFilter Middle = new() { FirstLayer = 1, LastLayer = 1 };

    [Test]
    public void A_cut_is_crossed_at_the_speed_of_the_last_travel()
    {
        var before = Decode(";LAYER:0\nG0 X0 Y0 Z1 F6000\nG1 X10 E1 F1200\n;LAYER:1\nG0 X20 F3000\nG1 X30 E1 F1200\n;LAYER:2\nG1 X40 E1\n");
        var after = before.Remove(Middle).Moves().ToArray();
        Assert.That(after.Select(m => (m.Kind, m.End.X, m.Speed)), Is.EqualTo(new[]
        {
            (MoveKind.Travel, 0.0, 100.0), (MoveKind.Print, 10.0, 20.0), (MoveKind.Travel, 30.0, 50.0), (MoveKind.Print, 40.0, 20.0),
        }));
        Assert.That((after[2].E, after[2].Source, after[2].Layer, after[2].Role), Is.EqualTo((0.0, -1, 2, Role.Unspecified)));
    }

    [Test]
    public void Without_any_travel_before_the_speed_is_that_of_the_extrusion()
    {
        var before = Decode(";LAYER:1\nG1 X10 E1 F1200\n;LAYER:2\nG1 X40 E1\n");
        Assert.That(before.Remove(Middle).Moves().Select(m => (m.Kind, m.End.X, m.Speed)), Is.EqualTo(new[]
        {
            (MoveKind.Travel, 10.0, 20.0), (MoveKind.Print, 40.0, 20.0),
        }));
    }

    [TestCase(2, "(0, 0, 2) (9, 0, 2)")]
    [TestCase(0.5, "(9, 0, 1) (9, 0, 0.5)")]
    [TestCase(1, "(9, 0, 1)")]
    public void A_cut_is_crossed_up_before_across_and_across_before_down(double z, string corners)
    {
        var after = Decode($";LAYER:0\nG0 Z1 F600\nG1 X0.1 E1 F600\nG1 X0 E1\n;LAYER:1\nG0 Z5\nG1 X9 "
            + $"Z{z.ToString(System.Globalization.CultureInfo.InvariantCulture)}"
            + " E1\n;LAYER:2\nG1 X20 E1\n").Remove(Middle);
        var added = after.Moves().Where(m => m.Source < 0).Select(m => Text(m.End));
        Assert.That(string.Join(" ", added), Is.EqualTo(corners));
    }

    [TestCase(9e-10, 0)]
    [TestCase(1.1e-9, 1)]
    public void A_cut_that_ends_where_it_began_needs_no_travel(double gap, int travels)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        void Add(double x, Role role) => builder.Add(new Vec3(x, 0), 1, 1, 10, MoveKind.Print, role, -1, 0, 0);
        Add(10, Role.Infill);
        Add(20, Role.Support);
        Add(10 + gap, Role.Support);
        Add(30, Role.Infill);
        var after = builder.Build([new ToolpathTool(1)]).Remove(new MoveFilter { Roles = [Role.Support] });
        Assert.That(after.Count, Is.EqualTo(2 + travels));
    }

    [Test]
    public void A_retraction_that_is_cut_out_is_made_before_the_travel_and_restored_after_it()
    {
        // Layer 1 ends retracted by 2; its restoring stands in layer 2.
        var before = Decode(";LAYER:0\nG0 Z1 F6000\nG1 X10 E1 F1200\n;LAYER:1\nG1 X20 E1\nG1 E-2 F2100\n;LAYER:2\n"
            + "G0 X50 F6000\nG1 E2 F2100\nG1 X60 E1 F1200\n");
        var after = before.Remove(Middle).Moves().ToArray();
        Assert.That(after.Select(m => (m.Kind, m.End.X, m.E)), Is.EqualTo(new[]
        {
            (MoveKind.Travel, 0.0, 0.0), (MoveKind.Print, 10, 1.0), (MoveKind.Retract, 10, -2.0), (MoveKind.Travel, 50, 0.0), (MoveKind.Deretract, 50, 2.0),
            (MoveKind.Print, 60, 1.0),
        }));
        Assert.That((after[2].Speed, after[2].Source), Is.EqualTo((35.0, -1)), "as fast as the one that was cut out");
    }

    [Test]
    public void A_restoring_that_is_cut_out_is_made_before_the_next_extrusion()
    {
        var before = Decode(";LAYER:0\nG0 Z1 F6000\nG1 X10 E1 F1200\nG1 E-2 F1200\n;LAYER:1\nG0 X20\nG1 E2\nG1 X30 E1\n;LAYER:2\nG0 X50 F6000\nG1 X60 E1 "
            + "F1200\n");
        var after = before.Remove(Middle).Moves().ToArray();
        Assert.That(after.Select(m => (m.Kind, m.End.X, m.E)), Is.EqualTo(new[]
        {
            (MoveKind.Travel, 0.0, 0.0), (MoveKind.Print, 10, 1.0), (MoveKind.Retract, 10, -2.0), (MoveKind.Travel, 50, 0.0), (MoveKind.Deretract, 50, 2.0),
            (MoveKind.Print, 60, 1.0),
        }));
        Assert.That(after[4].Speed, Is.EqualTo(20));
    }

    [Test]
    public void Without_a_speed_of_retraction_it_is_30()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(Vec3.Zero, -2, 0, 0, MoveKind.Retract, Role.Support, -1, 0, 0);
        builder.Add(new Vec3(5, 0), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(5, 0), 2, 0, 0, MoveKind.Deretract, Role.Unspecified, -1, 0, 0);
        var after = builder.Build([new ToolpathTool(1)]).Remove(new MoveFilter { Roles = [Role.Support] });
        Assert.That(after.Moves().Select(m => (m.Kind, m.E, m.Speed)), Is.EqualTo(new[]
        {
            (MoveKind.Retract, -2.0, 30.0), (MoveKind.Travel, 0.0, 100.0), (MoveKind.Deretract, 2.0, 0.0),
        }));
    }

    [Test]
    public void Retraction_by_the_firmware_is_carried_over()
    {
        var before = Decode(";LAYER:0\nG0 Z1 F6000\nG1 X10 E1 F1200\nG10\n;LAYER:1\nG11\nG1 X20 E1\n;LAYER:2\nG1 X30 E1\nG10\n");
        var after = before.Remove(Middle).Moves().Select(m => (m.Kind, m.End.X)).ToArray();
        Assert.That(after, Is.EqualTo(new[]
        {
            (MoveKind.Travel, 0.0), (MoveKind.Print, 10), (MoveKind.Retract, 10), (MoveKind.Travel, 20), (MoveKind.Deretract, 20), (MoveKind.Print, 30),
            (MoveKind.Retract, 30),
        }));
        var pulled = Decode(";LAYER:0\nG0 Z1 F6000\nG1 X10 E1 F1200\n;LAYER:1\nG1 X20 E1\nG10\n;LAYER:2\nG0 X40\nG11\nG1 X50 E1\n").Remove(Middle);
        Assert.That(pulled.Moves().Select(m => (m.Kind, m.End.X)), Is.EqualTo(new[]
        {
            (MoveKind.Travel, 0.0), (MoveKind.Print, 10), (MoveKind.Retract, 10), (MoveKind.Travel, 40), (MoveKind.Deretract, 40), (MoveKind.Print, 50),
        }));
    }

    [Test]
    public void A_dwell_goes_with_its_event_and_other_events_stay()
    {
        const string Text = ";LAYER:0\nG0 Z1 F6000\nG1 X10 E1 F1200\n;LAYER:1\nM106 S255\nG4 P500\nG1 X20 E1\n;LAYER:2\nG4 P700\nG1 X30 E1\n";
        var before = Decode(Text);
        var after = before.Remove(Middle);
        Assert.That(after.Events.Select(e => (e.Move, e.Event.GetType())), Is.EqualTo(new[]
        {
            (2, typeof(FanEvent)), (3, typeof(DwellEvent)),
        }), "after the travel across the cut");
        Assert.That(after.Events.Select(e => e.Event).OfType<DwellEvent>().Single().Seconds, Is.EqualTo(0.7).Within(1e-12));
        Assert.That(after.Moves().Count(m => m.Kind == MoveKind.Dwell), Is.EqualTo(1));
        var dwell = after.Events.Single(e => e.Event is DwellEvent).Move;
        Assert.That(after[dwell].Kind, Is.EqualTo(MoveKind.Dwell), "the event stands at its move");
    }

    [Test]
    public void Homing_stays_and_goes_from_where_the_head_is()
    {
        var before = Decode(";LAYER:0\nG0 X5 Y5 Z1 F6000\nG1 X10 E1 F1200\n;LAYER:1\nG1 X20 Y9 E1\nG28 X\nG1 X7 E1\n;LAYER:2\nG1 X30 E1\n");
        var after = before.Remove(Middle);
        var home = after.Events.Single(e => e.Event is HomeEvent).Move;
        Assert.That((after[home].Start, after[home].End), Is.EqualTo((new Vec3(10, 5, 1), new Vec3(0, 5, 1))));
        Assert.That(after[after.Count - 1].Start, Is.EqualTo(new Vec3(7, 9, 1)));
    }

    [Test]
    public void What_was_retracted_in_blocks_without_cuts_is_known_in_the_next()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        void Add(double x, double e, double speed, MoveKind kind, Role role = Role.Unspecified)
            => builder.Add(new Vec3(x, 0), e, 0, speed, kind, role, -1, 0, 0);
        Add(1, 0, 77, MoveKind.Travel);
        Add(1, -2, 33, MoveKind.Retract);
        while (builder.Count < ToolpathBlock.Capacity) Add(builder.Count % 2, 0, 20, MoveKind.Print, Role.Infill);
        Add(5, 0, 20, MoveKind.Print, Role.Support);
        Add(5, 2, 0, MoveKind.Deretract, Role.Support);
        Add(9, 0, 20, MoveKind.Print, Role.Infill);
        var before = builder.Build([new ToolpathTool(1)]);
        var after = before.Remove(new MoveFilter { Roles = [Role.Support] });
        Assert.That(after.Blocks[0], Is.SameAs(before.Blocks[0]));
        Assert.That(after.Moves().Skip(ToolpathBlock.Capacity).Select(m => (m.Kind, m.End.X, m.E, m.Speed)), Is.EqualTo(new[]
        {
            (MoveKind.Travel, 5.0, 0.0, 77.0), (MoveKind.Deretract, 5, 2, 33), (MoveKind.Print, 9, 0, 20),
        }));
    }

    [Test]
    public void Keeping_is_removing_the_rest()
    {
        var before = Decode(";LAYER:0\nG0 Z1 F6000\nG1 X10 E1 F1200\n;LAYER:1\nG1 X20 E1\n;LAYER:2\nG1 X30 E1\n");
        Assert.That(before.Keep(Middle).Moves().Select(m => (m.Kind, m.Start.X, m.End)), Is.EqualTo(new[]
        {
            (MoveKind.Travel, 0.0, new Vec3(0, 0, 1)), (MoveKind.Travel, 0.0, new Vec3(10, 0, 1)), (MoveKind.Print, 10.0, new Vec3(20, 0, 1)),
        }));
    }

    [Test]
    public void Rotary_words_stay_with_their_moves()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 0; i < 6; i++)
        {
            builder.Add(new Vec3(i + 1, 0), 1, 1, 10, MoveKind.Print, i is 2 or 3 ? Role.Support : Role.Infill, -1, 0, i);
            builder.SetRotary(new Vec3(i, 10 * i, 100 * i));
        }
        var columns = builder.Build([new ToolpathTool(1)]).Remove(new MoveFilter { Roles = [Role.Support] }).Blocks.Single().Columns;
        // The travel across the cut keeps what was set before it.
        Assert.That(columns.Turns!.Take(5), Is.EqualTo(new[] { 0, 1, 1, 4, 5 }.Select(i => new Vec3(i, 10 * i, 100 * i))));
    }

    [Test]
    public void Arcs_events_and_lines_of_scripts_stay_with_extrusions_that_are_copied_together()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 0; i < 8; i++)
        {
            builder.Line = i > 4 ? 10 + i : 0;
            if (i == 6) builder.AddEvent(new FanEvent(0.5));
            builder.Add(new Vec3(i + 1, 0), 1, 1, 10, MoveKind.Print, i == 1 ? Role.Support : Role.Infill, -1, 0, i,
                i == 5 ? new Arc(new Vec3(5.5, 0), 180) : null);
        }
        var kept = builder.Build([new ToolpathTool(1)]).Remove(new MoveFilter { Roles = [Role.Support] });
        // The second move is now the travel across the cut.
        Assert.That(kept.Moves().Select(m => m.Source), Is.EqualTo(new[] { 0, -1, 2, 3, 4, 5, 6, 7 }));
        Assert.That(kept.Moves().Select(m => m.Arc?.Sweep ?? 0), Is.EqualTo(new[] { 0.0, 0, 0, 0, 0, 180, 0, 0 }));
        Assert.That(kept.Blocks.Single().Columns.Line!.Take(8), Is.EqualTo(new[] { 0, 0, 0, 0, 0, 15, 16, 17 }));
        Assert.That(kept.Events.Single().Move, Is.EqualTo(6));
    }

    private static string Text(Vec3 p) => System.FormattableString.Invariant($"({p.X}, {p.Y}, {p.Z})");

    private static Toolpath Decode(string text)
        => GCodeDecoder.Decode(GCodeDocument.FromText("G90\nM83\n" + text), new DecodeOptions { Flavor = FlavorTable.Marlin2, FilamentDiameter = 1.75 })
            .Value!.Toolpath;
}

using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.CanvasPictures;
using Caterpillar.GH.Tests.Plugin;
using Grasshopper.Kernel;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Examples;

/// <summary>Definitions as their readers see them: laid out by Grasshopper's rules, everything visible, explained, in named groups.</summary>
public sealed class CanvasTests
{
    public static IEnumerable<string> Names => Definitions.All.Keys;

    [TestCaseSource(nameof(Names))]
    public void Nothing_overlaps_wires_run_from_left_to_right_and_every_object_is_in_a_named_group(string name)
        => Assert.That(Faults.Of(LayoutOf(name)), Is.Empty);

    [TestCaseSource(nameof(Names))]
    public void No_stage_falls_into_parts_with_much_empty_space_between_them(string name)
    {
        var layout = LayoutOf(name);
        Assert.That(layout.Frames.Select(f => EmptyBand(layout.Objects.Where(o => f.Group.Members.Contains(o.Item.Id)))), Has.All.LessThan(200));
    }

    [Test]
    public void The_empty_space_of_a_stage_is_the_largest_gap_that_no_object_reaches_into()
    {
        double Of(params double[] heights) => EmptyBand(heights.Select(y => Placed.Of(Capsule(0, y, 1, "I"))));
        Assert.That(Of(0), Is.Zero);
        Assert.That(Of(0, 300, 100), Is.EqualTo(200 - 28), "Each is 28 high.");
    }

    [TestCaseSource(nameof(Names))]
    public void It_explains_itself_has_stages_and_shows_results(string name)
    {
        var layout = LayoutOf(name);
        var panels = layout.Objects.Where(o => o.Item.Look == Look.Panel).Select(o => o.Item).ToArray();
        var note = panels.Single(p => p.NickName == "Read me");
        Assert.That(note.Text, Does.Contain(".\n\nTry: ").And.EndsWith("."));
        Assert.That(layout.Frames, Has.Count.GreaterThanOrEqualTo(3));
        Assert.That(panels.Count(p => p.Inputs[0].Sources.Count > 0), Is.GreaterThanOrEqualTo(1));
        Assert.That(layout.Objects.Where(o => o.Item.Look == Look.Slider).Select(o => o.Item.NickName), Has.None.Empty);
    }

    [Test]
    public void Every_component_appears_in_a_definition()
    {
        var shown = Names.SelectMany(n => LayoutOf(n).Objects).Select(o => o.Item.Kind).ToHashSet();
        var missing = PluginTypes.Components.Select(PluginTypes.Make<GH_Component>).Where(c => !shown.Contains(c.ComponentGuid)).Select(c => c.Name);
        Assert.That(missing, Is.Empty);
    }

    [Test]
    public void Six_definitions_and_more_start_from_Rhino_geometry_that_they_hold()
        => Assert.That(Names.Count(n => File.ReadAllText(FileOf(n)).Contains("\"ON_Data\"")), Is.GreaterThanOrEqualTo(6));

    [Test]
    public void Components_have_the_sizes_that_public_definitions_show()
    {
        double Height(int ports) => Placed.Of(Capsule(0, 0, ports, "I")).Box.Height;
        Assert.That(new[] { 1, 2, 3, 4, 5, 18 }.Select(Height), Is.EqualTo(new[] { 28.0, 44, 64, 84, 104, 364 }));
        double Column(string name) => Placed.Of(Capsule(0, 0, 1, name)).Inputs[0].Width;
        Assert.That(new[] { "I", "F", "T", "V", "D", "M", "x", "mesh", "Factor", "docString" }.Select(Column),
            Is.EqualTo(new[] { 10.0, 12, 13, 14, 15, 17, 12, 29, 37, 49 }).Within(4.0));
        var one = Placed.Of(Capsule(100, 50, 1, "I"));
        Assert.That(one.Inputs[0].Right, Is.EqualTo(85), "The column of inputs ends 15 left of the pivot.");
        Assert.That(one.Box.Right - one.Inputs[0].Right, Is.EqualTo(29), "No outputs.");
    }

    [Test]
    public void An_overlap_is_found() => Assert.That(FaultsOf(Capsule(0, 0, 2, "A"), Capsule(20, 20, 2, "B")), Has.Some.EqualTo("A overlaps B."));

    [Test]
    public void Columns_that_come_out_a_tenth_wider_count_as_overlap()
    {
        var first = Placed.Of(Capsule(0, 0, 1, "robot_model"));
        var second = Capsule(Placed.Of(Capsule(0, 0, 1, "robot_model")).Box.Width + 1, 0, 1, "robot_model");
        Assert.That(first.Box.Meets(Placed.Of(second).Box), Is.False);
        Assert.That(FaultsOf(first.Item, second), Has.Some.Contains(" overlaps "));
    }

    [Test]
    public void Wires_that_run_back_and_under_objects_are_found()
    {
        var start = Capsule(0, 0, 1, "From");
        var between = Capsule(200, 0, 1, "Between");
        var to = Capsule(400, 0, 1, "To") with { Inputs = [new Port(Guid.NewGuid(), "I", 0, [start.Id])] };
        start = start with { Outputs = [new Port(start.Id, "O", 0, [])] };
        Assert.That(FaultsOf(start, between, to), Has.Some.EqualTo("The wire from From to To is hidden by Between."));
        Assert.That(FaultsOf(start, between with { Pivot = new Spot(200, 60) }, to), Has.None.Contains("hidden"));
        Assert.That(FaultsOf(start with { Pivot = new Spot(500, 0) }, to), Has.Some.EqualTo("The wire from From to To runs back."));
    }

    [Test]
    public void Wires_across_the_name_of_a_group_are_found()
    {
        var start = Capsule(0, 0, 1, "From");
        var named = Capsule(200, 70, 1, "Named");
        var to = Capsule(400, 0, 1, "To") with { Inputs = [new Port(Guid.NewGuid(), "I", 0, [start.Id])] };
        start = start with { Outputs = [new Port(start.Id, "O", 0, [])] };
        IReadOnlyList<string> Of(double height)
            => Faults.Of(Layout.Of(new Definition([start, named with { Pivot = new Spot(200, height) }, to], [new Group("Here", "#ffffff", [named.Id])])));
        Assert.That(Of(45), Has.Some.EqualTo("The wire from From to To runs across the name of Here."));
        Assert.That(Of(70), Has.None.Contains("across"));
    }

    [Test]
    public void Objects_outside_of_groups_and_groups_that_meet_or_lack_a_name_are_found()
    {
        Item a = Capsule(0, 0, 1, "A"), b = Capsule(60, 0, 1, "B"), c = Capsule(300, 0, 1, "C");
        Group Of(string name, params Item[] items) => new(name, "#ffffff", items.Select(i => i.Id).ToArray());
        var faults = Faults.Of(Layout.Of(new Definition([a, b, c], [Of("One", a), Of("", b)])));
        Assert.That(faults, Has.Some.EqualTo("C is in no group.").And.Some.EqualTo("A group has no name.").And.Some.Contains("overlaps the group"));
    }

    private static double EmptyBand(IEnumerable<Placed> objects)
    {
        var boxes = objects.Select(o => o.Box).OrderBy(b => b.Y).ToArray();
        double band = 0, bottom = boxes[0].Bottom;
        foreach (var box in boxes)
        {
            band = Math.Max(band, box.Y - bottom);
            bottom = Math.Max(bottom, box.Bottom);
        }
        return band;
    }

    private static IReadOnlyList<string> FaultsOf(params Item[] items) => Faults.Of(Layout.Of(new Definition(items, [])));

    private static Layout LayoutOf(string name)
        => Layout.Of(Definition.Read(File.ReadAllText(FileOf(name))));

    private static string FileOf(string name) => Path.Combine(Caterpillar.Tests.TestData.Repository, "examples", "gh", name + ".ghx");

    private static Item Capsule(double x, double y, int ports, string name) => new(Guid.NewGuid(), Guid.Empty, Look.Component, name, name, new Spot(x, y),
        default,
        Enumerable.Range(0, ports).Select(_ => new Port(Guid.NewGuid(), name, 0, [])).ToArray(), []);
}

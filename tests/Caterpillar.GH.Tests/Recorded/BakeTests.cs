using System;
using System.Collections.Generic;
using System.Drawing;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.GH.Goos;
using Caterpillar.GH.Params;
using Caterpillar.GH.Tests.Base;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using Grasshopper.Kernel;
using NUnit.Framework;
using Rhino;
using Rhino.DocObjects;
using Rhino.UI;

namespace Caterpillar.GH.Tests.Recorded;

/// <summary>What is baked, by the component and by Grasshopper itself.</summary>
[FixtureLifeCycle(LifeCycle.InstancePerTestCase)]
public sealed class BakeTests : IDisposable
{
    private readonly InDocument _in = new();

    private RhinoDoc Document => _in.Document;

    private List<RhinoObject> Objects => Document.Objects.Items;

    public void Dispose()
    {
        GH_Document.EscapeKey = () => false;
        _in.Dispose();
    }

    private static ToolpathGoo Planned(int lines)
    {
        var paths = Enumerable.Range(0, lines).Select(i => (Step)new PrintPath([new Vec3(50, 50 + i, 0.2), new Vec3(80, 50 + i, 0.2)],
            Bead.FromWidth(0.6, 0.2, 1, 40, BeadShape.Stadium)) { Role = i % 2 == 0 ? Role.OuterWall : Role.Infill, Layer = new(0, 0.2, 0.2, "Part") });
        return new ToolpathGoo(Planner.Plan(paths.ToArray(), new PrintSetup()).Value!, new PrintSetup());
    }

    // Print moves in every other row, with a travel to each.
    private static ToolpathGoo Lines(int count)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.AddLayer(new(0, 0.2, 0.2, "Part"));
        for (var i = 0; i < count; i++)
        {
            builder.Add(new Vec3(0, i, 0.2), 0, 0, 100, MoveKind.Travel, Role.Unspecified, 0, 0, i);
            builder.Add(new Vec3(10, i, 0.2), 0.3, 0.3, 40, MoveKind.Print, Role.Infill, 0, 0, i);
        }
        return new ToolpathGoo(builder.Build([new ToolpathTool(2.4)]));
    }

    private static Canvas<BakeToolpathComponent> Canvas(GH_Document definition, params object?[] toolpaths)
    {
        var canvas = new Canvas<BakeToolpathComponent>(definition).Feed("Name", "Vase").Feed("Bake", false);
        return canvas.Feed(canvas.Component.Params.Input[0].Name, toolpaths).Solve();
    }

    private static Canvas<BakeToolpathComponent> Press(Canvas<BakeToolpathComponent> canvas)
    {
        canvas.Feed("Bake", false).Solve().Feed("Bake", true).Solve();
        canvas.Document.RunSchedule();
        return canvas;
    }

    private static IEnumerable<Guid> Ids(GH_Component bake)
        => bake.Params.Output[0].VolatileData.AllGoos().Select(g => g!.ScriptVariable() is Guid id ? id : Guid.Empty);

    [Test]
    public void Baking_happens_after_the_solution_once_per_press_and_replaces_what_it_baked()
    {
        var canvas = new Canvas<BakeToolpathComponent>().Feed("Name", "Vase").Feed("Bake", true);
        canvas.Feed(canvas.Component.Params.Input[0].Name, Planned(40)).Solve();
        Assert.That(canvas.Document.ScheduledCount, Is.Zero, "A toggle that is true from the start bakes nothing.");
        canvas.Feed("Bake", false).Solve().Feed("Bake", true).Solve();
        Assert.That(Document.Objects.Count, Is.Zero, "Not while solving.");
        Assert.That(canvas.Document.RunSchedule(), Is.True);
        Assert.That(Document.Objects.Count, Is.EqualTo(40));
        Assert.That(Ids(canvas.Component), Is.EqualTo(Objects.Select(o => o.Id)));
        Assert.That(Document.Objects.Records.Distinct(), Is.EqualTo(new[] { "Bake Vase" }), "One step to undo.");
        Assert.That(Objects.Select(i => i.Attributes.Groups.Single()).Distinct(), Is.EqualTo(new[] { 0 }));
        Assert.That(Objects.Select(i => Document.Layers.FindIndex(i.Attributes.LayerIndex).FullPath).Distinct(),
            Is.EqualTo(new[] { "Caterpillar::Part::OuterWall", "Caterpillar::Part::Infill" }));
        Press(canvas.Feed("Kind", "Beads"));
        Assert.That(Objects.Select(i => i.Geometry.GetType()).Distinct(), Is.EqualTo(new[] { typeof(Rg.Mesh) }), "The curves are replaced.");
        Assert.That(Document.Objects.Count, Is.EqualTo(40));
    }

    [Test]
    public void Two_toolpaths_of_a_list_are_both_there()
    {
        var canvas = Press(Canvas(new GH_Document(), Planned(20), Planned(40)));
        Assert.That(Document.Objects.Count, Is.EqualTo(60));
        Assert.That(Ids(canvas.Component), Is.EquivalentTo(Objects.Select(o => o.Id)));
        Assert.That(Document.UndoRecords, Is.EqualTo(new[] { "Bake Vase" }));
        Press(canvas.Feed(canvas.Component.Params.Input[0].Name, Planned(10)));
        Assert.That(Document.Objects.Count, Is.EqualTo(10), "What has no item any more goes as well.");
    }

    [Test]
    public void Two_components_with_one_name_keep_their_objects()
    {
        var definition = new GH_Document();
        var first = Press(Canvas(definition, Planned(3)));
        var second = Press(Canvas(definition, Planned(5)));
        Assert.That(Document.Objects.Count, Is.EqualTo(8));
        Press(first);
        Press(second);
        Assert.That(Document.Objects.Count, Is.EqualTo(8));
    }

    [Test]
    public void A_copy_of_the_definition_owns_nothing_and_the_reopened_one_owns_what_it_baked()
    {
        var definition = new GH_Document();
        var first = Press(Canvas(definition, Planned(3)));
        Canvas<BakeToolpathComponent> Reopened(Guid id)
        {
            var copy = new GH_Document();
            copy.SetId(id);
            var canvas = new Canvas<BakeToolpathComponent>(copy).Feed("Name", "Vase").Feed("Bake", false);
            canvas.Component.NewInstanceGuid(first.Component.InstanceGuid);
            return canvas.Feed(canvas.Component.Params.Input[0].Name, Planned(4)).Solve();
        }
        var other = Reopened(Guid.NewGuid());
        Assert.That(Ids(other.Component), Is.Empty);
        Press(other);
        Assert.That(Document.Objects.Count, Is.EqualTo(3 + 4));
        var same = Reopened(definition.DocumentID);
        Assert.That(Ids(same.Component).Count(), Is.EqualTo(3), "It knows its objects.");
        Press(same);
        Assert.That(Document.Objects.Count, Is.EqualTo(4 + 4));
    }

    [Test]
    public void Ids_are_those_of_objects_that_exist()
    {
        var canvas = Press(Canvas(new GH_Document(), Planned(3)));
        Assert.That(canvas.Component.Params.Output[0].VolatileData.AllGoos().Select(g => g!.ScriptVariable()), Has.All.InstanceOf<Guid>());
        Document.Objects.Delete(Objects[1].Id, true);
        canvas.Component.ExpireSolution(false);
        canvas.Solve();
        Assert.That(Ids(canvas.Component), Is.EqualTo(Objects.Select(o => o.Id)));
    }

    [Test]
    public void Escape_leaves_everything_as_it_was_and_progress_is_shown()
    {
        var canvas = Press(Canvas(new GH_Document(), Planned(3)));
        var before = Objects.Select(o => o.Id).ToArray();
        StatusBar.Log.Clear();
        canvas.Feed(canvas.Component.Params.Input[0].Name, Lines(2000)).Solve();
        GH_Document.EscapeKey = () => StatusBar.Log.Contains("at 1024");
        Press(canvas);
        Assert.That(StatusBar.Log, Has.Member("show Baking").And.Member("at 256").And.Member("hide"));
        Assert.That(Objects.Select(o => o.Id), Is.EqualTo(before));
        Assert.That(Document.Views.RedrawEnabled, Is.True);
        Assert.That(canvas.Warnings, Has.One.Contains("Canceled: nothing was baked."));
    }

    [Test]
    public void Many_extrusions_are_a_block_and_that_is_said()
    {
        var canvas = Press(Canvas(new GH_Document(), Lines(10_001)));
        Assert.That(Objects.Select(o => o.GetType()), Is.EqualTo(new[] { typeof(InstanceObject) }));
        Assert.That(((InstanceObject)Objects[0]).InstanceDefinition.Parts, Has.Length.EqualTo(10_001));
        Assert.That(Ids(canvas.Component), Is.EqualTo(new[] { Objects[0].Id }));
        Assert.That(canvas.Notes, Has.One.Contains("10001 objects are baked as a block."));
        Press(canvas);
        Assert.That(Objects, Has.Count.EqualTo(1));
        Assert.That(Document.InstanceDefinitions.Items.Count(d => d is not null), Is.EqualTo(1), "The old block is gone.");
    }

    [Test]
    public void A_layer_and_a_color_can_be_chosen()
    {
        Press(Canvas(new GH_Document(), Planned(3)).Feed("Layer", "Prints::Vase").Feed("Color", Color.Teal));
        Assert.That(Objects.Select(o => Document.Layers.FindIndex(o.Attributes.LayerIndex).FullPath).Distinct(), Is.EqualTo(new[] { "Prints::Vase" }));
        Assert.That(Objects.Select(o => (o.Attributes.ObjectColor.ToArgb(), o.Attributes.ColorSource)).Distinct(),
            Is.EqualTo(new[] { (Color.Teal.ToArgb(), ObjectColorSource.ColorFromObject) }));
    }

    [Test]
    public void Without_a_document_nothing_is_baked()
    {
        RhinoDoc.ActiveDoc = null;
        var canvas = Canvas(new GH_Document(), Planned(3)).Feed("Bake", true).Solve();
        Assert.That(canvas.Errors, Has.One.Contains("No Rhino document is open"));
        Assert.That(canvas.Document.ScheduledCount, Is.Zero);
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Grasshopper_bakes_on_the_layer_and_in_the_color_that_were_chosen(bool single)
    {
        var chosen = Document.Layers.Add(new Rhino.DocObjects.Layer { Name = "Chosen" });
        var attributes = new ObjectAttributes
        {
            LayerIndex = chosen, ObjectColor = Color.Teal, ColorSource = ObjectColorSource.ColorFromObject, Name = "Mine",
        };
        if (single)
        {
            Planned(2).BakeGeometry(Document, attributes, out _);
        }
        else
        {
            var param = new ToolpathParam();
            param.AddVolatileData(new Grasshopper.Kernel.Data.GH_Path(0), 0, Planned(2));
            param.BakeGeometry(Document, attributes, []);
        }
        Assert.That(Objects, Has.Count.EqualTo(2));
        Assert.That(Objects.Select(o => (o.Attributes.LayerIndex, o.Attributes.ObjectColor, o.Attributes.Name)).Distinct(),
            Is.EqualTo(new[] { (chosen, Color.Teal, "Mine") }));
        Assert.That(Objects[0].Attributes.GetUserString("caterpillar.role"), Is.EqualTo("OuterWall"), "Facts stay.");
    }

    [Test]
    public void Grasshopper_bakes_nothing_old()
    {
        var definition = new GH_Document();
        var slow = new SlowComponent().OnCanvas();
        var param = new PrintPathParam();
        definition.AddObject(slow, false);
        definition.AddObject(param, false);
        param.AddSource(slow.Params.Output[1]);
        void Feed(string value)
        {
            Recipes.Connect(definition, slow.Params.Input[0], value);
            slow.ExpireSolution(true);
        }
        int Baked()
        {
            var ids = new List<Guid>();
            slow.BakeGeometry(Document, ids);
            param.BakeGeometry(Document, ids);
            return ids.Count;
        }
        Feed("a");
        Assert.That(Baked(), Is.EqualTo(4));
        slow.Close();
        Feed("b");
        Assert.That(Baked(), Is.Zero);
        slow.Open();
    }
}

using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.GH.Base;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Components.Path;
using Caterpillar.GH.Components.Simulate;
using Caterpillar.GH.Components.Slice;
using Caterpillar.GH.Params;
using Caterpillar.GH.Tests.Plugin;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using GH_IO.Serialization;
using Grasshopper.Kernel;
using Grasshopper.Kernel.Data;
using Grasshopper.Kernel.Parameters;
using Grasshopper.Kernel.Types;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Host;

/// <summary>
/// What Grasshopper does is not documented everywhere. Where it is not, the plug-in works whatever it does. What it changes belongs to the whole host.
/// </summary>
[FixtureLifeCycle(LifeCycle.InstancePerTestCase)]
[NonParallelizable]
public sealed class OpenQuestionTests
{
    private static readonly PrintSettings Quick = new() { LayerHeight = 0.5, FirstLayerHeight = 0.5, LineWidth = 0.6, WallCount = 1 };

    private readonly GH_Document _document = new();

    [TearDown]
    public void TearDown()
    {
        SolveLoop.Target = path => path;
        SolveLoop.GraftKeepsEmpty = false;
        SolveLoop.SharesTrees = false;
    }

    [Test]
    public void Layers_lie_below_the_path_that_Grasshopper_names()
    {
        SolveLoop.Target = path => new GH_Path(7).AppendElement(path.Indices[0]);
        var canvas = new Canvas<PlanarSlicerComponent>(_document).Feed("Setup", Quick).FeedTree("Geometry", [Shapes.Box()], [Shapes.Box(height: 1)]).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.Paths("Print Paths"), Is.EqualTo(new[] { "{7;0;0}", "{7;0;1}", "{7;0;2}", "{7;0;3}", "{7;1;0}", "{7;1;1}" }));
        Assert.That(canvas.Paths("Regions"), Is.EqualTo(canvas.Paths("Print Paths")));
        var bad = new Canvas<ConstructPrintPathComponent>(new GH_Document()).Feed("Curve", new Rg.PolylineCurve([Rg.Point3d.Origin, Rg.Point3d.Origin]));
        Assert.That(bad.Solve().Errors.First(), Does.StartWith("{7;0}[0]: "), "Messages name the same places.");
    }

    [TestCase(GH_DataMapping.None, true, "{0} {1} {2} {3}")]
    [TestCase(GH_DataMapping.Graft, true, null)]
    [TestCase(GH_DataMapping.Flatten, false, "{0}")]
    [TestCase(GH_DataMapping.Flatten, true, "{0}")]
    public void Trees_of_layers_may_be_simplified_grafted_flattened_and_reversed(GH_DataMapping mapping, bool simplify, string? paths)
    {
        var slicer = new Canvas<PlanarSlicerComponent>(_document).Feed("Setup", Quick).Feed("Geometry", Shapes.Box());
        var output = slicer.Output("Print Paths");
        (output.DataMapping, output.Simplify, output.Reverse) = (mapping, simplify, true);
        var plan = new Canvas<PlanToolpathComponent>(_document).Feed("Setup", Quick);
        plan.Input("Steps").AddSource(output);
        plan.Solve();
        if (paths is not null) Assert.That(string.Join(" ", slicer.Paths("Print Paths")), Is.EqualTo(paths));
        Assert.That(plan.Errors.Concat(plan.Warnings), Is.Empty);
        Assert.That(plan.All("Toolpath"), Has.One.Not.Null, "One print, however the tree is shaped.");
    }

    [Test]
    public void What_is_kept_is_not_changed_by_what_Grasshopper_does_with_a_tree()
    {
        SolveLoop.SharesTrees = true;
        var slicer = new Canvas<PlanarSlicerComponent>(_document).Feed("Setup", Quick).Feed("Geometry", Shapes.Box());
        slicer.Output("Print Paths").Reverse = true;
        var first = slicer.Solve().All("Print Paths");
        slicer.Component.ExpireSolution(true);
        Assert.That(first, Has.Count.GreaterThan(4));
        Assert.That(slicer.All("Print Paths"), Is.EqualTo(first));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void Empty_branches_give_empty_branches_or_none(bool kept)
    {
        SolveLoop.GraftKeepsEmpty = kept;
        var source = new Param_GenericObject();
        source.PersistentData.Append(Casting.Wrap(new PrintPath([new(0, 0, 0.2), new(10, 0, 0.2)], new Bead(0.1, 0.2, 30))), new GH_Path(0));
        source.PersistentData.EnsurePath(new GH_Path(1));
        _document.AddObject(source, false);
        foreach (var component in new GH_Component[] { new SortPathsComponent(), new DeconstructPrintPathComponent(), new MergePathsComponent() })
        {
            foreach (var mapping in new[] { GH_DataMapping.None, GH_DataMapping.Graft })
            {
                _document.AddObject(component, false);
                component.Params.Input[0].RemoveAllSources();
                component.Params.Input[0].AddSource(source);
                component.Params.Input[0].DataMapping = mapping;
                component.ExpireSolution(true);
                Assert.That(Recipes.Errors(component).Where(e => !e.Contains("gives no valid data")), Is.Empty, component.Name);
                Assert.That(component.Params.Output[0].VolatileData.AllGoos().Count(g => g is not null), Is.GreaterThan(0), component.Name);
            }
        }
    }

    [Test]
    public void A_changed_file_is_read_again_whoever_notices_it()
    {
        var file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".gcode");
        File.WriteAllText(file, "M83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 Y10 E0.5 F1200\n");
        var canvas = new Canvas<DecodeGCodeComponent>(_document).Feed("File", file).Solve();
        Assert.That(canvas.One<Toolpath>("Toolpath").Count, Is.EqualTo(2));
        File.AppendAllText(file, "G1 X30 E0.5\n");
        Assert.That(((Param_FilePath)canvas.Input("File")).ExpireOnFileEvent, Is.True);
        canvas.Component.ExpireSolution(true);
        Assert.That(canvas.One<Toolpath>("Toolpath").Count, Is.EqualTo(3));
        File.Delete(file);
    }

    [Test]
    public void A_file_without_the_names_of_choices_leaves_them_as_they_are()
    {
        var component = new SortPathsComponent();
        var archive = new GH_Archive();
        archive.AppendObject(component, "Container");
        var text = System.Text.RegularExpressions.Regex.Replace(archive.Serialize_Xml(), "<chunk name=\"NamedValue\".*?</chunk>", "",
            System.Text.RegularExpressions.RegexOptions.Singleline);
        var read = new GH_Archive();
        read.Deserialize_Xml(System.Text.RegularExpressions.Regex.Replace(text, "<item name=\"Choice[^>]*>.*?</item>", ""));
        var copy = new SortPathsComponent();
        Assert.That(read.ExtractObject(copy, "Container"), Is.True);
        Assert.That(((ChoiceParam)copy.Params.Input[1]).Choices, Is.EqualTo(((ChoiceParam)component.Params.Input[1]).Choices));
    }

    [Test]
    public void The_end_of_a_solution_need_not_be_heard_of()
    {
        var cache = new SolveCache();
        cache.Begin();
        var first = cache.Get<object>([1], _ => new object());
        cache.Begin();
        Assert.That(cache.Get<object>([1], _ => new object()), Is.SameAs(first));
    }

    [TestCaseSource(typeof(PluginTypes), nameof(PluginTypes.Components))]
    public void Changes_of_the_document_come_in_any_order_and_more_than_once(Type type)
    {
        var component = Recipes.Make(type, _document);
        _document.NewSolution(false);
        var contexts = Enum.GetValues(typeof(GH_DocumentContext)).Cast<GH_DocumentContext>().ToArray();
        foreach (var context in contexts.Concat(contexts.Reverse()).Concat(contexts)) component.DocumentContextChanged(_document, context);
        _document.RemoveObject(component, false);
        foreach (var context in contexts) component.DocumentContextChanged(_document, context);
        Assert.That(_document.RunSchedule() && _document.RunSchedule() && _document.RunSchedule(), Is.False, "What was scheduled comes to an end.");
    }

    [TestCaseSource(typeof(PluginTypes), nameof(PluginTypes.Objects))]
    public void A_file_that_holds_next_to_nothing_of_it_is_read(Type type)
    {
        var empty = new GH_LooseChunk("Container");
        empty.SetString("Name", "Anything");
        var item = PluginTypes.Make<IGH_DocumentObject>(type);
        var ports = (item as IGH_Component)?.Params.Count();
        Assert.That(item.Read(empty), Is.True);
        Assert.That((item as IGH_Component)?.Params.Count(), Is.EqualTo(ports));
    }

    [Test]
    public void Play_goes_on_however_late_its_turn_comes()
    {
        var play = (PlayComponent)Recipes.Make(typeof(PlayComponent), _document);
        var now = 0.0;
        play.Seconds = () => now;
        var run = new Param_Boolean();
        _document.AddObject(run, false);
        play.Params.Input[1].AddSource(run);
        foreach (var value in new[] { false, true })
        {
            run.SetPersistentData(value);
            run.ExpireSolution(true);
        }
        double Position() => ((GH_Number)play.Params.Output[0].VolatileData.AllGoos().Single()!).Value;
        var (start, frames) = (Position(), new List<double>());
        for (; play.Plays && frames.Count < 1000; frames.Add(Position()))
        {
            now += frames.Count % 2 == 0 ? 0.001 : 0.02;
            _document.RunSchedule();
        }
        Assert.That(frames, Is.Ordered);
        Assert.That((start, frames.Last()), Is.EqualTo((0.0, 1.0)));
    }
}

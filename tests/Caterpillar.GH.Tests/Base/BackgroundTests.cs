using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using Caterpillar.GH.Components.GCode;
using Caterpillar.GH.Tests.Host;
using Grasshopper.Kernel;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Base;

/// <summary>Work that outlives a solution. Times count: nothing else runs meanwhile.</summary>
[NonParallelizable]
[FixtureLifeCycle(LifeCycle.InstancePerTestCase)]
public sealed class BackgroundTests
{
    private delegate void Feed(params string[] values);

    private readonly GH_Document _document = new();

    [TearDown]
    public void TearDown() => GH_Document.EscapeKey = () => false;

    [Test]
    public void Long_work_goes_on_after_the_solution_and_its_result_comes_with_a_second_one()
    {
        var slow = Slow(out var feed);
        slow.Gate.Reset();
        var time = Stopwatch.StartNew();
        feed("a");
        Assert.That(time.Elapsed.TotalSeconds, Is.GreaterThan(0.4), "The solution waits for half a second.");
        Assert.That((Results(slow), slow.Message), Is.EqualTo(("null", "Testing 42 %")));
        Assert.That(slow.RuntimeMessageLevel, Is.EqualTo(GH_RuntimeMessageLevel.Blank));
        slow.Open();
        Assert.That(slow.Until(() => slow.Message == "done"), Is.True);
        Assert.That((Results(slow), slow.Begun, _document.SolutionCount), Is.EqualTo(("a", 1, 2)));
    }

    [Test]
    public void Short_work_needs_one_solution()
    {
        var slow = Slow(out var feed);
        feed("a");
        Assert.That((Results(slow), slow.Message, _document.SolutionCount), Is.EqualTo(("a", "done", 1)));
    }

    [Test]
    public void The_last_result_stays_and_says_so()
    {
        var slow = Slow(out var feed);
        feed("a");
        slow.Close();
        feed("b");
        Assert.That((Results(slow), slow.Message), Is.EqualTo(("a", "Testing 42 %, last result")));
        Assert.That(slow.RuntimeMessages(GH_RuntimeMessageLevel.Remark), Has.One.Contains("last result is shown"));
        slow.Open();
        Assert.That(slow.Until(() => slow.Message == "done"), Is.True);
        Assert.That(Results(slow), Is.EqualTo("b"));
        Assert.That(slow.RuntimeMessages(GH_RuntimeMessageLevel.Remark), Is.Empty);
    }

    [Test]
    public void Escape_cancels_work_after_the_solution_and_the_last_result_stays()
    {
        var slow = Slow(out var feed);
        feed("a");
        slow.Close();
        feed("b");
        GH_Document.EscapeKey = () => true;
        Assert.That(slow.Until(() => slow.Message == "canceled, last result" && slow.Canceled == 1), Is.True);
        GH_Document.EscapeKey = () => false;
        Assert.That((Results(slow), slow.Pending), Is.EqualTo(("a", "Slow")), "What comes after knows that this is old.");
        Assert.That(slow.RuntimeMessages(GH_RuntimeMessageLevel.Warning), Has.One.Contains("Canceled"));
        slow.Open();
        slow.ExpireSolution(true);
        Assert.That((Results(slow), slow.Message, slow.Begun, slow.Pending), Is.EqualTo(("b", "done", 3, (string?)null)), "A recompute begins again.");
    }

    [Test]
    public void Escape_in_the_first_half_second_aborts_the_solution()
    {
        var slow = Slow(out var feed);
        slow.Close();
        GH_Document.EscapeKey = () => true;
        feed("a");
        Assert.That(slow.Until(() => slow.Canceled == 1), Is.True);
        Assert.That((_document.AbortRequested, Results(slow)), Is.EqualTo((true, "")));
    }

    [Test]
    public void A_new_input_gives_up_the_work_for_the_old_one_and_waits_less()
    {
        var slow = Slow(out var feed);
        slow.Gate.Reset();
        feed("a");
        Assert.That(slow.Background.Patience, Is.EqualTo(500));
        feed("b");
        Assert.That(slow.Background.Patience, Is.EqualTo(50), "Sliders stay quick.");
        Assert.That(slow.Until(() => slow.Canceled == 1), Is.True);
        slow.Open();
        Assert.That(slow.Until(() => slow.Message == "done"), Is.True);
        Assert.That(Results(slow), Is.EqualTo("b"));
    }

    [Test]
    public void The_same_input_again_does_not_begin_again()
    {
        var slow = Slow(out var feed);
        slow.Close();
        feed("a");
        slow.ExpireSolution(true);
        slow.Open();
        Assert.That(slow.Until(() => slow.Message == "done"), Is.True);
        Assert.That((slow.Begun, slow.Canceled), Is.EqualTo((1, 0)));
    }

    [Test]
    public void The_items_of_a_list_follow_in_one_solution()
    {
        var slow = Slow(out var feed);
        slow.Close();
        feed("a", "b", "c");
        Assert.That(slow.Message, Is.EqualTo("Testing 14 %"));
        slow.Open();
        Assert.That(slow.Until(() => slow.Message == "done"), Is.True);
        Assert.That((Results(slow), slow.Begun, _document.SolutionCount), Is.EqualTo(("a, b, c", 3, 2)));
    }

    [Test]
    public void A_late_error_is_that_of_its_item()
    {
        var slow = Slow(out var feed);
        slow.Close();
        feed("a", "bad");
        slow.Open();
        Assert.That(slow.Until(() => slow.RuntimeMessageLevel == GH_RuntimeMessageLevel.Error), Is.True);
        Assert.That(slow.RuntimeMessages(GH_RuntimeMessageLevel.Error).Single(), Is.EqualTo("{0}[1]: This is bad."));
        Assert.That(Results(slow), Is.EqualTo("a, null"));
    }

    [Test]
    public void What_comes_after_says_that_its_input_is_old()
    {
        var slow = Slow(out var feed);
        feed("a");
        var next = new SlowComponent();
        _document.AddObject(next, false);
        next.Params.Input[0].AddSource(slow.Params.Output[0]);
        _document.NewSolution(false);
        slow.Close();
        feed("b");
        Assert.That(Results(next), Is.EqualTo("a"));
        Assert.That(next.RuntimeMessages(GH_RuntimeMessageLevel.Remark), Has.One.EqualTo("Uses the last result of Slow, which is not up to date."));
        slow.Open();
        Assert.That(slow.Until(() => Results(next) == "b"), Is.True);
        Assert.That(next.RuntimeMessages(GH_RuntimeMessageLevel.Remark), Is.Empty);
    }

    [Test]
    public void What_comes_after_a_first_result_that_is_not_there_yet_is_not_red()
    {
        var slow = Slow(out var feed);
        var relay = new Grasshopper.Kernel.Parameters.Param_GenericObject();
        var next = new Caterpillar.GH.Components.Setup.MaterialComponent();
        _document.AddObject(relay, false);
        _document.AddObject(next, false);
        relay.AddSource(slow.Params.Output[0]);
        next.Params.Input[0].AddSource(relay);
        slow.Close();
        feed("pla");
        Assert.That(next.RuntimeMessageLevel, Is.Not.EqualTo(GH_RuntimeMessageLevel.Error));
        Assert.That(next.Params.Output[0].VolatileData.AllGoos(), Has.All.Null);
        slow.Open();
        Assert.That(slow.Until(() => slow.Message == "done"), Is.True);
        Assert.That(next.Params.Output[0].VolatileData.AllGoos(), Has.One.Not.Null);
    }

    [Test]
    public void Nothing_is_written_from_an_old_result()
    {
        var file = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N") + ".gcode");
        var slow = Slow(out var feed);
        feed("M83\n");
        var save = new Canvas<SaveGCodeComponent>(_document).Feed("File", file).Feed("Save", false);
        save.Input("G-code").AddSource(slow.Params.Output[0]);
        _document.NewSolution(false);
        slow.Close();
        feed("M84\n");
        save.Feed("Save", true).Solve();
        Assert.That(File.Exists(file), Is.False);
        Assert.That(save.Warnings, Has.One.Contains("because Slow is not up to date"));
        slow.Open();
        Assert.That(slow.Until(() => slow.Message == "done"), Is.True);
        Assert.That(File.Exists(file), Is.False, "A press is not made up for.");
        save.Feed("Save", false).Solve();
        save.Feed("Save", true).Solve();
        Assert.That(File.ReadAllText(file), Is.EqualTo("M84\n"));
        File.Delete(file);
    }

    [TestCase("remove")]
    [TestCase("close")]
    [TestCase("lock")]
    public void Nobody_works_for_a_component_that_is_gone(string reason)
    {
        var slow = Slow(out var feed);
        slow.Close();
        feed("a");
        if (reason == "remove") _document.RemoveObject(slow, false);
        else if (reason == "close") slow.DocumentContextChanged(_document, GH_DocumentContext.Close);
        else slow.Locked = true;
        Assert.That(slow.Until(() => slow.Canceled == 1), Is.True);
        Assert.That(_document.ScheduledCount, Is.Zero);
    }

    [Test]
    public void A_result_that_came_while_another_definition_was_shown_is_collected_later()
    {
        var slow = Slow(out var feed);
        slow.Close();
        feed("a");
        slow.Open();
        Assert.That(slow.Background.Queue.Wait(10_000), Is.True);
        slow.DocumentContextChanged(_document, GH_DocumentContext.Unloaded);
        Assert.That(_document.ScheduledCount, Is.Zero);
        slow.DocumentContextChanged(_document, GH_DocumentContext.Loaded);
        Assert.That(_document.RunSchedule(), Is.True);
        Assert.That(Results(slow), Is.EqualTo("a"));
    }

    [Test]
    public void Where_nobody_looks_a_solution_waits_for_the_end()
    {
        var slow = new SlowComponent();
        _document.AddObject(slow, false);
        slow.Close();
        Recipes.Connect(_document, slow.Params.Input[0], "a");
        System.Threading.Tasks.Task.Delay(300).ContinueWith(_ => slow.Open());
        _document.NewSolution(false, GH_SolutionMode.CommandLine);
        Assert.That((Results(slow), slow.Message), Is.EqualTo(("a", "done")));
    }

    private SlowComponent Slow(out Feed feed)
    {
        var slow = new SlowComponent().OnCanvas();
        _document.AddObject(slow, false);
        feed = values =>
        {
            Recipes.Connect(_document, slow.Params.Input[0], values);
            slow.ExpireSolution(true);
        };
        return slow;
    }

    private static string Results(GH_Component component)
        => string.Join(", ", component.Params.Output[0].VolatileData.AllGoos().Select(g => g?.ScriptVariable()?.ToString() ?? "null"));
}

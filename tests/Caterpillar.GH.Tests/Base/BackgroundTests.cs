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
    public void TearDown()
    {
        GH_Document.EscapeKey = () => false;
        GH_Document.EnableSolutions = true;
    }

    [Test]
    public void Long_work_goes_on_after_the_solution_and_its_result_comes_with_a_second_one()
    {
        var slow = Slow(out var feed);
        slow.Gate.Reset();
        slow.Background.UsualPatience = new SlowComponent().Background.UsualPatience;
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
    public void While_a_new_result_is_computed_there_is_none()
    {
        var slow = Slow(out var feed);
        feed("a");
        slow.Close();
        feed("b");
        Assert.That((Results(slow), slow.Message), Is.EqualTo(("null", "Testing 42 %")));
        slow.Open();
        Assert.That(slow.Until(() => slow.Message == "done"), Is.True);
        Assert.That(Results(slow), Is.EqualTo("b"));
    }

    [Test]
    public void A_result_never_appears_at_another_item()
    {
        var slow = Slow(out var feed);
        feed("a", "b", "c");
        slow.Close();
        feed("b2", "c");
        Assert.That(Results(slow), Is.EqualTo("null, c"));
        feed("c", "b2", "a");
        Assert.That(Results(slow), Is.EqualTo("c, null, a"), "What was there belongs to its input, wherever that is now.");
    }

    [Test]
    public void A_result_for_inputs_that_are_no_more_is_not_given_for_those_that_are()
    {
        var slow = Slow(out var feed);
        slow.Close();
        feed("a");
        slow.Open();
        Assert.That(slow.Background.Queue.Wait(10_000), Is.True);
        slow.Close();
        feed("b");
        Assert.That(Results(slow), Is.EqualTo("null"), "The result of a is there, and its solution waits.");
        slow.Open();
        Assert.That(slow.Until(() => Results(slow) == "b"), Is.True);
    }

    [Test]
    public void Old_inputs_get_their_result_back_at_once()
    {
        var slow = Slow(out var feed);
        feed("a");
        slow.Close();
        feed("b");
        feed("a");
        Assert.That((Results(slow), slow.Message, slow.Begun), Is.EqualTo(("a", "done", 2)));
    }

    [Test]
    public void Escape_after_the_solution_is_for_others()
    {
        var slow = Slow(out var feed);
        slow.Close();
        feed("a");
        GH_Document.EscapeKey = () => true;
        slow.Until(() => false, seconds: 0.5);
        GH_Document.EscapeKey = () => false;
        Assert.That((slow.Canceled, slow.Message), Is.EqualTo((0, "Testing 42 %")), "It deselects, for example.");
        slow.Open();
        Assert.That(slow.Until(() => slow.Message == "done"), Is.True);
        Assert.That(Results(slow), Is.EqualTo("a"));
    }

    [Test]
    public void A_canceled_component_is_not_up_to_date_until_it_is_solved_again()
    {
        var slow = Slow(out var feed);
        feed("a", "b");
        slow.Gate.Reset();
        GH_Document.EscapeKey = () => slow.Begun > 2;
        feed("a", "c");
        GH_Document.EscapeKey = () => false;
        Assert.That((Results(slow), slow.Pending, slow.Message), Is.EqualTo(("a", "Slow", "canceled")));
        Assert.That(slow.RuntimeMessages(GH_RuntimeMessageLevel.Warning), Has.One.Contains("Canceled. Recompute to start again."));
        slow.Open();
        slow.ExpireSolution(true);
        Assert.That((Results(slow), slow.Pending), Is.EqualTo(("a, c", (string?)null)));
    }

    [Test]
    public void Escape_in_the_first_half_second_aborts_the_solution()
    {
        var slow = Slow(out var feed);
        slow.Gate.Reset();
        GH_Document.EscapeKey = () => slow.Begun > 0;
        feed("a");
        Assert.That(slow.Until(() => slow.Canceled == 1), Is.True);
        Assert.That((_document.AbortRequested, Results(slow)), Is.EqualTo((true, "")));
    }

    [Test]
    public void A_new_input_gives_up_the_work_for_the_old_one_and_waits_less()
    {
        var slow = Slow(out var feed);
        slow.Gate.Reset();
        slow.Background.UsualPatience = new SlowComponent().Background.UsualPatience;
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
    public void What_comes_after_waits_and_is_solved_once()
    {
        var slow = Slow(out var feed);
        var other = Slow(out var feedOther);
        var next = new SlowComponent().OnCanvas();
        _document.AddObject(next, false);
        next.Params.Input[0].AddSource(slow.Params.Output[0]);
        next.Params.Input[0].AddSource(other.Params.Output[0]);
        feedOther("x");
        slow.Close();
        other.Close();
        feed("a");
        feedOther("b");
        Assert.That((next.Message, next.Begun), Is.EqualTo(("waits for Slow", 1)), "It began for x only.");
        Assert.That(next.Params.Output[0].VolatileData.AllGoos(), Has.All.Null);
        Assert.That(next.RuntimeMessageLevel, Is.EqualTo(GH_RuntimeMessageLevel.Blank));
        slow.Open();
        Assert.That(slow.Until(() => slow.Message == "done"), Is.True);
        Assert.That((next.Message, next.Begun), Is.EqualTo(("waits for Slow", 1)), "One of its inputs is there.");
        other.Open();
        Assert.That(other.Until(() => next.Message == "done"), Is.True);
        Assert.That((Results(next), next.Begun), Is.EqualTo(("a, b", 3)));
    }

    [Test]
    public void A_list_without_what_is_not_ready_is_not_planned()
    {
        var slow = Slow(out var feed);
        var plan = new Canvas<PlanToolpathComponent>(_document);
        plan.Input("Steps").AddSource(slow.Params.Output[1]);
        slow.Close();
        feed("quick", "b");
        Assert.That(slow.Params.Output[1].VolatileDataCount, Is.EqualTo(2), "The paths of the quick one are there.");
        Assert.That(plan.All("Toolpath"), Is.EqualTo(new object?[] { null }), "Half a print is none.");
        Assert.That(plan.Component.Message, Is.EqualTo("waits for Slow"));
        slow.Open();
        Assert.That(slow.Until(() => slow.Message == "done"), Is.True);
        Assert.That(plan.One<Caterpillar.Toolpaths.Toolpath>("Toolpath").Moves().Count(m => m.Kind == Caterpillar.Toolpaths.MoveKind.Print), Is.EqualTo(4));
    }

    [Test]
    public void A_bad_input_is_reported_while_another_one_is_not_ready()
    {
        var slow = Slow(out var feed);
        var simulate = new Canvas<Caterpillar.GH.Components.Simulate.SimulateComponent>(_document).Feed("Position", 5);
        simulate.Input("Toolpath").AddSource(slow.Params.Output[0]);
        slow.Close();
        feed("a");
        Assert.That(simulate.Errors, Has.One.Contains("Position must be from 0 to 1."));
        slow.Open();
    }

    [TestCase("wire")]
    [TestCase("lock")]
    public void A_component_that_cannot_be_solved_any_more_keeps_nobody_waiting(string reason)
    {
        var slow = Slow(out var feed);
        var next = new SlowComponent().OnCanvas();
        _document.AddObject(next, false);
        next.Params.Input[0].AddSource(slow.Params.Output[0]);
        slow.Close();
        feed("a");
        Assert.That((slow.Pending, next.Pending), Is.EqualTo(("Slow", "Slow")));
        if (reason == "wire") slow.Params.Input[0].RemoveAllSources();
        else slow.Locked = true;
        slow.ExpireSolution(true);
        Assert.That((slow.Pending, next.Pending), Is.EqualTo(((string?)null, (string?)null)));
        Assert.That(slow.Until(() => slow.Canceled == 1), Is.True, "And its work ends.");
        Assert.That(_document.ScheduledCount, Is.Zero);
    }

    [Test]
    public void A_result_waits_until_the_solver_is_unlocked()
    {
        var slow = Slow(out var feed);
        slow.Close();
        feed("a");
        GH_Document.EnableSolutions = false;
        slow.Open();
        slow.Until(() => _document.ScheduledCount > 0, seconds: 0.5);
        Assert.That(_document.ScheduledCount, Is.Zero);
        GH_Document.EnableSolutions = true;
        Assert.That(slow.Until(() => Results(slow) == "a"), Is.True);
        Assert.That(slow.Begun, Is.EqualTo(1));
    }

    [Test]
    public void A_copy_begins_its_own_work()
    {
        var slow = Slow(out var feed);
        slow.Close();
        feed("a");
        var archive = new GH_IO.Serialization.GH_Archive();
        archive.AppendObject(slow, "Slow");
        var copy = new SlowComponent().OnCanvas();
        archive.ExtractObject(copy, "Slow");
        Assert.That((copy.Pending, copy.Background.Words), Is.EqualTo(((string?)null, "Working 0 %")));
        slow.Open();
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
        _document.Enabled = false;
        slow.DocumentContextChanged(_document, GH_DocumentContext.Unloaded);
        slow.Open();
        slow.Until(() => _document.ScheduledCount > 0, seconds: 0.5);
        Assert.That(_document.ScheduledCount, Is.Zero);
        _document.Enabled = true;
        slow.DocumentContextChanged(_document, GH_DocumentContext.Loaded);
        Assert.That(slow.Until(() => Results(slow) == "a"), Is.True);
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
            slow.Settle();
        };
        return slow;
    }

    private static string Results(GH_Component component)
        => string.Join(", ", component.Params.Output[0].VolatileData.AllGoos().Select(g => g?.ScriptVariable()?.ToString() ?? "null"));
}

using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.GH.Components.Design;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.GH.Tests.Components;

/// <summary>Every kind of command that a component offers does what the same line of a script does.</summary>
public sealed class TurtleKindsTests
{
    private static readonly Dictionary<TurtleMoveKind, string> Moves = new()
    {
        [TurtleMoveKind.Forward] = "forward 10", [TurtleMoveKind.Backward] = "backward 10", [TurtleMoveKind.WithoutPrinting] = "move 10",
        [TurtleMoveKind.ForwardAndUp] = "forward_lift 10 2", [TurtleMoveKind.Lift] = "lift 10", [TurtleMoveKind.LiftWorld] = "lift_world 10",
        [TurtleMoveKind.Arc] = "arc 10 90 2 6", [TurtleMoveKind.Circle] = "circle 10 6", [TurtleMoveKind.Polygon] = "polygon 6 10",
    };

    private static readonly Dictionary<TurtleEventKind, string> Events = new()
    {
        [TurtleEventKind.Extrude] = "extrude 3", [TurtleEventKind.Dwell] = "dwell 3", [TurtleEventKind.Pause] = "pause \"text\"",
        [TurtleEventKind.NozzleTemperature] = "nozzle_temp 3", [TurtleEventKind.BedTemperature] = "bed_temp 3",
        [TurtleEventKind.Fan] = "fan 0.3", [TurtleEventKind.Tool] = "tool 3", [TurtleEventKind.Comment] = "comment \"text\"",
        [TurtleEventKind.RawLine] = "raw \"text\"", [TurtleEventKind.Layer] = "layer 3", [TurtleEventKind.NextLayer] = "next_layer 3",
        [TurtleEventKind.Color] = "color \"#ff8000\"", [TurtleEventKind.Name] = "name \"text\"",
    };

    public static IEnumerable<TurtleMoveKind> MoveKinds => Moves.Keys;

    public static IEnumerable<TurtleEventKind> EventKinds => Events.Keys;

    [TestCaseSource(nameof(MoveKinds))]
    public void A_move_is_that_of_the_script(TurtleMoveKind kind)
    {
        var command = new Canvas<TurtleMoveComponent>().Feed("Kind", (int)kind);
        Chosen.Follow(command.Component);
        var values = new (string Port, object Value)[]
        {
            ("Distance", 10.0), ("Radius", 10.0), ("Height", 2.0), ("Angle", 90.0), ("Count", 6), ("Side Count", 6), ("Side Length", 10.0),
        };
        foreach (var (port, value) in values.Where(v => command.Component.Params.Input.Exists(p => p.Name == v.Port))) command.Feed(port, value);
        command.Solve();
        Assert.That(command.Errors, Is.Empty);
        Assert.That(Ends(command.All("Command")), Is.EqualTo(Ends(Moves[kind])));
    }

    [TestCaseSource(nameof(EventKinds))]
    public void An_event_is_that_of_the_script(TurtleEventKind kind)
    {
        var command = new Canvas<TurtleEventComponent>().Feed("Kind", (int)kind).Feed("Value", kind == TurtleEventKind.Fan ? 0.3 : 3.0)
            .Feed("Text", kind == TurtleEventKind.Color ? "#ff8000" : "text").Solve();
        Assert.That(command.Errors, Is.Empty);
        Assert.That(Ends(command.All("Command")), Is.EqualTo(Ends(Events[kind])));
    }

    [Test]
    public void Push_and_pop_return_to_where_the_turtle_was()
    {
        object? Event(TurtleEventKind kind) => new Canvas<TurtleEventComponent>().Feed("Kind", (int)kind).Solve().All("Command").Single();
        var forward = TurtleCommand.Of(TurtleAction.Forward, 5);
        Assert.That(Ends([Event(TurtleEventKind.Push), forward, Event(TurtleEventKind.Pop), forward]), Is.EqualTo(Ends("push; forward 5; pop; forward 5")));
    }

    [Test]
    public void Every_kind_is_tested()
    {
        var moves = Enum.GetValues(typeof(TurtleMoveKind)).Cast<TurtleMoveKind>().Except(Moves.Keys);
        var events = Enum.GetValues(typeof(TurtleEventKind)).Cast<TurtleEventKind>().Except(Events.Keys);
        Assert.That(events, Is.EquivalentTo(new[] { TurtleEventKind.Push, TurtleEventKind.Pop }));
        Assert.That(moves, Is.EquivalentTo(new[] { TurtleMoveKind.GoTo, TurtleMoveKind.Jump }), "Those with a point have tests of their own.");
    }

    private static string Ends(IEnumerable<object?> commands) => Ends(TurtleProgram.FromCommands(commands.Cast<TurtleCommand>().ToArray()));

    private static string Ends(string script) => Ends(TurtleProgram.FromScript(TurtleScript.Compile(script).Value!));

    // What the turtle does after it has drawn a line, in words and numbers.
    private static string Ends(TurtleProgram program)
    {
        var line = TurtleProgram.FromCommands([TurtleCommand.Of(TurtleAction.Forward, 1)]);
        var run = TurtleProgram.Sequence([line, program, line]).Run(new TurtleOptions { Start = Frame.World });
        var steps = run.Value!.ToSteps().Select(s => s switch
        {
            PathStep path => $"path {string.Join(" ", path.Path.Points)} {path.Path.Layer} {path.Path.Name} {path.Path.Tool}",
            TravelStep travel => $"travel {string.Join(" ", travel.Points)}",
            EventStep what => what.Event.ToString(),
            _ => s.ToString(),
        });
        return string.Join("\n", steps.Concat(run.Diagnostics.Select(d => d.Message))) + "\n" + run.Value.Pose;
    }
}

using System;
using System.IO;
using System.Linq;
using Caterpillar.Expressions;
using Caterpillar.Toolpaths;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Tests.Turtles;

/// <summary>docs/turtle.md states what the code does.</summary>
internal sealed class TurtleManualTests
{
    private const string Begin = "<!-- commands -->\n";
    private const string End = "<!-- /commands -->";

    private static string Manual => Path.Combine(TestData.Repository, "docs", "turtle.md");

    [Test]
    public void The_table_of_commands_is_that_of_the_code()
    {
        var text = File.ReadAllText(Manual).Replace("\r\n", "\n");
        var from = text.IndexOf(Begin, StringComparison.Ordinal) + Begin.Length;
        var to = text.IndexOf(End, StringComparison.Ordinal);
        var rows = TurtleCommands.All.Select(c => $"| `{c.Usage}` | {string.Join(", ", c.Aliases.Select(a => $"`{a}`"))} | {c.Help} |\n");
        var table = "| command | also | |\n|---|---|---|\n" + string.Concat(rows);
        if (Environment.GetEnvironmentVariable("CATERPILLAR_RENEW") == "1") File.WriteAllText(Manual, text.Substring(0, from) + table + text.Substring(to));
        else Assert.That(text.Substring(from, to - from), Is.EqualTo(table), "CATERPILLAR_RENEW=1 rewrites it.");
    }

    [Test]
    public void All_functions_and_methods_are_named()
    {
        var text = File.ReadAllText(Manual);
        foreach (var function in FormulaFunctions.Names) Assert.That(text, Does.Contain(function));
        var example = text.Substring(text.IndexOf("```\n", StringComparison.Ordinal) + 4);
        example = example.Substring(0, example.IndexOf("```", StringComparison.Ordinal));
        Assert.That(TurtleScript.Compile(example).Value!.Run().Value!.Z, Is.EqualTo(12.2).Within(1e-9));
        var plate = text.Substring(text.IndexOf("```\nstart 110 110 0.3", StringComparison.Ordinal) + 4);
        var cup = TurtleScript.Compile(plate.Substring(0, plate.IndexOf("```", StringComparison.Ordinal))).OrThrow().Run().OrThrow();
        Assert.That(cup.ToSteps().OfType<PathStep>().Max(p => p.Path.Bounds.Max.Z), Is.EqualTo(0.3 + 9).Within(1e-9));
        // Every C# name of the mapping is a member.
        var members = typeof(Turtle).GetMembers().Concat(typeof(TurtleOptions).GetMembers()).Concat(typeof(TurtleHistory).GetMembers()).Select(m => m.Name)
            .ToArray();
        foreach (var name in new[] { "StartAt", "ToSteps", "Forward", "Backward", "ForwardLift", "Lift", "LiftWorld", "Left", "PitchUp", "RollRight",
            "SetHeading", "ChangeHeading", "Face", "GoTo", "PenUp", "PenDown", "SetDensity", "SetBead", "Extrude", "SetRate", "Dwell", "Pause",
            "NozzleTemperature", "BedTemperature", "Mix", "Tool", "Raw", "Comment", "Pose", "Yaw", "AngleUnit", "Push", "Pop", "Color",
            "Layer", "NextLayer", "TriangleOf", "Of", "Circle", "CircleAround", "Polygon", "SetArea", "SetSpeed", "Jump" })
            Assert.That(members, Does.Contain(name));
    }
}

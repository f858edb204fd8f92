using System;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Tests.Turtles;

/// <summary>Programs that take too much are stopped with a sentence and a place, and every loop hears a cancel.</summary>
internal sealed class ScriptLimitTests
{
    private static readonly TurtleLimits Small = new() { Memory = new MemoryLimit(20 << 20) };

    [TestCase("\nrepeat 10000000 [ push ]", "turtle.too_many_states", 2, "1000000 pushed states", Category = "Arithmetic")]
    [TestCase("array a 10000000\nrepeat 40000000 [ array a 10000000 ]", "turtle.too_many_steps", 2, "50000000 steps")]
    [TestCase("repeat 1000000 [ array a 6400000 ]", "turtle.too_many_steps", 1, "50000000 steps")]
    public void Programs_without_end_are_stopped_within_a_second_or_two(string text, string code, int line, string message)
    {
        var limits = text.Contains("array") ? new TurtleLimits { MaxSteps = 200_000 } : new TurtleLimits();
        var error = TurtleScript.Compile(text, "p").Value!.Run(limits: limits).Diagnostics.Single(d => d.Severity == Severity.Error);
        Assert.That((error.Code, error.Source!.Line), Is.EqualTo((code, (int?)line)));
        Assert.That(error.Message, Does.Contain(message.Replace("50000000", "200000")));
    }

    // Commands, the numbers of an array in blocks of 64, the beginning and each turn of a loop, and the end of the program.
    [TestCase("forward 1\nforward 1\nforward 1", 4)]
    [TestCase("array a 640", 12)]
    [TestCase("array a 639", 11)]
    [TestCase("repeat 3 [ forward 1 ]", 8)]
    public void A_program_is_stopped_after_its_last_step(string text, int steps)
    {
        var script = TurtleScript.Compile(text, "p").OrThrow();
        Assert.That(script.Run(limits: new TurtleLimits { MaxSteps = steps }).Diagnostics, Is.Empty);
        var error = script.Run(limits: new TurtleLimits { MaxSteps = steps - 1 }).Diagnostics.Single();
        Assert.That((error.Code, error.Message), Is.EqualTo(("turtle.too_many_steps",
            $"The program was stopped after {steps - 1} steps. Is there an endless loop?")));
    }

    [TestCase("forward 1\nforward 1\nforward 1\n forward 1", 3, "p:4:2: error turtle.too_many_moves: The program was stopped after 3 moves.")]
    [TestCase("lsystem 2 \"F\" \"F -> FF\"", 3, "p:1:1: error turtle.too_many_moves: The program was stopped after 3 moves.")]
    [TestCase("lsystem 2 \"F\" \"F -> FF\"", 4, "")]
    [TestCase("forward 1\nforward 1\nforward 1\n forward 1", 4, "")]
    public void A_move_more_than_allowed_is_told_with_its_place(string text, int moves, string message)
    {
        var run = TurtleScript.Compile(text, "p").OrThrow().Run(limits: new TurtleLimits { MaxMoves = moves });
        Assert.That(string.Join("\n", run.Diagnostics), Is.EqualTo(message));
    }

    [TestCase("def f n [ if n > 1 [ f n - 1 ] ]\nf {0}", 5, 1, 22)]
    [TestCase("def f n [ return n > 1 ? f(n - 1) : 1 ]\nforward f({0})", 5, 1, 26)]
    public void Calls_may_be_as_deep_as_allowed(string text, int depth, int line, int column)
    {
        Diagnostic[] Run(int levels) => [.. TurtleScript.Compile(text.Replace("{0}", levels.ToString()), "p").OrThrow()
            .Run(limits: new TurtleLimits { MaxDepth = depth }).Diagnostics];
        Assert.That(Run(depth), Is.Empty);
        var error = Run(depth + 1).Single();
        Assert.That((error.Code, error.Source!.Line, error.Source.Column), Is.EqualTo(("turtle.recursion", (int?)line, (int?)column)));
        Assert.That(error.Message, Does.Contain($"nested {depth} levels deep"));
    }

    [Test]
    public void Functions_of_formulas_are_a_thousand_levels_deep_at_most()
    {
        Diagnostic[] Run(int levels)
            => [.. TurtleScript.Compile("def f n [ return n > 1 ? f(n - 1) : 1 ]\nforward f(" + levels + ")", "p").OrThrow().Run().Diagnostics];
        Assert.That(Run(1000), Is.Empty);
        Assert.That(Run(1001).Single().Code, Is.EqualTo("turtle.recursion"));
    }

    [TestCase("repeat 1000000 [ push ]")]
    [TestCase("array a 10000000")]
    [TestCase("repeat 100 [ circle 10 100000 ]")]
    [TestCase("def f n [\n array b 3000000\n b[0] = n\n f n + 1\n]\nf 0")]
    [TestCase("helix_trace 10 1000 0.2")]
    [TestCase("cylinder_trace 10 100 0.2 0.2")]
    [TestCase("repeat 100000 [ comment \"a comment that is long enough to take memory, again and again and again\" ]")]
    [TestCase("lsystem 30 \"F(1,2,3)\" \"F(a,b,c) -> F(a,b,c)F(a,b,c)\"")]
    public void Memory_is_counted(string text)
    {
        var run = TurtleScript.Compile(text, "p").Value!.Run(limits: Small);
        Assert.That(run.Value, Is.Null);
        var error = run.Diagnostics.Single(d => d.Severity == Severity.Error);
        Assert.That(error.Code, Is.EqualTo(text.StartsWith("lsystem", StringComparison.Ordinal) ? "lsystem.too_large" : MemoryLimit.Code));
        Assert.That(error.Source!.Line, Is.Not.Null);
        Assert.That(error.Message.Length, Is.LessThan(200));
        Assert.That(TurtleScript.Compile(text.Replace("1000000", "10000").Replace("100000", "10").Replace("30 \"F", "9 \"F"), "p").Value!
            .Run(limits: Small).Diagnostics.Any(d => d.Code == MemoryLimit.Code), Is.EqualTo(text.Contains("_trace") || text.Contains("array b")));
    }

    [TestCase("array a 10000000\nwhile 1 [ array a 10000000 ]")]
    [TestCase("while 1 [ circle 1 1000 ]")]
    [TestCase("def f n [ return n > 900 ? 1 : f(n + 1) ]\nwhile 1 [ x = f(0) ]")]
    [TestCase("lsystem 1000 \"A\" \"A -> AB\"\nwhile 1 [ ]")]
    [TestCase("cylinder_trace 1000 1000 0.001 0.001")]
    [TestCase("deform r = r + sin(z), tolerance = 0.0001 [ repeat 200 [ helix_trace 50 100 1; lift 1 ] ]")]
    [TestCase("modulate flow field = noise(x, y, z), resolution = 0.003 [ helix_trace 50 100 1 ]")]
    public void A_cancel_is_heard_within_a_fifth_of_a_second(string text)
    {
        var limits = new TurtleLimits { MaxSteps = long.MaxValue, MaxMoves = long.MaxValue, Memory = new MemoryLimit(long.MaxValue) };
        using var source = new CancellationTokenSource();
        var script = TurtleScript.Compile(text).OrThrow();
        var watch = new Stopwatch();
        source.CancelAfter(100);
        source.Token.Register(watch.Start);
        Assert.That(() => script.Run(limits: limits, cancel: source.Token), Throws.InstanceOf<OperationCanceledException>());
        TestContext.WriteLine(watch.Elapsed);
        // Generous: other tests run at the same time.
        Assert.That(watch.Elapsed.TotalSeconds, Is.LessThan(2));
    }

    [Test]
    [Category("Arithmetic")]
    public void Whatever_a_program_says_errors_are_short_sentences_with_a_place()
    {
        var random = new Random(5);
        string[] words = ["forward", "repeat", "[", "]", "4", "x", "=", "def", "f", "f(", ")", "+", "-", "\n", ";", ",", "\"F {x}\"", "return", "print",
            "include",
            "image", "deform", "r", "z", "modulate", "speed", "field", "gap_bead", "cool_layers", "helix_trace", "circle_trace", "noise(", "stop", "1e300", "0",
            "array", "a[", "break", "while", "tolerance", "bead", "extrude", "dwell", "hotend", "polygon", "arc", "push", "pop"];
        var limits = new TurtleLimits { MaxSteps = 2000, MaxMoves = 500, MaxDepth = 50, MaxSymbols = 100, Memory = new MemoryLimit(10 << 20) };
        var seen = 0;
        for (var i = 0; i < 6000; i++)
        {
            var text = string.Join(" ", Enumerable.Range(0, random.Next(1, 16)).Select(_ => words[random.Next(words.Length)]));
            var script = TurtleScript.Compile(text, "p");
            var diagnostics = script.Value is null ? script.Diagnostics : script.Value.Run(limits: limits).Diagnostics;
            foreach (var error in diagnostics.Where(d => d.Severity == Severity.Error))
            {
                seen++;
                Assert.That(error.Source?.Line, Is.Not.Null, text + ": " + error);
                Assert.That(error.Message, Has.Length.InRange(5, 300).And.Not.Contains("System.").And.Not.Contains("Parameter").And.Match("[.?…]$"), text);
            }
        }
        Assert.That(seen, Is.GreaterThan(4000));
    }

    [Test]
    public void Nested_formulas_and_blocks_have_stated_limits()
    {
        string Message(string text) => TurtleScript.Compile(text, "p").Diagnostics.Single().ToString();
        Assert.That(Message(string.Concat(Enumerable.Repeat("if 1 [ ", 100_000))), Does.StartWith("p:1:").And.Contains("more than 200 levels deep"));
        Assert.That(Message("forward " + new string('(', 100_000)), Does.StartWith("p:1:").And.Contains("too deeply nested"));
        Assert.That(Message("x = 0\ncomment \"" + string.Concat(Enumerable.Repeat("{if 1}", 100_000)) + "\""), Does.StartWith("p:2:").And.Length.LessThan(400));
    }
}

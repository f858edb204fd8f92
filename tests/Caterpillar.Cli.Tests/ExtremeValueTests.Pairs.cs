using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Turtles;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>All keys of the profiles in all verbs that read them, and all statements of turtle scripts.</summary>
public partial class ExtremeValueTests
{
    private const int Samples = 100;

    private static readonly string[] Generating = ["slice", "turtle", "curves"];

    // As the language writes them.
    private static readonly string[] Numbers =
    [
        "0", "-1", "0.5", "3", "1e-9", "-1e-300", "1e9", "-1e9", "1e300", "-1e300", "1e400", "(0/0)", "(1/0)", "sqrt(-1)", "(1e300*1e300)", "keep", "x", "\"\"",
        "\"{1/0}\"", "\"#12\"", "2147483648", new('9', 300),
    ];

    // Statements that are no commands; # is the value.
    private static readonly string[] Statements =
    [
        "repeat # [ forward 1 ]", "for i = # to 3 [ forward 1 ]", "for i = 0 to # [ forward 1 ]", "for i = 0 to 3 step # [ forward 1 ]",
        "while # [ forward 1; break ]", "if # [ forward 1 ]", "v = #; forward v", "let v = #; forward v", "param v = #; forward v", "array a #; a[0] = 1",
        "array a 3; a[#] = 1", "array a 3; forward a[#]", "array a 3; a[0] = #; forward a[0]", "seed #; forward random()", "print \"text\" #",
        "def part n [ forward n ]; part #", "def twice n [ return 2 * n ]; forward twice(#)", "forward randint(1, #)", "forward noise(#)",
        "deform x = # * x [ circle_trace 5 ]", "deform r = r + #, tolerance = # [ circle_trace 5 ]", "deform c = #, v = # [ circle_trace 5 ]",
        "deform z = z, tolerance = # [ circle_trace 5 ]", "modulate speed field = #, low = 1, high = 2 [ circle_trace 5 ]",
        "modulate flow field = u, low = #, high = 1 [ circle_trace 5 ]", "modulate flow field = u, low = 1, high = # [ circle_trace 5 ]",
        "modulate left field = u, high = # [ circle_trace 5 ]", "modulate up field = u, high = 1, resolution = # [ circle_trace 5 ]",
        "modulate up field = u, high = 1, mask = # [ circle_trace 5 ]", "gap_bead max_gap = # [ circle_trace 5 ]",
        "gap_bead min_gap = #, max_gap = 2 [ circle_trace 5 ]", "gap_bead width = # [ circle_trace 5 ]", "gap_bead bed = # [ circle_trace 5 ]",
        "cool_layers min_layer_time = # [ circle_trace 5 ]", "cool_layers min_layer_time = 5, min_speed = # [ circle_trace 5 ]",
        "cool_layers speed_by_length = # [ circle_trace 5 ]", "cool_layers max_segment_rate = # [ circle_trace 5 ]", "lsystem # \"F\" \"F -> F[+F]F\"",
        "lsystem 2 \"F(#)\" \"F(n) -> F(n * #)\"", "lsystem 2 \"F\" \"# F -> FF\"", "use #", "include #", "image image #", "image image \"#\" smooth",
    ];

    [TestCaseSource(nameof(Generating)), Explicit("all values, some minutes")]
    public void Every_pair_of_a_key_and_a_value(string verb)
        => JudgeAll(Keys().SelectMany(key => Values.Select(value => KeyCase(verb, key, value))));

    [Test, Explicit("all values, some minutes")]
    public void Every_pair_of_a_statement_and_a_value() => JudgeAll(Scripts().Select(ScriptCase));

    [TestCase(1)]
    [TestCase(2)]
    public void Some_keys_and_statements_take_or_refuse_some_values(int seed)
    {
        var random = new Random(seed);
        var (keys, scripts) = (Keys().ToArray(), Scripts().ToArray());
        T Any<T>(T[] all) => all[random.Next(all.Length)];
        JudgeAll(Enumerable.Range(0, Samples)
            .Select(i => i % 2 == 0 ? KeyCase(Any(Generating), Any(keys), Any(Values)) : ScriptCase(Any(scripts))));
    }

    private static (string? Script, string[] Words) KeyCase(string verb, string key, string value) => (null, [.. Verbs[verb], "--set", key + "=" + value]);

    private static (string? Script, string[] Words) ScriptCase(string script) => (script, ["turtle", "extreme.turtle", "-o", "out.gcode"]);

    // Each number of each command alone, then all together; what follows meets the state that the command leaves.
    private static IEnumerable<string> Scripts()
    {
        foreach (var value in Numbers)
        {
            foreach (var statement in Statements) yield return statement.Replace("#", value, StringComparison.Ordinal);
            foreach (var info in TurtleCommands.All)
            {
                for (var at = 0; at < info.Values.Count; at++) yield return Command(info, i => i == at ? value : "1", at + 1);
                yield return Command(info, _ => value, info.Values.Count);
                if (info.Text is not null) yield return $"{info.Name} {value}; forward 1";
            }
        }
    }

    private static string Command(TurtleCommandInfo info, Func<int, string> value, int count)
    {
        var values = Enumerable.Range(0, Math.Max(count, info.Required)).Select(value);
        return string.Join(" ", new[] { info.Name }.Concat(values)) + "; forward 1; circle 2";
    }

    private static void JudgeAll(IEnumerable<(string? Script, string[] Words)> cases)
    {
        var (wrong, count) = (new List<string>(), 0);
        foreach (var (script, words) in cases)
        {
            if (script is not null) File.WriteAllText("extreme.turtle", script);
            var before = wrong.Count;
            Judge(words, wrong);
            if (script is not null && wrong.Count > before) wrong[^1] = $"'{Head(script)}': {wrong[^1]}";
            count++;
        }
        TestContext.Out.WriteLine($"{count} cases, {wrong.Count} failures");
        Assert.That(string.Join("\n", wrong), Is.Empty);
    }
}

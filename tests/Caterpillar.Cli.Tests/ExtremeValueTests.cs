using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Threading;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>
/// Every option of every verb and every key of the profiles with extreme, wrong and empty values: the program answers in a sentence, never with a bug.
/// </summary>
public partial class ExtremeValueTests : CliFixture
{
    private const int LongestMessage = 400;

    private static readonly string[] Values =
    [
        "", " ", "0", "-1", "1", "-5", "0.5", "1e-9", "1e-300", "1e9", "1e300", "-1e300", "nan", "inf", "abc", "1,2", "1,2,3", "1;2", "50%", "-50%", "1e300%",
            "1,2,3,4,5,6,7",
        "9999999999999999999999", "0x10", "true", "x=y", "x*1e300,y,z", "-", "--", "../..", "\u00e9\u4e16", "a\nb", "{", "}", "{if", "[1", new('9', 300),
            new('(', 300),
    ];

    private static readonly Dictionary<string, string[]> Verbs = new()
    {
        ["slice"] = ["slice", "a.stl", "-o", "out.gcode"],
        ["turtle"] = ["turtle", "s.turtle", "-o", "out.gcode"],
        ["curves"] = ["curves", "c.csv", "-o", "out.gcode"],
        ["decode"] = ["decode", "l.gcode"],
        ["convert"] = ["convert", "l.gcode", "-o", "out.gcode"],
        ["sections"] = ["sections", "a.stl", "--heights", "1"],
        ["check"] = ["check", "l.gcode"],
        ["image"] = ["image", "l.gcode", "-o", "out.png", "--width", "64"],
        ["printers"] = ["printers", "ender3"],
        ["simulate"] = ["simulate", "l.gcode"],
    };

    [SetUp]
    public void WriteInputs()
    {
        File.WriteAllText("a.stl", Box(6, 5, 1));
        File.WriteAllText("l.gcode", "G28\nM104 S200\nG90\nM83\n;LAYER_CHANGE\n;Z:0.2\nG1 X10 Y10 Z0.2 F3000\nG1 X20 E1 F1200\nG2 X30 Y10 I5 J0 E1\nG1 E-1\n");
        File.WriteAllText("s.turtle", "param side = 5\nrepeat 4 [ forward side; left 90 ]\n");
        File.WriteAllText("c.csv", "x,y,z\n0,0,0.2\n10,0,0.2\n10,10,0.2\n");
    }

    private static IEnumerable<string> Names() => Caterpillar.Cli.Verbs.All().Select(v => v.Name);

    [TestCaseSource(nameof(Names))]
    public void Every_option_takes_or_refuses_every_value(string name)
    {
        Assume.That(Verbs, Does.ContainKey(name), "the verb needs an input of its own");
        var verb = Caterpillar.Cli.Verbs.All().Single(v => v.Name == name);
        var wrong = new List<string>();
        foreach (var option in verb.Options.Where(o => o.Name.StartsWith("--", StringComparison.Ordinal)))
        {
            if (option.Name is "--set" or "--output") continue;
            foreach (var value in option.ValueType == typeof(bool) ? [""] : Some(Values))
            {
                string[] given = option.ValueType == typeof(bool) ? [option.Name] : [option.Name, value];
                Judge([.. Verbs[name], .. given], wrong);
            }
        }
        Assert.That(string.Join("\n", wrong), Is.Empty);
    }

    private static IEnumerable<string> Keys() => ProfileKeys.All.Select(k => k.Name);

    [TestCaseSource(nameof(Keys))]
    public void Every_key_takes_or_refuses_every_value(string key)
    {
        var wrong = new List<string>();
        foreach (var value in Some(Values)) Judge(["slice", "a.stl", "-o", "out.gcode", "--set", key + "=" + value], wrong);
        Assert.That(string.Join("\n", wrong), Is.Empty);
    }

    [Test, Explicit("all values, some minutes")]
    public void Every_pair_of_an_option_and_a_value()
    {
        var (wrong, count) = (new List<string>(), 0);
        foreach (var verb in Caterpillar.Cli.Verbs.All().Where(v => Verbs.ContainsKey(v.Name)))
        {
            foreach (var option in verb.Options.Where(o => o.Name.StartsWith("--", StringComparison.Ordinal)
                && o.Name is not "--output"))
            {
                foreach (var value in Values)
                {
                    Judge([.. Verbs[verb.Name], option.Name, value], wrong);
                    count++;
                }
            }
        }
        TestContext.Out.WriteLine($"{count} cases");
        Assert.That(string.Join("\n", wrong), Is.Empty);
    }

    // Each test takes every twelfth value, or every fifth in full, from a start that its name decides; the explicit test takes all.
    private static IEnumerable<string> Some(string[] values)
    {
        var step = Environment.GetEnvironmentVariable("CATERPILLAR_FULL") == "1" ? 5 : 12;
        var start = TestContext.CurrentContext.Test.Name.Sum(c => c) % step;
        return values.Where((_, i) => i % step == start);
    }

    private static void Judge(string[] words, List<string> wrong)
    {
        var shown = string.Join(" ", words.Select(w => w.Length > 40 ? w[..40] + "…" : w));
        // Only so that an endless run ends; it is a fault all the same.
        using var stop = new CancellationTokenSource(TimeSpan.FromSeconds(20));
        var run = Run([], words, stop.Token);
        if (run.Code is not (0 or 1 or 2 or 3)) wrong.Add($"{shown}: exit {run.Code}: {Head(run.Messages)}");
        else if (run.Code != 0 && run.Messages.Length == 0 && run.Output.Length == 0) wrong.Add($"{shown}: exit {run.Code} without a word");
        else if (run.Messages.Split('\n')
            .FirstOrDefault(l => l.Length > LongestMessage) is { } line) wrong.Add($"{shown}: {line.Length} characters: {Head(line)}");
        if (run.Code != 0 && File.Exists("out.gcode") && words[0] != "check") wrong.Add($"{shown}: exit {run.Code}, but there is a file");
        File.Delete("out.gcode");
        File.Delete("out.png");
    }

    private static string Head(string text) => text.Length > 300 ? text[..300] : text;
}

using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Turtles;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.Turtles;

/// <summary>
/// In relative mode the G-code of the command lists begins like that of the ExtruderTurtle library. The differences, all of them the library's own (docs/turtle.md lists them): words that
/// do not change are written there, F stands on a line of its own, the pen writes E-3 and E3, temperatures are written twice (set, wait), E is not rounded or to 3 decimals
/// (forward_lift), moves of no length are written, and a position of 0 is taken for "keep".
/// </summary>
internal sealed class FirstLinesTests
{
    private static IEnumerable<string> Programs()
    {
        var file = Path.Combine(TestData.Repository, "..", "shared", "data", "turtle", "truth.json");
        return File.Exists(file)
            ? JObject.Parse(File.ReadAllText(file)).Properties().Where(p => p.Value["library"] is JObject && p.Name != "position_zero").Select(p => p.Name).ToArray()
            : ["seven_star"];
    }

    [TestCaseSource(nameof(Programs))]
    public void Relative_code_begins_like_that_of_the_library(string name)
    {
        var truth = JObject.Parse(File.ReadAllText(TestData.Shared("turtle/truth.json")))[name]!;
        var turtle = CommandList.Replay(TestData.Shared("turtle/" + (string)truth["file"]!));
        var plan = Planner.Plan(turtle.ToSteps(), new PrintSetup(), new PlanOptions { Policy = PlanPolicy.AsDrawn });
        var code = GCodeWriter.ToBytes(plan.Value!, new GCodeFormat { RelativeXyz = true, DecimalsXyz = 5, DecimalsE = 6, DecimalsF = 3, Comments = false });
        var lines = Encoding.ASCII.GetString(code).Split('\n').Select(l => l.TrimEnd()).Where(l => l.Length > 0).ToArray();
        // Behind the move to the start, where the increments begin; what stands before it has no place (temperatures).
        var begin = Array.IndexOf(lines, "G91");
        Assert.That(lines[begin + 1], Is.EqualTo("M83"));
        var ours = lines.Take(begin - 1).Where(l => l[0] == 'M' && l != "M83").Concat(lines.Skip(begin + 2)).Select(Words).ToList();
        var theirs = truth["library"]!["first_lines"]!.SelectMany(l => ((string)l!).Split('\n'))
            .Where(l => l is not ("G1 E-3" or "G1 E3") && !l.StartsWith("G1 F", StringComparison.Ordinal) && !l.StartsWith("M104", StringComparison.Ordinal) && !l.StartsWith("M140", StringComparison.Ordinal))
            .Select(Words).Where(w => w.Count > 1 || w.ContainsKey('M')).ToList();
        Assert.That(theirs, Is.Not.Empty);
        for (var i = 0; i < theirs.Count; i++)
        {
            Assert.That(ours[i].Keys.Where(k => k != 'F'), Is.EquivalentTo(theirs[i].Keys), $"line {i + 1}");
            foreach (var word in theirs[i])
                Assert.That(ours[i][word.Key], Is.EqualTo(word.Value).Within(word.Key == 'E' ? 5.01e-4 : 1.001e-5), $"line {i + 1}, {word.Key}");
        }
    }

    // Words that say nothing new are left out: coordinates of 0, E of 0, and how a travel is named.
    private static SortedDictionary<char, double> Words(string line)
    {
        var words = new SortedDictionary<char, double>();
        foreach (var word in line.Split(' '))
        {
            if (!NumberReader.TryParse(word.Substring(1), out var value)) Assert.Fail(line);
            if (word[0] is 'X' or 'Y' or 'Z' or 'E' && value == 0) continue;
            words[word[0]] = word[0] == 'G' && value == 0 ? 1 : value;
        }
        return words;
    }
}

using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Caterpillar.Tests.Architecture;

/// <summary>Reads the sources themselves.</summary>
public class SourceTests
{
    private const int MaxColumns = 160;

    [Test]
    public void No_line_of_code_is_wider_than_160_columns()
    {
        var wide = Sources()
            .SelectMany(file => File.ReadLines(file).Select((line, i) => (File: file, Number: i + 1, line.Length)))
            .Where(l => l.Length > MaxColumns)
            .Select(l => $"{l.File}:{l.Number}: {l.Length} columns");
        Assert.That(wide, Is.Empty);
    }

    [Test]
    public void Code_has_American_spelling()
    {
        // Names of Grasshopper and of slicers keep their spelling.
        string[] kept = ["GH_Colour", "Param_Colour", "WireColour", "extruder_colour", "filament_colour", "\"colour", "x,y,colour"];
        string[] british = ["co" + "lour", "cen" + "tre", "gr" + "ey", "neigh" + "bour", "behav" + "iour", "normal" + "ise"];
        var found = Sources()
            .SelectMany(file => File.ReadLines(file)
                .Select((line, i) => (Text: kept.Aggregate(line, (text, k) => text.Replace(k, "")), Place: $"{file}:{i + 1}")))
            .Where(l => british.Any(word => l.Text.IndexOf(word, StringComparison.OrdinalIgnoreCase) >= 0))
            .Select(l => l.Place + ": " + l.Text.Trim());
        Assert.That(found, Is.Empty);
    }

    [Test]
    public void Sentences_and_names_are_plain_English_of_the_field()
    {
        // Words in a sense that the field does not have, old names, and words for which there is a plainer one.
        string[] banned =
        [
            @"\b[Bb]ehind\w*", @"\b[Aa]new\b", @"out_of_room", @"\b(its|their) room\b", @"\bstands? where", @"\bfor people\b", @"\blaw of\b", @"\bstuff\b",
            @"\b(var|out|string|double|int|bool) how\b", @"\bblanks\b", @"\bBlank(Before|After)\b", @"increments or (as )?sums",
            @"mistake of the program", @"lie over them", @"\.Perspective\b", @"\.(Need|Long)\(", @"\b\w*Ways?\b",
                @"(?<!\b(this|either|any|other|same|some|a|no|by) )\bways?\b",
            @"\b(Homers|DrivenWord|LayerBook|Tally|Retooler|GapGauge|WholeFile|WholeFormat|FlagFormat|WithoutSpecks|PlanCounts)\b",
        ];
        var words = new Regex(string.Join("|", banned), RegexOptions.CultureInvariant | RegexOptions.Compiled);
        var found = Sources().Concat(Texts())
            .Where(file => !file.EndsWith("SourceTests.cs", StringComparison.Ordinal) && words.IsMatch(File.ReadAllText(file)))
            .SelectMany(file => File.ReadLines(file).Select((line, i) => (Text: line, Place: $"{file}:{i + 1}")))
            .Where(l => words.IsMatch(l.Text))
            .Select(l => $"{l.Place}: \"{words.Match(l.Text).Value}\" in: {l.Text.Trim()}");
        Assert.That(found, Is.Empty);
    }

    // Manual, profiles and example scripts.
    private static IEnumerable<string> Texts()
        => new[] { "README.md", "CONTRIBUTING.md", "CHANGELOG.md" }.Select(name => Path.Combine(TestData.Repository, name))
            .Concat(Directory.EnumerateFiles(Path.Combine(TestData.Repository, "docs"), "*.md"))
            .Concat(Directory.EnumerateFiles(Path.Combine(TestData.Repository, "printers"), "*.json", SearchOption.AllDirectories))
            .Concat(Directory.EnumerateFiles(Path.Combine(TestData.Repository, "examples"), "*.turtle", SearchOption.AllDirectories));

    // The stand-ins of tests/headless keep the spelling of what they stand in for.
    private static IEnumerable<string> Sources()
        => new[] { "src", "tests", "bench", "tools", "examples" }
            .SelectMany(folder => Directory.EnumerateFiles(Path.Combine(TestData.Repository, folder), "*.cs", SearchOption.AllDirectories))
            .Where(file => !file.Contains(Path.DirectorySeparatorChar + "obj" + Path.DirectorySeparatorChar))
            .Where(file => !file.Contains(Path.DirectorySeparatorChar + "headless" + Path.DirectorySeparatorChar));
}

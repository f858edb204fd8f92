using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
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
        // Names of Grasshopper and of slicers keep their own spelling.
        string[] kept = ["GH_Colour", "Param_Colour", "WireColour", "extruder_colour", "filament_colour", "\"colour", "x,y,colour"];
        string[] british = ["co" + "lour", "cen" + "tre", "gr" + "ey", "neigh" + "bour", "behav" + "iour", "normal" + "ise"];
        var found = Sources()
            .SelectMany(file => File.ReadLines(file)
                .Select((line, i) => (Text: kept.Aggregate(line, (text, k) => text.Replace(k, "")), Place: $"{file}:{i + 1}")))
            .Where(l => british.Any(word => l.Text.IndexOf(word, StringComparison.OrdinalIgnoreCase) >= 0))
            .Select(l => l.Place + ": " + l.Text.Trim());
        Assert.That(found, Is.Empty);
    }

    // The stand-ins of tests/headless keep the spelling of what they stand in for.
    private static IEnumerable<string> Sources()
        => new[] { "src", "tests", "bench", "tools", "examples" }
            .SelectMany(folder => Directory.EnumerateFiles(Path.Combine(TestData.Repository, folder), "*.cs", SearchOption.AllDirectories))
            .Where(file => !file.Contains(Path.DirectorySeparatorChar + "obj" + Path.DirectorySeparatorChar))
            .Where(file => !file.Contains(Path.DirectorySeparatorChar + "headless" + Path.DirectorySeparatorChar));
}

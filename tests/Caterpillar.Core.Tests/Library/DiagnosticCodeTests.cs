using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Caterpillar.Tests.Library;

/// <summary>
/// Compares the codes of diagnostics in the sources with <c>DiagnosticCodes.txt</c>: programs and profiles compare codes, so none may disappear unnoticed.
/// <c>CATERPILLAR_RENEW=1</c> writes the file.
/// </summary>
public class DiagnosticCodeTests
{
    // Names of files, and keys of the user text of Rhino objects.
    private static readonly string[] Others = [".css", ".gcode", ".html", ".js", ".json", ".py", ".stl", ".bake", ".role"];

    private static string Listing => Path.Combine(TestData.Repository, "tests", "Caterpillar.Core.Tests", "Library", "DiagnosticCodes.txt");

    [Test]
    public void The_codes_of_diagnostics_are_those_of_the_listing()
    {
        var actual = Sources("src", "*.cs").SelectMany(text => Found(text, "\"")).Distinct().OrderBy(c => c, StringComparer.Ordinal).ToArray();
        if (Environment.GetEnvironmentVariable("CATERPILLAR_RENEW") == "1") File.WriteAllText(Listing, string.Join("\n", actual) + "\n");
        var listed = File.ReadAllLines(Listing);
        Assert.That(listed.Except(actual), Is.Empty, "codes that are gone; programs that compare them no longer work");
        Assert.That(actual.Except(listed), Is.Empty, "new codes; CATERPILLAR_RENEW=1 adds them to DiagnosticCodes.txt");
        Assert.That(listed, Is.EqualTo(actual), "DiagnosticCodes.txt is sorted, one line for each code");
    }

    [Test]
    public void Codes_in_the_manual_exist()
    {
        var listed = File.ReadAllLines(Listing);
        var areas = new HashSet<string>(listed.Select(AreaOf), StringComparer.Ordinal);
        // Codes of SVG elements are made from their names.
        var named = Sources("docs", "*.md").SelectMany(text => Found(text, "`")).Where(c => areas.Contains(AreaOf(c)) && !c.StartsWith("curves.svg_"));
        Assert.That(named.Except(listed), Is.Empty);
    }

    private static IEnumerable<string> Sources(string folder, string pattern)
        => Directory.EnumerateFiles(Path.Combine(TestData.Repository, folder), pattern, SearchOption.AllDirectories)
            .Where(f => !f.Contains(Path.DirectorySeparatorChar + "obj" + Path.DirectorySeparatorChar)).Select(File.ReadAllText);

    private static IEnumerable<string> Found(string text, string quote)
        => Regex.Matches(text, quote + @"([a-z_]+\.[a-z0-9_]+)" + quote, RegexOptions.CultureInvariant).Cast<Match>().Select(m => m.Groups[1].Value)
            .Where(c => !Others.Contains(Path.GetExtension(c)));

    private static string AreaOf(string code) => code.Substring(0, code.IndexOf('.', 0));
}

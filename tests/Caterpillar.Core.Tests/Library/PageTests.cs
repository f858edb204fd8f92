using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Caterpillar.Tests.Library;

/// <summary><c>docs/library.md</c> shows the programs of <c>examples/csharp</c> as they are.</summary>
public class PageTests
{
    private static string Folder => Path.Combine(TestData.Repository, "examples", "csharp");

    [Test]
    public void Every_snippet_is_the_text_of_its_program_and_every_program_is_there()
    {
        var page = Text(Path.Combine(TestData.Repository, "docs", "library.md"));
        var shown = Regex.Matches(page, "```csharp\n(.*?)\n```\n\n\\[(\\w+)\\.cs\\]", RegexOptions.Singleline).Cast<Match>()
            .ToDictionary(m => m.Groups[2].Value, m => m.Groups[1].Value);
        Assert.That(Regex.Matches(page, "```csharp").Count, Is.EqualTo(shown.Count), "each snippet is followed by a link to its program");
        Assert.That(shown.Keys, Is.EquivalentTo(Programs));
        foreach (var program in shown) Assert.That(program.Value, Is.EqualTo(Body(program.Key)), program.Key);
    }

    [TestCaseSource(nameof(Programs))]
    public void A_program_has_three_to_six_statements(string name)
    {
        // The one that shows diagnostics, progress and cancel has more to show.
        var statements = Body(name).Split('\n').Count(l => l.EndsWith(";", StringComparison.Ordinal));
        Assert.That(statements, Is.InRange(2, name == "SliceWithProgress" ? 7 : 6));
    }

    [Test]
    public void Links_of_the_page_lead_to_files()
    {
        var docs = Path.Combine(TestData.Repository, "docs");
        var links = Regex.Matches(Text(Path.Combine(docs, "library.md")), "\\]\\(([^)#]+)\\)").Cast<Match>().Select(m => m.Groups[1].Value).ToArray();
        Assert.That(links, Is.Not.Empty);
        Assert.That(links.Where(l => !File.Exists(Path.Combine(docs, l.Replace('/', Path.DirectorySeparatorChar)))), Is.Empty);
    }

    private static IEnumerable<string> Programs
        => Directory.GetFiles(Folder, "*.cs").Select(f => Path.GetFileNameWithoutExtension(f)!).Where(n => n != "Program")
            .OrderBy(n => n, StringComparer.Ordinal);

    // What is in the braces of Run, from the margin.
    private static string Body(string name)
    {
        var body = Regex.Match(Text(Path.Combine(Folder, name + ".cs")), "    public static [^\n]*\n    \\{\n(.*?)\n    \\}\n\\}", RegexOptions.Singleline);
        return string.Join("\n", body.Groups[1].Value.Split('\n').Select(l => l.StartsWith("        ", StringComparison.Ordinal) ? l.Substring(8) : l));
    }

    private static string Text(string file) => File.ReadAllText(file).Replace("\r\n", "\n");
}

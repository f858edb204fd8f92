using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.RegularExpressions;
using Caterpillar.Tests;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>The command lines of help and manual, as printed.</summary>
public partial class ManualTests : CliFixture
{
    // These open a browser, or go on until Ctrl-C.
    private static readonly string[] Endless = ["--open", "--serve"];

    private readonly Dictionary<string, byte[]> _samples = [];

    private static IEnumerable<string> VerbNames => Verbs.All().Select(v => v.Name);

    private static IEnumerable<string> Pages
        => Directory.EnumerateFiles(Path.Combine(TestData.Repository, "docs"), "*.md").Append(Path.Combine(TestData.Repository, "README.md"))
            .Where(f => CommandLines.InPage(f).Any()).Select(f => Path.GetFileName(f)).OrderBy(n => n, StringComparer.Ordinal);

    // The bracket is sliced once for all tests.
    [OneTimeSetUp]
    public void MakeSamples()
    {
        EnterFolder();
        SampleFolder.Fill(BoxAt, words => Assert.That(Run(words).Code, Is.Zero));
        foreach (var file in Directory.EnumerateFiles(".", "*", SearchOption.AllDirectories)) _samples.Add(file, File.ReadAllBytes(file));
        LeaveFolder();
    }

    [TestCaseSource(nameof(VerbNames))]
    public void The_examples_of_the_help_of_a_verb_work(string name)
    {
        CopySamples();
        var verb = Verbs.Named(name);
        Assert.That(verb.Examples, Is.Not.Empty);
        var help = Run(name, "--help").Text;
        foreach (var (line, does) in verb.Examples)
        {
            Assert.That(line.Split(' ')[0], Is.EqualTo(name));
            Assert.That(help, Does.Contain("# " + does).And.Contain("caterpillar " + line));
            // The model below a surface has its shape.
            if (line.Contains("--surface", StringComparison.Ordinal)) File.Copy("roof.stl", "part.stl", true);
            Works("caterpillar " + line);
        }
    }

    [TestCaseSource(nameof(Pages))]
    public void The_command_lines_of_a_page_work(string page)
    {
        CopySamples();
        var file = Path.Combine(TestData.Repository, page == "README.md" ? "" : "docs", page);
        foreach (var line in CommandLines.InPage(file).Where(l => !Endless.Any(l.Contains) && !Placeholder().IsMatch(l))) Works(line);
    }

    [TestCaseSource(nameof(Programs))]
    public void The_turtle_programs_of_a_page_run(string page, int number)
    {
        var text = File.ReadAllText(Path.Combine(TestData.Repository, "docs", page)).Replace("\r\n", "\n");
        File.WriteAllText("program.turtle", Blocks(text)[number]);
        var run = Run("turtle", "program.turtle", "-o", "program.gcode");
        Assert.That(run.Code, Is.Zero, run.Messages);
    }

    private static IEnumerable<object[]> Programs
        => Directory.EnumerateFiles(Path.Combine(TestData.Repository, "docs"), "*.md").OrderBy(f => f, StringComparer.Ordinal)
            .SelectMany(f => Blocks(File.ReadAllText(f)).Select((_, i) => new object[] { Path.GetFileName(f), i }));

    private static string[] Blocks(string text) => TurtleBlock().Matches(text).Select(m => m.Groups[1].Value).ToArray();

    [Test]
    public void Links_between_pages_lead_to_files()
    {
        var docs = Path.Combine(TestData.Repository, "docs");
        foreach (var file in Directory.EnumerateFiles(docs, "*.md", SearchOption.AllDirectories).Append(Path.Combine(TestData.Repository, "README.md")))
        {
            foreach (Match link in Link().Matches(File.ReadAllText(file)))
            {
                var target = link.Groups[1].Value;
                if (target.Contains("://", StringComparison.Ordinal)) continue;
                var path = Path.Combine(Path.GetDirectoryName(file)!, target);
                Assert.That(File.Exists(path) || Directory.Exists(path), Is.True, $"{Path.GetFileName(file)}: {target}");
            }
        }
    }

    [Test]
    public void The_index_of_the_manual_names_every_page()
    {
        var index = File.ReadAllText(Path.Combine(TestData.Repository, "docs", "README.md"));
        foreach (var page in Directory.EnumerateFiles(Path.Combine(TestData.Repository, "docs"), "*.md").Select(f => Path.GetFileName(f))
            .Where(n => n != "README.md"))
            Assert.That(index, Does.Contain($"({page})"), page);
    }

    [Test]
    public void The_page_of_the_terminal_lists_every_verb()
    {
        var page = File.ReadAllText(Path.Combine(TestData.Repository, "docs", "terminal.md"));
        foreach (var verb in VerbNames) Assert.That(page, Does.Contain($"\n| `{verb}` | "));
    }

    [TestCase("caterpillar a 'b c' \"d, e\"=f # g", "caterpillar|a|b c|d, e=f", null)]
    [TestCase("caterpillar decode x.gcode --csv > moves.csv", "caterpillar|decode|x.gcode|--csv", "moves.csv")]
    public void Lines_are_read_as_shells_do(string line, string words, string? output)
    {
        var split = CommandLines.Split(line);
        Assert.That((string.Join("|", split.Words), split.Output), Is.EqualTo((words, output)));
    }

    private void CopySamples()
    {
        foreach (var (file, bytes) in _samples)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(file)!);
            File.WriteAllBytes(file, bytes);
        }
    }

    private static void Works(string line)
    {
        var (words, output) = CommandLines.Split(line);
        var run = Run([.. words.Skip(1)]);
        Assert.That(run.Code, Is.Zero, line + "\n" + run.Messages);
        if (output is not null) File.WriteAllBytes(output, run.Output);
    }

    // FILE, MODEL..., [options]: lines that show the form of a call; and the tasks of clusters.
    [GeneratedRegex(@"\$SLURM| [\[<]|\b(FILE|MODEL|SCRIPT|HEADER|NAME|VERB)\b")]
    private static partial Regex Placeholder();

    [GeneratedRegex("```turtle\r?\n(.*?)```", RegexOptions.Singleline)]
    private static partial Regex TurtleBlock();

    [GeneratedRegex(@"\]\(([^)#\s]+)(#[^)]*)?\)")]
    private static partial Regex Link();
}

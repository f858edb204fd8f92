using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using Caterpillar.Machines;
using Caterpillar.Tests;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Newtonsoft.Json.Linq;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>The code blocks of the manual that are no command lines and no turtle programs: programs are compiled and run, data is read.</summary>
public class ManualCodeTests : CliFixture
{
    // By page and beginning: why a block cannot run here.
    private static readonly (string Page, string Begins, string Why)[] NotRun =
    [
        ("README.md", "dotnet run ", "needs the SDK; the program that it runs is tested"),
        ("README.md", "./test.sh", "runs these tests"),
        ("first-print.md", "tar xzf ", "needs an archive of a release"),
        ("first-print.md", "$env:PATH", "needs PowerShell"),
        ("first-print.md", "dotnet tool ", "needs the package of a release"),
        ("first-print.md", "dotnet publish ", "needs the SDK; the program that it makes is tested"),
        ("concepts.md", "model, turtle", "a drawing"),
        ("compute.md", "curl ", "needs a server with Rhino.Compute"),
        ("curved.md", "\"rotary_axes\"", "two keys of a profile; five_axis_head has them"),
        ("install.md", "./package.sh", "needs McNeel's packages"),
        ("library.md", "dotnet add ", "the form of a call"),
        ("library.md", "models, turtle", "a drawing"),
        ("models.md", "part.stl: ", "the form of a message"),
        ("profiles.md", "{if ", "the form of a template; TemplateTests has its conditions"),
        ("rhino-only.md", "dotnet test ", "needs Rhino"),
        ("scale.md", "cp ", "needs a cluster; examples/scale/one_machine.sh has the same lines"),
        ("scale.md", "tools/release.sh", "needs a container engine"),
        ("start.md", "dotnet new ", "needs the SDK; the program below it is compiled here"),
        ("tutorial-image.md", "sqrt(64", "the formula of examples/gh/globe_from_image.ghx"),
        ("turtle.md", "# a hexagonal", "TurtleManualTests runs it"),
        ("turtle.md", "start 110 110", "TurtleManualTests runs it"),
        ("viewer.md", "<script ", "ViewTests shows it in a browser"),
        ("viewer.md", "<p id", "ViewTests shows it in a browser"),
    ];

    // What new console projects import, and what the pages that show a few lines take as given.
    private const string Imports = "global using System; global using System.Collections.Generic; global using System.IO; global using System.Linq;";

    private const string Given = "using Caterpillar.Display; using Caterpillar.Machines; using Caterpillar.Planning; using Caterpillar.Simulation; using "
        + "Caterpillar.Turtles;\n"
        + "var setup = new ProfileLibrary().Setup(\"generic\").OrThrow();\n"
        + "var toolpath = Planner.Plan(new Turtle().StartAt(90, 120, 0.2).SetBead(width: 0.6, height: 0.2).Forward(40).ToSteps(), setup).OrThrow();\n";

    private static IEnumerable<CodeBlock> Programs => CodeBlock.OfManual().Where(b => b.Language == "csharp" && b.Page != "library.md");

    private static IEnumerable<CodeBlock> Data => CodeBlock.OfManual().Where(IsData);

    private static bool IsData(CodeBlock block)
        => block.Language is "json" or "csv" || (block.Page, block.Text.Split(',')[0]) == ("curves.md", "curve");

    [Test]
    public void Every_code_block_of_the_manual_is_tested_or_listed_with_the_reason()
    {
        var rest = CodeBlock.OfManual()
            .Where(b => !(b.Language is "turtle" or "csharp" || IsData(b) || b.CallsTheProgram || b.Text.StartsWith("#SBATCH", StringComparison.Ordinal)))
                .ToArray();
        Assert.That(rest.Where(b => !NotRun.Any(n => n.Page == b.Page && b.Text.StartsWith(n.Begins, StringComparison.Ordinal))), Is.Empty);
        Assert.That(NotRun.Where(n => !rest.Any(b => n.Page == b.Page && b.Text.StartsWith(n.Begins, StringComparison.Ordinal))), Is.Empty,
            "is no longer there");
    }

    [TestCaseSource(nameof(Programs))]
    public void A_program_of_the_manual_compiles_and_runs(CodeBlock block)
    {
        var isWhole = block.Text.StartsWith("using ", StringComparison.Ordinal);
        RunProgram(isWhole ? block.Text : Given + block.Text);
        var files = Files();
        if (block.Page != "simulation.md") Assert.That(files, Has.Length.EqualTo(1));
        if (files.Contains("star.gcode")) Assert.That(Run("check", "star.gcode", "--printer", "ender3").Code, Is.Zero);
    }

    [TestCaseSource(nameof(Data))]
    public void Data_of_the_manual_is_read(CodeBlock block)
    {
        if (block.Page == "compute.md")
        {
            Assert.That(JObject.Parse(block.Text)["values"]![0]!["ParamName"]!.ToString(), Does.Match("RH_(IN:script|OUT:gcode)"));
            return;
        }
        if (block.Page == "curves.md")
        {
            var file = block.Language == "json" ? "drawing.json" : "drawing.csv";
            File.WriteAllText(file, block.Text);
            Works("curves", file, "-o", "drawing.gcode");
            return;
        }
        File.WriteAllText("values.csv", block.Text);
        File.WriteAllText("star.turtle", CodeBlock.OfManual().Single(b => b.Page == "start.md" && b.Language == "turtle").Text);
        File.WriteAllText("part.stl", Box(8, 6, 2));
        var isTurtle = block.Text.StartsWith("layers,", StringComparison.Ordinal);
        Works(isTurtle ? "turtle" : "slice", isTurtle ? "star.turtle" : "part.stl", "--table", "values.csv", "-o", "out/{row}.gcode");
        var prints = Directory.GetFiles("out").Select(File.ReadAllText).ToArray();
        Assert.That(prints, Has.Length.EqualTo(block.Text.Trim().Split('\n').Length - 1).And.Unique);
    }

    [Test]
    public void The_task_of_an_array_job_is_that_of_the_examples()
    {
        var block = CodeBlock.OfManual().Single(b => b.Text.StartsWith("#SBATCH", StringComparison.Ordinal));
        var task = File.ReadAllText(Path.Combine(TestData.Repository, "examples", "scale", "study.sbatch"));
        foreach (var line in block.Text.Trim().Split('\n')) Assert.That(task, Does.Contain(line));
    }

    private static void Works(params string[] words)
    {
        var run = Run(words);
        Assert.That((run.Code, run.Messages.Contains("turtle.parameter")), Is.EqualTo((0, false)), run.Messages);
    }

    private static void RunProgram(string text)
    {
        var references = ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator)
            .Append(typeof(ProfileLibrary).Assembly.Location).Distinct().Where(File.Exists).Select(f => MetadataReference.CreateFromFile(f));
        var compilation = CSharpCompilation.Create("Program" + Guid.NewGuid().ToString("N"),
            [CSharpSyntaxTree.ParseText(Imports), CSharpSyntaxTree.ParseText(text)],
            references, new CSharpCompilationOptions(OutputKind.ConsoleApplication));
        using var memory = new MemoryStream();
        var made = compilation.Emit(memory);
        Assert.That(made.Diagnostics.Where(d => d.Severity == DiagnosticSeverity.Error), Is.Empty);
        var begin = Assembly.Load(memory.ToArray()).EntryPoint!;
        begin.Invoke(null, [Array.Empty<string>()]);
    }
}

using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>Many calls in one process.</summary>
public class BatchTests : CliFixture
{
    private const string Star = "param layers = 2\nparam side = 20\nstart 100 100 0.2\ndensity 0.05\nfor n = 0 to layers - 1 [\n  layer n 0.2\n"
        + "  repeat 5 [ forward side; right 144 ]\n  lift 0.2\n]\n";

    [SetUp]
    public void WriteInputs()
    {
        Directory.CreateDirectory("models/small");
        File.WriteAllText("models/a.stl", Box(20, 10, 2));
        File.WriteAllText("models/b.stl", Box(10, 10, 3));
        File.WriteAllText("models/small/c.stl", Box(6, 5, 1));
        File.WriteAllText("models/notes.txt", "no model");
        File.WriteAllText("star.turtle", Star);
    }

    [TestCase("1")]
    [TestCase("3")]
    public void Each_model_becomes_the_file_that_a_single_call_writes(string jobs)
    {
        var run = Run("slice", "--each", "models/*.stl", "models/small/c.stl", "-o", "out/{name}.gcode", "--set", "layer_height_mm=0.25", "--jobs", jobs);
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(Names("out"), Is.EqualTo(new[] { "a.gcode", "b.gcode", "c.gcode" }));
        foreach (var (model, name) in new[] { ("models/a.stl", "a"), ("models/b.stl", "b"), ("models/small/c.stl", "c") })
        {
            Assert.That(Run("slice", model, "-o", "single.gcode", "--set", "layer_height_mm=0.25").Code, Is.Zero);
            Assert.That(File.ReadAllBytes($"out/{name}.gcode"), Is.EqualTo(File.ReadAllBytes("single.gcode")), name);
        }
        var lines = run.Messages.TrimEnd().Split('\n');
        Assert.That(lines.Select(l => l.Split(' ')[0]), Is.EqualTo(new[] { "[1/3]", "[2/3]", "[3/3]", "3" }));
        Assert.That(lines[0], Does.StartWith("[1/3] out/a.gcode: 8 layers, 20 × 10 × 2 mm"));
    }

    [Test]
    public void Without_o_the_files_are_named_after_the_models_in_the_current_folder()
    {
        Assert.That(Run("slice", "--each", "models/**/*.stl").Code, Is.Zero);
        Assert.That(Files().Where(f => f.EndsWith(".gcode", StringComparison.Ordinal)), Is.EqualTo(new[] { "a.gcode", "b.gcode", "c.gcode" }));
        Assert.That(Run("slice", "--each", "models/a.stl", "-o", "results/").Code, Is.Zero);
        Assert.That(Names("results"), Is.EqualTo(new[] { "a.gcode" }));
    }

    [Test]
    public void A_column_that_is_no_option_or_key_is_named()
    {
        File.WriteAllText("values.csv", "name,wall_count,wals\na,1,2\n");
        var run = Run("slice", "models/a.stl", "--table", "values.csv", "-o", "{name}.gcode");
        Assert.That(run.Code, Is.Not.Zero);
        Assert.That(run.Messages, Does.Contain("profile.unknown_key").And.Contain("wals is not a key of printers, materials or settings"));
    }

    [Test]
    public void Each_row_of_a_table_becomes_the_file_that_a_single_call_writes()
    {
        File.WriteAllText("values.csv", "name,layers,side,travel_speed_mm_s,--seed\nlow,1,15,90,\n\"high, wide\",4,30,120,7\ndefault,,,,\n");
        var run = Run("turtle", "star.turtle", "--table", "values.csv", "-o", "{name}.gcode");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(Run("turtle", "star.turtle", "--var", "layers=4", "--var", "side=30", "--set", "travel_speed_mm_s=120", "--seed", "7", "-o", "single.gcode")
            .Code,
            Is.Zero);
        Assert.That(File.ReadAllBytes("high, wide.gcode"), Is.EqualTo(File.ReadAllBytes("single.gcode")));
        Assert.That(Run("turtle", "star.turtle", "-o", "single2.gcode").Code, Is.Zero);
        Assert.That(File.ReadAllBytes("default.gcode"), Is.EqualTo(File.ReadAllBytes("single2.gcode")));
        Assert.That(File.ReadAllBytes("low.gcode"), Has.Length.LessThan(File.ReadAllBytes("default.gcode").Length));
    }

    [Test]
    public void Files_and_rows_are_combined()
    {
        File.WriteAllText("values.csv", "layer_height_mm;--scale\n0.1;1\n0.2;2\n");
        var run = Run("slice", "--each", "models/*.stl", "--table", "values.csv", "-o", "{name}-{layer_height_mm}-{row}.gcode", "--summary", "-");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(Files().Where(f => f.EndsWith(".gcode", StringComparison.Ordinal)),
            Is.EqualTo(new[] { "a-0.1-1.gcode", "a-0.2-2.gcode", "b-0.1-1.gcode", "b-0.2-2.gcode" }));
        var table = CsvTable.Parse(run.Text, "summary");
        // 2 mm high: a first layer of 0.2 mm and 18 of 0.1 mm; twice as high: 20 of 0.2 mm.
        Assert.That(Column(table, "layers"), Is.EqualTo(new[] { "19", "20", "29", "30" }));
        Assert.That(Column(table, "x_mm").Select(x => double.Parse(x, CultureInfo.InvariantCulture)), Is.EqualTo(new[] { 20.0, 40, 10, 20 }).Within(0.1));
        Assert.That(Column(table, "--scale"), Is.EqualTo(new[] { "1", "2", "1", "2" }));
    }

    [Test]
    public void Failures_are_listed_and_the_others_are_done()
    {
        File.WriteAllText("models/aa.stl", "solid nothing\nendsolid nothing\n");
        File.WriteAllText("models/large.stl", Box(500, 10, 1));
        var run = Run("slice", "--each", "models/*.stl", "-o", "out/", "--summary", "s.csv", "--jobs", "2");
        Assert.That(run.Code, Is.EqualTo(1), "the code of the first that failed");
        Assert.That(Names("out"), Is.EqualTo(new[] { "a.gcode", "b.gcode" }));
        Assert.That(run.Messages, Does.Contain("2 of 4 done, 2 failed:").And.Contain("  models/large.stl: exit code 3, "));
        var table = Summary("s.csv");
        Assert.That(Column(table, "status"), Is.EqualTo(new[] { "done", "failed", "done", "failed" }));
        Assert.That(Column(table, "exit_code"), Is.EqualTo(new[] { "0", "1", "0", "3" }));
        Assert.That(Column(table, "error")[1], Is.EqualTo("mesh.empty"));
        Assert.That(Column(table, "message")[1], Does.EndWith("."));
        Assert.That(Column(table, "bytes")[0], Is.EqualTo(new FileInfo("out/a.gcode").Length.ToString(CultureInfo.InvariantCulture)));
    }

    [Test]
    public void Resume_does_only_what_is_not_done_or_has_changed()
    {
        string[] words = ["slice", "--each", "models/*.stl", "models/small/c.stl", "-o", "out/", "--summary", "s.csv", "--resume"];
        Assert.That(Run(words).Code, Is.Zero);
        var first = Summary("s.csv");
        var again = Run(words);
        Assert.That(again.Messages, Does.Contain("[1/3] out/a.gcode: already done, skipped").And.Contain("0 of 3 done, 3 skipped"));
        Assert.That(Column(Summary("s.csv"), "time_s"), Is.EqualTo(Column(first, "time_s")), "figures are kept");

        File.Delete("out/a.gcode");
        File.WriteAllText("models/b.stl", Box(10, 10, 4));
        Assert.That(Run(words).Code, Is.Zero);
        Assert.That(Column(Summary("s.csv"), "status"), Is.EqualTo(new[] { "done", "done", "skipped" }));
        Assert.That(Column(Summary("s.csv"), "layers"), Is.EqualTo(new[] { "10", "20", "5" }));

        Assert.That(Run([.. words, "--set", "layer_height_mm=0.1"]).Code, Is.Zero);
        Assert.That(Column(Summary("s.csv"), "status"), Is.All.EqualTo("done"), "other settings");
    }

    [Test]
    public void The_parts_of_a_list_are_the_list()
    {
        File.WriteAllText("values.csv", "layers\n1\n2\n3\n4\n5\n");
        for (var part = 1; part <= 3; part++)
        {
            var run = Run("turtle", "star.turtle", "--table", "values.csv", "-o", "out/", "--part", $"{part}/3", "--summary", $"{part}.csv");
            Assert.That(run.Code, Is.Zero, run.Messages);
        }
        Assert.That(Names("out"), Is.EqualTo(Enumerable.Range(1, 5).Select(i => $"star_{i}.gcode")));
        Run("turtle", "star.turtle", "--table", "values.csv", "-o", "zero/", "--part", "0/3", "--summary", "0.csv");
        Assert.That(Column(Summary("0.csv"), "job"), Is.EqualTo(Column(Summary("3.csv"), "job")), "indices may begin with 0");
        Assert.That(Column(Summary("2.csv"), "job"), Is.EqualTo(new[] { "2", "5" }));
        Assert.That(Run("turtle", "star.turtle", "--table", "values.csv", "-o", "few/", "--part", "2/9").Code, Is.Zero);
        Assert.That(Run("turtle", "star.turtle", "--table", "values.csv", "-o", "few/", "--part", "9/9").Code, Is.Zero, "a part may be empty");
    }

    [Test]
    public void Interrupted_work_leaves_whole_files_and_a_summary()
    {
        using var stop = new CancellationTokenSource();
        stop.Cancel();
        var run = Run([], ["slice", "--each", "models/*.stl", "-o", "out/", "--summary", "s.csv"], stop.Token);
        Assert.That(run.Code, Is.EqualTo(130));
        Assert.That(run.Messages, Does.Contain("0 of 2 done").And.Contain("repeat the command with --resume"));
        Assert.That(Names("out"), Is.Empty);
        Assert.That(Column(Summary("s.csv"), "status"), Is.All.EqualTo("not started"));
    }

    [Test]
    public void Interrupted_again_the_summary_keeps_what_was_done()
    {
        string[] words = ["slice", "--each", "models/*.stl", "-o", "out/", "--summary", "s.csv", "--resume"];
        Assert.That(Run(words).Code, Is.Zero);
        var first = File.ReadAllText("s.csv");
        using var stop = new CancellationTokenSource();
        stop.Cancel();
        Assert.That(Run([], words, stop.Token).Code, Is.EqualTo(130));
        Assert.That(File.ReadAllText("s.csv"), Is.EqualTo(first));
        File.Delete("out/a.gcode");
        Run([], words, stop.Token);
        Assert.That(Column(Summary("s.csv"), "status"), Is.EqualTo(new[] { "not started", "done" }));
    }

    [Test]
    public void The_first_summary_is_written_before_the_first_file()
    {
        Directory.CreateDirectory("s.csv");
        Assert.That(Run("slice", "--each", "models/*.stl", "-o", "out/", "--summary", "s.csv").Code, Is.Not.Zero);
        Assert.That(Names("out"), Is.Empty);
    }

    [Test]
    public void What_needs_more_than_its_share_of_the_memory_is_done_alone()
    {
        // 48 MB of numbers: more than half of 64 MB.
        File.WriteAllText("large.turtle", "array a 6000000\n" + Star);
        var shared = Run("turtle", "--each", "*.turtle", "--jobs", "2", "--memory-limit", "64MB", "--summary", "s.csv");
        Assert.That(shared.Code, Is.Zero, shared.Messages);
        Assert.That(shared.Messages, Does.Contain("2 of 2 done").And.Not.Contain("memory.limit"));
        Assert.That(File.ReadAllBytes("large.gcode"), Is.EqualTo(File.ReadAllBytes("star.gcode")));
        File.WriteAllText("large.turtle", "array a 9000000\n" + Star);
        var refused = Run("turtle", "--each", "*.turtle", "--jobs", "2", "--memory-limit", "64MB");
        Assert.That(refused.Code, Is.EqualTo(1), "alone it is too large, too");
        Assert.That(refused.Messages, Does.Contain("1 of 2 done, 1 failed").And.Contain("memory.limit").And.Contain("--memory-limit 8GB"));
    }

    [Test]
    public void Checks_of_many_files_print_their_findings_in_order()
    {
        File.WriteAllText("a.gcode", "G28\nM109 S200\nM83\nG1 X300 Y10 Z0.2 F3000\nG1 X280 E1\n");
        File.WriteAllText("b.gcode", "G28\nM109 S200\nM83\nG1 X30 Y10 Z0.2 F3000\nG1 X40 E0.3\n");
        File.WriteAllText("c.gcode", File.ReadAllText("a.gcode"));
        var run = Run("check", "--each", "?.gcode", "--printer", "generic", "--summary", "s.csv");
        Assert.That(run.Code, Is.EqualTo(3));
        Assert.That(run.Text.Split('\n').Where(l => l.Contains("bed.outside", StringComparison.Ordinal)).Select(l => l[..1]).Distinct(),
            Is.EqualTo(new[] { "a", "c" }));
        Assert.That(Column(Summary("s.csv"), "status"), Is.EqualTo(new[] { "failed", "done", "failed" }));
        Assert.That(Column(Summary("s.csv"), "error")[0], Is.EqualTo("bed.outside"));
    }

    [TestCase("two outputs would be named x.gcode", "slice", "--each", "models/*.stl", "-o", "x.gcode")]
    [TestCase("unknown placeholder {nam}. Placeholders: {name}, {input}, {folder}.", "slice", "--each", "models/*.stl", "-o", "{nam}.gcode")]
    [TestCase("Did you mean --printer?", "slice", "--each", "models/*.stl", "--pritner", "x")]
    [TestCase("--set needs a value.", "slice", "--each", "models/*.stl", "--set")]
    [TestCase("models/a.stl cannot be combined with --each", "slice", "models/a.stl", "--each", "models/b.stl")]
    [TestCase("--resume needs --each or --table.", "slice", "models/a.stl", "--resume")]
    [TestCase("--resume needs the summary", "slice", "--each", "models/*.stl", "--resume")]
    [TestCase("Several outputs cannot go to standard output", "slice", "--each", "models/*.stl", "-o", "-")]
    [TestCase("means an image, but the output is G-code", "slice", "--each", "models/*.stl", "-o", "{name}.png")]
    [TestCase("{folder}/{name}.stl would replace the input models/a.stl", "slice", "--each", "models/*.stl", "-o", "{folder}/{name}.stl")]
    [TestCase("--part needs I/N, such as 3/20, not \"3/2\".", "slice", "--each", "models/*.stl", "--part", "3/2")]
    [TestCase("--jobs needs a number from 1", "slice", "--each", "models/*.stl", "--jobs", "0")]
    [TestCase("turtle has no option --sede", "turtle", "star.turtle", "--table", "bad.csv")]
    public void Wrong_usage_is_found_before_any_work(string message, params string[] words)
    {
        File.WriteAllText("bad.csv", "--sede\n1\n");
        var before = Files();
        var run = Run(words);
        Assert.That(run.Code, Is.EqualTo(2), run.Messages);
        Assert.That(run.Messages, Does.Contain(message));
        Assert.That(Files(), Is.EqualTo(before));
    }

    [Test]
    [Platform("Linux")]
    public void Patterns_tell_capitals_from_small_letters_where_the_system_does()
        => Assert.That(Run("slice", "--each", "models/*.STL").Messages, Does.Contain("No file matches models/*.STL."));

    [TestCase("No file matches models/*.obj.", "slice", "--each", "models/*.obj")]
    [TestCase("models/none.stl: file not found.", "slice", "--each", "models/none.stl")]
    [TestCase("models is a folder. Give the files in it, such as 'models/*'.", "slice", "--each", "models")]
    [TestCase("long.csv:3: 2 cells for 1 column.", "turtle", "star.turtle", "--table", "long.csv")]
    [TestCase("open.csv:2: a quote is not closed.", "turtle", "star.turtle", "--table", "open.csv")]
    [TestCase("empty.csv: the table is empty", "turtle", "star.turtle", "--table", "empty.csv")]
    [TestCase("the table has no rows", "turtle", "star.turtle", "--table", "names.csv")]
    public void Missing_files_and_bad_tables_are_bad_input(string message, params string[] words)
    {
        File.WriteAllText("long.csv", "layers\n1\n2,3\n");
        File.WriteAllText("open.csv", "layers\n\"1\n2\n");
        File.WriteAllText("empty.csv", "# nothing\n\n");
        File.WriteAllText("names.csv", "layers\n");
        var run = Run(words);
        Assert.That((run.Code, run.Messages), Is.EqualTo((1, run.Messages)), run.Messages);
        Assert.That(run.Messages, Does.Contain(message));
    }

    [Test]
    public void Replacing_inputs_cannot_be_resumed()
    {
        File.WriteAllText("b.gcode", "G28\nM83\nG1 X30 Y10 Z0.2 F3000\nG1 X40 E0.3\n");
        Assert.That(Run("convert", "--each", "b.gcode", "--in-place", "--speed", "50%").Code, Is.Zero);
        Assert.That(File.ReadAllText("b.gcode"), Does.Contain("F1500"));
        var run = Run("convert", "--each", "b.gcode", "--in-place", "--speed", "50%", "--summary", "s.csv", "--resume");
        Assert.That((run.Code, run.Messages), Is.EqualTo((2, run.Messages)));
        Assert.That(run.Messages, Does.Contain("--resume cannot be combined with --in-place"));
    }

    [Test]
    public void Tables_are_read_as_spreadsheets_write_them()
    {
        var table = CsvTable.Parse("\uFEFFa;\"b \"\"x\"\"\";c\r\n# left out\r\n 1 ;\"two; or\r\nmore\";\r\n\r\n3\r\n", "t.csv");
        Assert.That(table.Columns, Is.EqualTo(new[] { "a", "b \"x\"", "c" }));
        Assert.That(table.Rows, Is.EqualTo(new[] { new[] { "1", "two; or\r\nmore", "" }, new[] { "3", "", "" } }));
        Assert.That(CsvTable.Parse(CsvTable.Line(["x", "y"]) + "\n" + CsvTable.Line(["a,\"b\"", " c\nd"]) + "\n", "t").Rows[0],
            Is.EqualTo(new[] { "a,\"b\"", " c\nd" }));
    }

    private static string[] Names(string folder)
        => Directory.GetFileSystemEntries(folder).Select(f => Path.GetFileName(f)).OrderBy(n => n, StringComparer.Ordinal).ToArray();

    private static CsvTable Summary(string file) => CsvTable.Parse(File.ReadAllText(file), file);

    private static IReadOnlyList<string> Column(CsvTable table, string name)
        => table.Rows.Select(r => r[table.Columns.ToList().IndexOf(name)]).ToArray();
}

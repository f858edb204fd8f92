using System;
using System.IO;
using System.Linq;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Tests.Library;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Jobs;

/// <summary>A file is read, edited, converted, checked and written, each once.</summary>
public class FileJobTests
{
    private const string Text = "G28\nM109 S200\nM83\n;LAYER:0\nG1 X50 Y50 Z0.2 F3000\nG1 X70 E0.7\nG1 Y70 E0.7\n;LAYER:1\nG1 Z0.4\nG1 X50 E0.7\nG1 Y50 E0.7\n";

    private static FileJob Job => new(GCodeDecoder.Decode(GCodeDocument.FromText(Text)).OrThrow());

    [Test]
    public void Without_changes_the_bytes_stay()
    {
        using var stream = new MemoryStream();
        var written = Job.Write(stream, "a.gcode", null).OrThrow();
        Assert.That(System.Text.Encoding.ASCII.GetString(stream.ToArray()), Is.EqualTo(Text));
        Assert.That((written.Lines, written.Bytes), Is.EqualTo((11L, (long)Text.Length)));
    }

    [Test]
    public void Edits_and_a_conversion_are_written_as_the_parts_write_them([Values] bool isChecked)
    {
        var target = new ConvertOptions { RelativeE = false, DecimalsE = 3 };
        var job = Job.Edit(new FileEdits { Speed = 0.5, Move = new Vec3(5, 0) }).OrThrow() with { Target = target };
        using var stream = new MemoryStream();
        var written = job.Write(stream, "a.gcode", isChecked ? new PrintSetup() : null);
        var edited = GCodeEditor.ToDocument(job.File, job.Toolpath).OrThrow();
        var converted = GCodeConverter.ToDocument(GCodeDecoder.Decode(edited, new DecodeOptions { Flavor = job.File.Flavor }).OrThrow(), target).OrThrow();
        Assert.That(stream.ToArray(), Is.EqualTo(converted.ToBytes()));
        Assert.That((written.Value!.Lines, written.Value.Bytes), Is.EqualTo(((long)converted.LineCount, converted.Length)));
    }

    [Test]
    public void A_check_refuses_and_a_reason_in_words_overrides_it()
    {
        using var folder = new TemporaryFolder();
        var job = Job.Edit(new FileEdits { Move = new Vec3(300, 0) }).OrThrow();
        var refused = job.WriteFile(folder.File("a.gcode"), new PrintSetup());
        Assert.That(refused.Diagnostics.Select(d => d.Code), Does.Contain(SafeWriter.Refused).And.Contain("bed.outside"));
        Assert.That(Directory.GetFiles(folder.Path), Is.Empty);
        var written = job.WriteFile(folder.File("a.gcode"), new PrintSetup(), "a longer bed").OrThrow();
        Assert.That(written.Overridden, Is.GreaterThan(0));
        Assert.That(File.ReadAllText(folder.File("a.gcode")), Does.Contain("Reason: a longer bed"));
        // As the guarded editor writes it.
        var edited = SafeWriter.ToDocument(job.File, job.Toolpath, new PrintSetup(), "a longer bed").OrThrow();
        Assert.That(File.ReadAllBytes(folder.File("a.gcode")), Is.EqualTo(edited.ToBytes()));
    }

    [Test]
    public void Of_a_moved_print_that_leaves_its_bed_the_share_of_its_moves_is_told()
    {
        var own = SafeWriter.ToDocument(Job.Toolpath, new PrintSetup(), "a test").OrThrow();
        var moved = new FileJob(GCodeDecoder.Decode(own).OrThrow()).Edit(new FileEdits { Move = new Vec3(300, 0) }).OrThrow();
        var found = moved.Write(new MemoryStream(), "a.gcode", null).Diagnostics.Single(d => d.Code == "bed.outside");
        Assert.That(found.Share, Is.EqualTo((double)found.Count / moved.Toolpath.Count).And.GreaterThan(0));
    }

    [TestCase(0, false)]
    [TestCase(5, true)]
    public void A_print_that_is_moved_up_from_its_bed_begins_in_the_air(double up, bool found)
    {
        var moved = Job.Edit(new FileEdits { Move = new Vec3(1, 0, up) }).OrThrow();
        Assert.That(moved.Write(new MemoryStream(), "a.gcode", null).Diagnostics.Select(d => d.Code).Contains(CheckCodes.InAir), Is.EqualTo(found));
    }

    [Test]
    public void The_reason_stands_above_all_moves_of_a_converted_file()
    {
        var job = Job.Edit(new FileEdits { Move = new Vec3(300, 0) }).OrThrow() with { Target = new ConvertOptions { RelativeE = false } };
        using var stream = new MemoryStream();
        job.Write(stream, "a.gcode", new PrintSetup(), "a longer bed").OrThrow();
        var lines = System.Text.Encoding.ASCII.GetString(stream.ToArray()).Split('\n');
        int First(string text) => Array.FindIndex(lines, l => l.Contains(text));
        Assert.That(First("Reason: a longer bed"), Is.InRange(0, First("G1 X350")));
    }

    [Test]
    public void A_file_that_is_no_GCode_is_not_opened()
    {
        using var folder = new TemporaryFolder();
        File.WriteAllText(folder.File("a.gcode"), "solid part\nfacet normal 0 0 1\n");
        Assert.That(FileJob.Open(folder.File("a.gcode")).Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "gcode.not_gcode" }));
    }

    [Test]
    public void Scaling_is_about_the_middle_of_the_base_and_comes_before_turning_and_moving()
    {
        var edited = Job.Edit(new FileEdits { Scale = new Vec3(2, 2, 1), Rotate = 90, Move = new Vec3(0, 100) }).OrThrow().Toolpath;
        var box = MoveFilter.Prints.BoundsIn(edited);
        Assert.That((box.Center.WithZ(0) - new Vec3(60, 160)).Length + (box.Size - new Vec3(40, 40, 0.2)).Length, Is.LessThan(1e-9));
    }

    [Test]
    public void A_layer_that_is_not_there_gives_none_and_a_selection_of_nothing_a_warning()
    {
        Assert.That(Job.Edit(new FileEdits { PauseAtLayers = [7] }).Diagnostics.Single().Code, Is.EqualTo("toolpath.no_layer"));
        var nothing = Job.Edit(new FileEdits { Filter = new MoveFilter { FirstLayer = 5 }, Flow = 2 });
        Assert.That(nothing.Diagnostics.Single().Code, Is.EqualTo("edit.nothing_selected"));
        Assert.That(ToolpathTotals.Of(nothing.OrThrow().Toolpath).DepositedE, Is.EqualTo(2.8).Within(1e-9));
    }
}

using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Shaping;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Jobs;

/// <summary>What edits report, and which moves they take.</summary>
[Category("Arithmetic")]
public class FileEditDetailTests
{
    private const string Text = "G28\nM109 S200\nM83\n;LAYER:0\n;HEIGHT:0.2\nG1 X50 Y50 Z0.2 F3000\nG1 X70 E0.7\n;LAYER:1\n"
        + "G1 Z0.4\nG1 X50 E0.7\n;LAYER:2\nG1 Z0.6\nG1 X70 E0.7\n";

    private static Toolpath Decoded(string text = Text) => GCodeDecoder.Decode(GCodeDocument.FromText(text)).OrThrow().Toolpath;

    private static string[] Found(FileEdits edits, string text = Text) => edits.Apply(Decoded(text)).Diagnostics.Select(d => d.Code).ToArray();

    [Test]
    public void Scaling_reports_moves_without_E_and_different_factors()
    {
        const string Plain = "G28\n;LAYER:0\n;TYPE:Perimeter\nG1 X50 Y50 Z0.2 F3000\nG1 X70\n";
        Assert.That(Found(new FileEdits { Scale = new Vec3(2, 2, 2) }), Is.Empty);
        Assert.That(Found(new FileEdits { Scale = new Vec3(1, 2, 2) }), Is.EqualTo(new[] { "edit.nonuniform_scale" }));
        Assert.That(Found(new FileEdits { Scale = new Vec3(2, 2, 1) }), Is.EqualTo(new[] { "edit.nonuniform_scale" }));
        Assert.That(Found(new FileEdits { Scale = new Vec3(1, 2, 2) }, Plain), Is.EqualTo(new[] { "edit.no_e_values" }));
    }

    [TestCase(0.29, false)]
    [TestCase(0.31, true)]
    public void A_gap_of_more_than_half_a_layer_is_in_the_air(double rise, bool isReported)
    {
        var moved = new FileEdits { Filter = new MoveFilter { FirstLayer = 1 }, Move = new Vec3(0, 0, rise - 0.2) };
        Assert.That(Found(moved), Is.EqualTo(isReported ? new[] { "edit.in_the_air" } : []));
    }

    [Test]
    public void Without_its_lowest_layer_a_print_is_in_the_air_and_without_its_highest_not()
    {
        Assert.That(Found(new FileEdits { Filter = new MoveFilter { LastLayer = 0 }, Remove = true }), Is.EqualTo(new[] { "edit.in_the_air" }));
        Assert.That(Found(new FileEdits { Filter = new MoveFilter { FirstLayer = 1, LastLayer = 1 }, Remove = true }), Is.EqualTo(new[] { "edit.in_the_air" }));
        Assert.That(Found(new FileEdits { Filter = new MoveFilter { FirstLayer = 2 }, Remove = true }), Is.Empty);
    }

    [Test]
    public void The_highest_layers_alone_are_a_cut_below_them()
    {
        Assert.That(Cut(new MoveFilter { FirstLayer = 1 }), Is.EqualTo(0.2).Within(1e-9));
        Assert.That(Cut(new MoveFilter { FirstLayer = 2, LastLayer = 2 }), Is.EqualTo(0.4).Within(1e-9));
        Assert.That(Cut(new MoveFilter { FirstLayer = 2, LastLayer = 9 }), Is.EqualTo(0.4).Within(1e-9));
        Assert.That(Cut(new MoveFilter { FirstLayer = 1, LastLayer = 1 }), Is.Null, "A layer above stays.");
        Assert.That(Cut(new MoveFilter { FirstLayer = 1, Roles = [Role.Infill] }), Is.Null, "Something else is selected, too.");
        Assert.That(Cut(new MoveFilter()), Is.Null);
        Assert.That(new FileEdits { Filter = new MoveFilter { FirstLayer = 1 } }.Cut(Decoded()), Is.Null, "Nothing is removed.");

        static double? Cut(MoveFilter filter) => new FileEdits { Filter = filter, Remove = true }.Cut(Decoded());
    }

    [Test]
    public void Layers_are_removed_with_their_travels_and_roles_without()
    {
        var layer = new FileEdits { Filter = new MoveFilter { FirstLayer = 1, LastLayer = 1 }, Remove = true }.Apply(Decoded()).OrThrow();
        Assert.That(layer.Moves().Count(m => m.Layer == 1), Is.Zero);
        var inBox = new MoveFilter { Box = new Bounds(new Vec3(0, 0, 0.3), new Vec3(99, 99, 0.5)) };
        var box = new FileEdits { Filter = inBox, Remove = true }.Apply(Decoded()).OrThrow();
        Assert.That(box.Moves().Where(m => m.Layer == 1).Select(m => m.Kind), Is.Not.Empty.And.All.EqualTo(MoveKind.Travel));
    }

    [Test]
    public void Speed_flow_and_arcs_change_extrusions_alone()
    {
        var faster = new FileEdits { Speed = 2 }.Apply(Decoded()).OrThrow();
        Assert.That(faster.Moves().Where(m => m.Layer >= 0).Select(m => (m.Kind, m.Speed)).Distinct(),
            Is.EquivalentTo(new[] { (MoveKind.Travel, 50.0), (MoveKind.Print, 100.0) }));
        var richer = new FileEdits { Flow = 2 }.Apply(Decoded()).OrThrow();
        Assert.That(ToolpathTotals.Of(richer).DepositedE, Is.EqualTo(4.2).Within(1e-9));
        var round = string.Concat(Enumerable.Range(0, 37).Select(i => i * 10 * System.Math.PI / 180).Select(a => System.FormattableString.Invariant(
            $"G1 X{100 + 20 * System.Math.Cos(a):0.000} Y{100 + 20 * System.Math.Sin(a):0.000} E0.1\n")));
        var circle = Decoded("G28\nM83\n;LAYER:0\nG1 X120 Y100 Z0.2 F3000\n" + round);
        Assert.That(new FileEdits { FitArcs = 0.2 }.Apply(circle).OrThrow().Moves().Count(), Is.LessThan(10));
        Assert.That(new FileEdits().Apply(circle).OrThrow(), Is.SameAs(circle));
    }

    [Test]
    public void A_job_remembers_that_its_print_has_moved()
    {
        var job = new FileJob(GCodeDecoder.Decode(GCodeDocument.FromText(Text)).OrThrow());
        Assert.That(job.Edit(new FileEdits { Speed = 2 }).OrThrow().IsMoved, Is.False);
        foreach (var edits in new[]
        {
            new FileEdits { Scale = new Vec3(2, 2, 2) }, new FileEdits { Rotate = 5 }, new FileEdits { Move = new Vec3(1, 0) },
            new FileEdits { Deform = _ => Deformation.Cartesian(p => p) },
        })
        {
            var moved = job.Edit(edits).OrThrow();
            Assert.That((moved.IsMoved, moved.Edit(new FileEdits { Speed = 2 }).OrThrow().IsMoved), Is.EqualTo((true, true)));
        }
    }

    [Test]
    public void Own_start_and_end_code_are_written_and_checked([Values] bool isChecked)
    {
        var job = new FileJob(GCodeDecoder.Decode(GCodeDocument.FromText(Text)).OrThrow());
        foreach (var code in new[] { new EditOptions { Start = ["G28", "M109 S205", "M83"] }, new EditOptions { End = ["M18"] } })
        {
            using var stream = new MemoryStream();
            (job with { Code = code }).Write(stream, "a.gcode", isChecked ? new PrintSetup() : null).OrThrow();
            Assert.That(Encoding.ASCII.GetString(stream.ToArray()), Does.Contain((code.Start ?? code.End)!.Last()).And.Contain("G1 X70 E0.7"));
        }
    }

    [Test]
    public void Tools_that_the_file_does_not_have_are_refused_unless_a_printer_has_them()
    {
        var job = new FileJob(GCodeDecoder.Decode(GCodeDocument.FromText(Text)).OrThrow());
        var changed = job.Edit(new FileEdits { AtLayers = [(1, new ToolEvent(1))] }).OrThrow();
        using var stream = new MemoryStream();
        var refused = changed.Write(stream, "a.gcode", null);
        Assert.That(refused.Value, Is.Null);
        Assert.That(refused.Diagnostics.Single().Message, Does.Contain("uses tool 1").And.Contain("only tool 0."));
        var same = job.Edit(new FileEdits { AtLayers = [(1, new ToolEvent(0))] }).OrThrow();
        Assert.That(same.Write(stream, "a.gcode", null).Value, Is.Not.Null);
    }
}

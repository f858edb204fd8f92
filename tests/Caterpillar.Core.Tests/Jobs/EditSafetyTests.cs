using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Machines;
using Caterpillar.Tests.GCode;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Jobs;

/// <summary>
/// Random cuts and edits of sliced files, watched by an interpreter of its own: hot and homed before the first extrusion, nothing in the air, a lift last.
/// </summary>
public class EditSafetyTests
{
    // Objects one after the other have no lower half.
    private static readonly string[] Sequential = ["ps_torus_sequential"];

    // Packed files are the long ones.
    public static IEnumerable<string> Files()
        => GCodeFiles.Affordable().Where(f => !f.StartsWith("hand_", StringComparison.Ordinal))
            .Where(f => Rounds.Full || !f.EndsWith(".gz", StringComparison.Ordinal));

    [TestCaseSource(nameof(Files))]
    [Category("Arithmetic")]
    public void A_printer_prints_cut_and_edited_files_safely(string name)
    {
        var job = Open(name);
        var before = Watch(job.File.Document!.ToBytes(), job);
        var random = new Random(name.Length);
        for (var round = Rounds.Of(quick: 1, full: 4, onMono: 1); round > 0; round--)
        {
            foreach (var (what, edited, endChanges) in Edits(job, random))
            {
                var after = Watch(Bytes(edited), job);
                Assert.That(after.Alarms.Except(before.Alarms), Is.Empty, what);
                Assert.That(after.InTheAir / after.Printed, Is.LessThan(before.InTheAir / before.Printed + 0.03), what);
                if (before.Lifts || endChanges) Assert.That(after.Lifts, what);
            }
        }
    }

    [TestCaseSource(nameof(Files))]
    [Category("Arithmetic")]
    public void The_halves_of_a_cut_print_are_the_whole(string name)
    {
        var job = Open(name);
        var random = new Random(name.Length + 1);
        var whole = Watch(job.File.Document!.ToBytes(), job);
        for (var round = Rounds.Of(quick: 1, full: 4, onMono: 1); round > 0; round--)
        {
            var z = Height(job, random);
            var standing = job.Toolpath.UsedLayers().Where(l => l.Z <= z).Max(l => l.Z);
            var lower = job.KeepBelow(z);
            if (Sequential.Any(name.StartsWith))
            {
                Assert.That(lower.Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "cut.sequential" }));
                return;
            }
            var below = Watch(Bytes(lower.OrThrow()), job);
            var upper = job.KeepAbove(z);
            if (job.File.Flavor.StatesHeight.Length == 0)
            {
                Assert.That(upper.Diagnostics.Select(d => d.Code), Is.EqualTo(new[] { "cut.no_start" }));
                string[] start = ["G92 Z" + NumberFormatter.Format(standing, 3), "G91", "G1 Z5", "G90", "M109 S200", "G28 X0 Y0"];
                upper = (job with { Code = new EditOptions { Start = start } }).KeepAbove(z);
            }
            var above = Watch(Bytes(upper.OrThrow()), job, standing);
            var what = $"{name}, {z}";
            Assert.That(below.Alarms.Except(whole.Alarms), Is.Empty, what);
            Assert.That(above.Alarms.Except(whole.Alarms), Is.Empty, what);
            Assert.That(below.Lifts && above.CameFromAbove, what);
            Assert.That(above.Lowest, Is.GreaterThanOrEqualTo(standing), what);
            Assert.That(below.Printed + above.Printed, Is.EqualTo(whole.Printed).Within(0.01 * whole.Printed), what);
            Assert.That(above.InTheAir / above.Printed, Is.LessThan(whole.InTheAir / whole.Printed + 0.1), what);
        }
    }

    private static IEnumerable<(string What, FileJob Job, bool EndChanges)> Edits(FileJob job, Random random)
    {
        var numbers = job.Toolpath.NumbersOfLayers();
        int Layer() => numbers[random.Next(1, numbers.Count)];
        var top = Layer();
        yield return ($"from layer {top} removed", Edit(job, new FileEdits { Remove = true, Filter = new MoveFilter { FirstLayer = top } }), true);
        var edits = new FileEdits { Speed = 0.5 + random.NextDouble(), Flow = 0.9, Move = new Vec3(random.Next(9), 2), Rotate = random.Next(360) };
        yield return ("moved", Edit(job, edits), false);
        var pausing = new PrintSetup() { Printer = new Printer { PauseLift = 5, PauseRetraction = 1 } };
        yield return ("paused", Edit(job, new FileEdits { PauseAtLayers = [Layer()], PauseFor = pausing, AtLayers = [(Layer(), new FanEvent(1))] }), false);
        var objects = job.Toolpath.Layers.Select(l => l.Object).Distinct().ToArray();
        if (objects.Length < 2) yield break;
        var filter = new MoveFilter { Objects = [objects[random.Next(objects.Length)]] };
        if (job.Toolpath.Layers.Any(l => !filter.Objects.Contains(l.Object)))
            yield return ($"without {filter.Objects.Single()}", Edit(job, new FileEdits { Remove = true, Filter = filter }), false);
    }

    private static FileJob Edit(FileJob job, FileEdits edits) => job.Edit(edits).OrThrow();

    private static double Height(FileJob job, Random random)
    {
        var heights = job.Toolpath.UsedLayers().Select(l => l.Z).OrderBy(z => z).ToArray();
        return heights[0] + (0.05 + 0.85 * random.NextDouble()) * (heights[heights.Length - 1] - heights[0]);
    }

    private static FileJob Open(string name) => new(GCodeDecoder.Decode(GCodeFiles.Document(name)).OrThrow());

    private static byte[] Bytes(FileJob job)
    {
        using var stream = new MemoryStream();
        job.Write(stream, "a.gcode", null).OrThrow();
        return stream.ToArray();
    }

    private static PrinterEye Watch(byte[] bytes, FileJob job, double standing = 0)
    {
        var axis = job.File.Report.ExtrusionAxis;
        return new PrinterEye(PrinterEye.Text(bytes), axis == "M101" ? 'M' : axis[0], false, standing);
    }
}

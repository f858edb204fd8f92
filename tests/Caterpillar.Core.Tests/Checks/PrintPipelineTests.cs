using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using System.Threading.Tasks;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Prints that are planned layer by layer and checked while they are planned are those that are planned and checked at once.</summary>
[Category("Runtime")]
public sealed class PrintPipelineTests
{
    private const int Layers = 40;

    private static PrintSetup Plain => SmallPrint.Setup(p => p with { RetractionLength = 0.8 });

    private static IEnumerable<TestCaseData> Setups()
    {
        yield return new TestCaseData(Plain).SetArgDisplayNames("time and progress are told");
        yield return new TestCaseData(SmallPrint.Setup(p => p with { ProgressCommands = false })).SetArgDisplayNames("no progress");
        yield return new TestCaseData(SmallPrint.Setup(p
            => p with { StartGCode = new ValueList<string>(["G28", "G1 Z2 F600", "G1 X5 Y5 Z0.3", "G1 X15 E1"]) }))
            .SetArgDisplayNames("start code");
        yield return new TestCaseData(SmallPrint.Setup(p => p with { StartGCode = new ValueList<string>(["G28", "G1 Z{print_max_z_mm}"]) }))
            .SetArgDisplayNames("measured");
        yield return new TestCaseData(SmallPrint.Setup(p
            => p with { ExtrusionMode = ExtrusionMode.Absolute, LayerChangeGCode = new ValueList<string>(["M117 {layer}"]) }))
            .SetArgDisplayNames("absolute E, layer template");
        yield return new TestCaseData(Plain with { Settings = new PrintSettings { LayerTimeWait = LayerTimeWait.NextTo, MinLayerTime = 300 } })
            .SetArgDisplayNames("layers wait");
    }

    private static IEnumerable<TestCaseData> SomeSetups() => Rounds.Some(Setups(), 3);

    [TestCaseSource(nameof(SomeSetups))]
    public void The_file_and_its_findings_are_those_of_a_plan_made_at_once(PrintSetup setup)
    {
        var layers = Print(false);
        var plan = Planner.PlanWithReport(layers.SelectMany(l => l).ToArray(), setup);
        using var expected = new MemoryStream();
        var whole = SafeWriter.Write(plan.Value!.Toolpath, setup, expected, "a test", isDraft: true);

        using var pipeline = new PrintPipeline(setup);
        foreach (var layer in layers) pipeline.Add(layer);
        var streamed = pipeline.Finish();
        using var stream = new MemoryStream();
        var written = pipeline.Write(stream, true, "a test");

        Assert.That(streamed.Value!.Report, Is.EqualTo(plan.Value.Report));
        Assert.That(streamed.Diagnostics, Is.EqualTo(plan.Diagnostics));
        Assert.That(stream.ToArray(), SameBytes.As(expected.ToArray()));
        Assert.That(written.Diagnostics, Is.EqualTo(whole.Diagnostics));
        Assert.That(written.Diagnostics.Select(d => d.Code), Does.Contain(CheckCodes.Unsupported));
    }

    [Test]
    public void Findings_that_name_other_lines_are_the_same()
    {
        var layers = Print(true);
        var plan = Planner.Plan(layers.SelectMany(l => l).ToArray(), Plain).Value!;
        var whole = SafeWriter.Write(plan, Plain, new MemoryStream(), "a test", isDraft: true);

        using var pipeline = new PrintPipeline(Plain);
        foreach (var layer in layers) pipeline.Add(layer);
        var written = pipeline.Write(new MemoryStream(), true, "a test");

        Assert.That(written.Diagnostics, Is.EqualTo(whole.Diagnostics));
        Assert.That(written.Diagnostics.Single(d => d.Code == CheckCodes.Duplicate).Message, Does.Contain("(line "));
    }

    [Test]
    public void What_was_found_in_a_draft_holds_for_the_same_text_only()
    {
        var (soFar, plan) = Taken(Plain);
        Assert.That(soFar.Count, Is.GreaterThan(1));
        Assert.That(soFar[1].Blocks[0].Columns, Is.SameAs(plan.Blocks[0].Columns));
        var format = SetupFormat.Of(Plain, plan).Value!;
        IReadOnlyList<Diagnostic>? Found(Toolpath written, GCodeFormat format)
        {
            using var draft = PrintDraft.Begin(soFar[0], Plain, default)!;
            foreach (var part in soFar) draft.Take(part);
            return draft.Finish(plan, written, format, null, null).Findings;
        }

        Assert.That(Found(plan, format)!.Select(d => d.Code), Does.Contain(CheckCodes.Unsupported));
        Assert.That(Found(plan, format with { Facts = [";TIME:60", "; thumbnail"] }), Is.Not.Null);
        Assert.That(Found(plan.Insert(100, new ProgressEvent(3, 20)), format), Is.Not.Null);
        Assert.That(Found(plan, format with { Header = ["another"] }), Is.Null);
        var changed = plan.Blocks[0].Columns.Copy(plan.Blocks[0].Count);
        changed.X[100] += 0.001;
        Assert.That(Found(plan.With([new ToolpathBlock(changed), .. plan.Blocks.Skip(1)]), format), Is.Null);
    }

    [Test]
    public void Findings_name_the_lines_of_the_file_and_not_those_of_the_draft()
    {
        var (soFar, plan) = Taken(Plain);
        var timed = plan.Insert(0, new ProgressEvent(0, 9)).Insert(7000, new ProgressEvent(50, 5)).Insert(7000, new FanEvent(1));
        plan = plan.Insert(7000, new FanEvent(1));
        var format = SetupFormat.Of(Plain, plan).Value! with { Facts = [";TIME:60", "; thumbnail"] };
        using var draft = PrintDraft.Begin(soFar[0], Plain, default)!;
        using var stream = new MemoryStream();
        var found = draft.Finish(plan, timed, format, stream, null);
        var whole = new WrittenLines();
        new GCodeWriter(timed, format) { Written = whole }.WriteAll(Stream.Null);
        var at = found.Findings!.Single(d => d.Code == CheckCodes.Unsupported).Source!;
        Assert.That(at.Line, Is.EqualTo(whole.OfMove(at.Move!.Value).First));
        Assert.That(found.Lines, Is.EqualTo(Encoding.UTF8.GetString(stream.ToArray()).Count(c => c == '\n')));
    }

    [TestCase("G1 X1 Y2\nG1 X3\n", "G1 X1 Y2\nG1 X4\n", false)]
    [TestCase("G1 X1 Y2\nG1 X3\n", "G1 X3\nG1 X1 Y2\n", false)]
    [TestCase("G1 X1 Y2\nG1 X3\n", "G1 X1 Y2\n", false)]
    [TestCase("G1 X12345678\n", "G1 X12345679\n", false)]
    [TestCase("G1 X1\n", "G1 X1\nM73 P5 R3\n", true)]
    [TestCase("G1 X1\n", "; TIME\nG1 X1\n", false)]
    [TestCase("G1 X1\n", "M730 P5\nG1 X1\n", false)]
    [TestCase("M93 S1\n", "M93 S2\n", false)]
    public void A_digest_tells_every_change_of_a_line_but_progress(string text, string other, bool same)
    {
        static ulong Digest(params string[] parts)
        {
            using var digest = new TextDigest(null);
            foreach (var part in parts) digest.Write(Encoding.ASCII.GetBytes(part), 0, part.Length);
            return digest.Sum;
        }

        Assert.That(Digest(other) == Digest(text), Is.EqualTo(same));
        Assert.That(Digest(text.TrimEnd('\n').Split('\n').Select(l => l + "\n").ToArray()), Is.EqualTo(Digest(text)));
    }

    [Test]
    public void A_template_that_measures_the_print_has_no_draft()
    {
        var print = new SmallPrint().Print(20, 10, 0.2).Build();
        PrintDraft? Begin(Func<Printer, Printer> change) => PrintDraft.Begin(print, SmallPrint.Setup(change), default);
        using var plain = Begin(p => p with { StartGCode = new ValueList<string>(["G28"]), EndGCode = new ValueList<string>(["G1 Z{print_max_z_mm}"]) });
        Assert.That(plain, Is.Not.Null);
        Assert.That(Begin(p => p with { StartGCode = new ValueList<string>(["G1 X{print_min_x_mm}"]) }), Is.Null);
        Assert.That(Begin(p => p with { LayerChangeGCode = new ValueList<string>(["M117 {layer} of {layer_count}"]) }), Is.Null);
        Assert.That(Begin(p => p with { ToolChangeGCode = new ValueList<string>(["M117 {filament_used_mm}"]) }), Is.Null);
    }

    [Test]
    public void A_canceled_timing_of_a_plan_says_so()
    {
        var (timing, plan) = (new PlanTiming(Plain, new CancellationToken(true)), new SmallPrint().Print(30, 10, 0.2).Build());
        Assert.That(timing.Finish(), Is.Null, "nothing was planned");
        timing.Take(plan);
        timing.Take(plan);
        Assert.That(() => timing.Finish(), Throws.InstanceOf<OperationCanceledException>());
    }

    [Test]
    public void It_stops_when_it_is_canceled_or_no_longer_wanted()
    {
        var layers = Print(false);
        using var source = new CancellationTokenSource();
        var clock = new Stopwatch();
        using (var pipeline = new PrintPipeline(Plain, null, source.Token))
        {
            foreach (var layer in layers.Take(Layers / 2)) pipeline.Add(layer);
            source.Cancel();
            clock.Start();
            Assert.That(() => pipeline.Add(layers[Layers / 2]), Throws.InstanceOf<OperationCanceledException>());
            Assert.That(() => pipeline.Finish(), Throws.InstanceOf<OperationCanceledException>());
        }
        using (var pipeline = new PrintPipeline(Plain))
        {
            foreach (var layer in layers) pipeline.Add(layer);
        }
        Assert.That(clock.Elapsed.TotalSeconds, Is.LessThan(10));
        Assert.That(Task.Run(() => new PrintPipeline(Plain).Dispose()).Wait(10_000), "nothing was ever printed");
    }

    [Test]
    public void What_is_wrong_with_steps_is_told_once_and_nothing_is_written()
    {
        using var pipeline = new PrintPipeline(Plain);
        pipeline.Add([Extrusion(0, 10, 10, 20)]);
        pipeline.Add([(Step)(Extrusion(1, 10, 10, 20).Path with { Tool = 3 })]);
        var plan = pipeline.Finish();
        Assert.That(plan.Value, Is.Null);
        Assert.That(plan.Diagnostics.Single().Code, Is.EqualTo("plan.unknown_tool"));
        Assert.That(plan.Diagnostics.Single().Source!.Step, Is.EqualTo(1));
        Assert.That(() => pipeline.Write(Stream.Null, true), Throws.InvalidOperationException);
    }

    // Lines of 2 mm beside each other, 1,100 in a layer; some in the air, and, where they are wanted, some in the place of others.
    private static IReadOnlyList<Step>[] Print(bool doubled)
    {
        var layers = new IReadOnlyList<Step>[Layers];
        for (var layer = 0; layer < Layers; layer++)
        {
            var z = 0.2 * (layer + 1);
            var points = new List<Vec3>();
            for (var i = 0; i < 550; i++)
            {
                points.Add(new Vec3(i % 2 == 0 ? 22 : 20, 20 + 0.2 * i, z));
                points.Add(new Vec3(i % 2 == 0 ? 22 : 20, 20.2 + 0.2 * i, z));
            }
            var place = new Layer(layer, z, 0.2, "comb");
            var steps = new List<Step> { new PathStep(new PrintPath(points, new Bead(SmallPrint.Area, 0.2)) with { Role = Role.Infill, Layer = place },
                new StepGroup(layer, 1)) };
            if (layer % 9 == 4) steps.Add(Extrusion(layer, 100, 20, 112));
            if (doubled && layer > 10 && layer % 9 == 4) steps.AddRange([Extrusion(layer, 60, 60, 120, 2), Extrusion(layer, 60, 60, 120, 3)]);
            steps.Add(Extrusion(layer, 40, 40, 70));
            layers[layer] = steps;
        }
        return layers;
    }

    private static PathStep Extrusion(int layer, double x, double y, double to, int rank = 0)
    {
        var z = 0.2 * (layer + 1);
        var path = new PrintPath([new Vec3(x, y, z), new Vec3(to, y, z)], new Bead(SmallPrint.Area, 0.2))
            with { Role = Role.OuterWall, Layer = new Layer(layer, z, 0.2, "comb") };
        return new PathStep(path, new StepGroup(layer, 0, rank));
    }

    private static (List<Toolpath> SoFar, Toolpath Plan) Taken(PrintSetup setup)
    {
        var soFar = new List<Toolpath>();
        var run = Planner.Begin(setup, null, soFar.Add, default);
        foreach (var layer in Print(false)) run.Add(layer, null);
        return (soFar, run.Finish().Value!.Toolpath);
    }
}

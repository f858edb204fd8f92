using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Planning;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Prints that are planned layer by layer and checked while they are planned are those that are planned and checked at once.</summary>
[Category("Runtime")]
public sealed class PrintPipelineTests
{
    private const int Layers = 40;

    private static PrintSetup Plain => SmallPrint.Setup(p => p with { RetractionDistance = 0.8 });

    private static IEnumerable<TestCaseData> Setups()
    {
        yield return new TestCaseData(Plain).SetArgDisplayNames("time and progress are told");
        yield return new TestCaseData(SmallPrint.Setup(p => p with { ProgressLines = false })).SetArgDisplayNames("no progress");
        yield return new TestCaseData(SmallPrint.Setup(p
            => p with { StartTemplate = new ValueList<string>(["G28", "G1 Z2 F600", "G1 X5 Y5 Z0.3", "G1 X15 E1"]) }))
            .SetArgDisplayNames("start code");
        yield return new TestCaseData(SmallPrint.Setup(p => p with { StartTemplate = new ValueList<string>(["G28", "G1 Z{print_max_z_mm}"]) }))
            .SetArgDisplayNames("measured");
        yield return new TestCaseData(SmallPrint.Setup(p
            => p with { ExtrusionMode = ExtrusionMode.Absolute, LayerTemplate = new ValueList<string>(["M117 {layer}"]) }))
            .SetArgDisplayNames("absolute E, layer template");
        yield return new TestCaseData(Plain with { Settings = new PrintSettings { LayerWait = LayerWait.Away, MinLayerTime = 300 } })
            .SetArgDisplayNames("layers wait");
    }

    [TestCaseSource(nameof(Setups))]
    public void The_file_and_its_findings_are_those_of_a_plan_made_at_once(PrintSetup setup)
    {
        var layers = Print(false);
        var plan = Planner.PlanWithReport(layers.SelectMany(l => l).ToArray(), setup);
        using var expected = new MemoryStream();
        var whole = SafeWriter.WriteDraft(plan.Value!.Toolpath, setup, expected, "a test");

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
        var whole = SafeWriter.WriteDraft(plan, Plain, new MemoryStream(), "a test");

        using var pipeline = new PrintPipeline(Plain);
        foreach (var layer in layers) pipeline.Add(layer);
        var written = pipeline.Write(new MemoryStream(), true, "a test");

        Assert.That(written.Diagnostics, Is.EqualTo(whole.Diagnostics));
        Assert.That(written.Diagnostics.Single(d => d.Code == CheckCodes.Doubled).Message, Does.Contain("(line "));
    }

    [Test]
    public void What_was_found_early_holds_for_the_same_moves_only()
    {
        var (soFar, plan) = Followed(Plain);
        Assert.That(soFar.Count, Is.GreaterThan(1));
        Assert.That(soFar[1].Blocks[0].Columns, Is.SameAs(plan.Blocks[0].Columns));
        var (file, lines, _) = SmallPrint.Written(plan, Plain);
        var read = InSmallBlocks(plan, Plain).WithTools(plan.Tools);
        var places = new WrittenPlaces(plan, move => move < 0 || move >= read.Count ? null : read[move].Source, lines, Plain.Printer);
        var expected = PrintCheck.Run(file.Toolpath.WithTools(plan.Tools), Plain).Where(d => d.Code == CheckCodes.Unsupported)
            .Select(d => (d.Message, d.Count));

        IReadOnlyList<Diagnostic>? Early(Toolpath written)
        {
            using var early = EarlyCheck.Begin(Plain, plan.Tools, default)!;
            foreach (var part in soFar) early.Take(part);
            Assert.That(SpinWait.SpinUntil(() => early.Blocks >= 3, 10_000));
            return early.Finish(written, places, null);
        }

        var found = Early(read)!;
        Assert.That(found.Where(d => d.Code == CheckCodes.Unsupported).Select(d => (d.Message, d.Count)), Is.EqualTo(expected));
        Assert.That(found.All(d => d.Source is null || d.Source.Line > 0));
        var changed = read.Blocks[0].Columns.Copy(read.Blocks[0].Count);
        changed.X[100] += 0.001;
        Assert.That(Early(read.WithBlocks([new ToolpathBlock(changed), .. read.Blocks.Skip(1)])), Is.Null);
        Assert.That(Early(read.WithTools([new ToolpathTool(1)])), Is.Null);
    }

    [Test]
    public void Times_hold_for_the_same_moves_only()
    {
        var (soFar, plan) = Followed(Plain);
        var expected = MotionPlanner.Plan(plan, Plain, null, default).Motion;
        MotionColumns? Timed(Toolpath whole)
        {
            var early = new EarlyTiming(Plain);
            foreach (var part in soFar) early.Take(part, default);
            return early.Finish(whole, default);
        }

        Assert.That(soFar.Count, Is.GreaterThan(2));
        var timed = Timed(plan)!;
        Assert.That(timed.TotalTime, Is.EqualTo(expected.TotalTime));
        Assert.That(Enumerable.Range(0, plan.Count).All(i => timed.StartTime(timed.First[i]) == expected.StartTime(expected.First[i])));
        Assert.That(Timed(plan.Insert(plan.Count, new DwellEvent(3)))!.TotalTime, Is.EqualTo(expected.TotalTime + 3).Within(1e-9));
        Assert.That(Timed(plan.Insert(100, new DwellEvent(3))), Is.Null);
        Assert.That(Timed(plan.WithEvents([])), plan.Events.Count == 0 ? Is.Not.Null : Is.Null);
        Assert.That(Timed(plan.WithTools([new ToolpathTool(1)])), Is.Null);
        var changed = plan.Blocks[1].Columns.Copy(plan.Blocks[1].Count);
        Assert.That(Timed(plan.WithBlocks([plan.Blocks[0], new ToolpathBlock(changed), .. plan.Blocks.Skip(2)])), Is.Null);
        var first = plan.Blocks[0].Columns.Copy(plan.Blocks[0].Count);
        Assert.That(Timed(plan.WithBlocks([new ToolpathBlock(first), .. plan.Blocks.Skip(1)])), Is.Null);
        var waits = new EarlyTiming(Plain);
        waits.Take(plan.Insert(100, new DwellEvent(3)), default);
        Assert.That(waits.Finish(plan.Insert(100, new DwellEvent(4)), default), Is.Null, "another wait");
        Assert.That(Timed(plan.WithTools([.. plan.Tools, plan.Tools[0]])), Is.Null);
        Assert.That(Timed(plan.With(new Vec3(1, 2, 3), plan.Layers)), Is.Null);
        Assert.That(new EarlyTiming(Plain).Finish(plan, default), Is.Null);
        var all = new EarlyTiming(Plain);
        all.Take(plan, default);
        Assert.That(all.Finish(soFar[0], default), Is.Null, "less than was planned");
        Assert.That(all.Finish(plan, default)!.TotalTime, Is.EqualTo(expected.TotalTime), "all was planned");
        Assert.That(all.Finish(plan, default), Is.Null, "once");
        var wait = new EarlyTiming(Plain);
        wait.Take(plan, default);
        var waited = wait.Finish(plan.Insert(plan.Count, new DwellEvent(3)), default)!.TotalTime;
        Assert.That(waited, Is.EqualTo(expected.TotalTime + 3).Within(1e-9), "a wait after all");
        var more = new EarlyTiming(Plain);
        more.Take(plan.Insert(plan.Count, new DwellEvent(3)), default);
        Assert.That(more.Finish(plan, default)!.TotalTime, Is.EqualTo(expected.TotalTime), "what may still be put off");
    }

    [Test]
    public void A_digest_tells_every_change_of_a_move()
    {
        var block = CheckRun.BlocksOf(Followed(Plain).Plan, 0).First();
        var before = MoveDigest.Of(block);
        ulong After(Action<ToolpathColumns> change)
        {
            var columns = block.Columns.Copy(block.Columns.Count);
            change(columns);
            return MoveDigest.Of(block with { Columns = columns });
        }

        Assert.That(After(_ => { }), Is.EqualTo(before));
        Action<ToolpathColumns>[] changes =
        [
            c => c.X[0]++, c => c.X[7] = BitConverter.Int64BitsToDouble(BitConverter.DoubleToInt64Bits(c.X[7]) + 1), c => c.Y[7] = -c.Y[7],
            c => c.Z[7]++, c => c.E[7] = 1e-5, c => c.Deposited[7] = 1e-5, c => c.Speed[7]++,
            c => c.Kind[7] = MoveKind.Wipe, c => c.Role[7] = Role.Skirt, c => c.Tool[7] = 1, c => c.Count--,
            c => (c.Y[7], c.Y[11]) = (c.Y[11], c.Y[7]), c => (c.ArcMoves, c.Arcs) = ([7], [new Arc(Vec3.Zero, 90)]),
        ];
        var after = changes.Select(After).ToArray();
        Assert.That(after, Has.None.EqualTo(before));
        Assert.That(after, Is.Unique);
        Assert.That(MoveDigest.Of(block with { Thicknesses = [.. block.Thicknesses!.Select(t => t + 0.1)] }), Is.Not.EqualTo(before));
        Assert.That(MoveDigest.Of(block with { Events = [new MoveEvent(3, new HomeEvent())] }), Is.Not.EqualTo(before));
        Assert.That(MoveDigest.Of(block with { Start = new Vec3(1, 2, 3) }), Is.Not.EqualTo(before));
    }

    [Test]
    public void A_template_that_measures_the_print_has_no_draft()
    {
        EarlyCheck? Begin(Func<Printer, Printer> change) => EarlyCheck.Begin(SmallPrint.Setup(change), [new ToolpathTool(1)], default);
        using var plain = Begin(p => p with { StartTemplate = new ValueList<string>(["G28"]), EndTemplate = new ValueList<string>(["G1 Z{print_max_z_mm}"]) });
        Assert.That(plain, Is.Not.Null);
        Assert.That(Begin(p => p with { StartTemplate = new ValueList<string>(["G1 X{print_min_x_mm}"]) }), Is.Null);
        Assert.That(Begin(p => p with { LayerTemplate = new ValueList<string>(["M117 {layer} of {layer_count}"]) }), Is.Null);
        Assert.That(Begin(p => p with { ToolChangeTemplate = new ValueList<string>(["M117 {filament_used_mm}"]) }), Is.Null);
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
        pipeline.Add([Strand(0, 10, 10, 20)]);
        pipeline.Add([(Step)Strand(1, 10, 10, 20).Path.With(tool: 3)]);
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
            var steps = new List<Step> { new PathStep(new PrintPath(points, new Bead(SmallPrint.Area, 0.2)).With(Role.Infill, place),
                new StepGroup(layer, 1)) };
            if (layer % 9 == 4) steps.Add(Strand(layer, 100, 20, 112));
            if (doubled && layer > 10 && layer % 9 == 4) steps.AddRange([Strand(layer, 60, 60, 120, 2), Strand(layer, 60, 60, 120, 3)]);
            steps.Add(Strand(layer, 40, 40, 70));
            layers[layer] = steps;
        }
        return layers;
    }

    private static PathStep Strand(int layer, double x, double y, double to, int rank = 0)
    {
        var z = 0.2 * (layer + 1);
        var path = new PrintPath([new Vec3(x, y, z), new Vec3(to, y, z)], new Bead(SmallPrint.Area, 0.2))
            .With(Role.OuterWall, new Layer(layer, z, 0.2, "comb"));
        return new PathStep(path, new StepGroup(layer, 0, rank));
    }

    private static (List<Toolpath> SoFar, Toolpath Plan) Followed(PrintSetup setup)
    {
        var soFar = new List<Toolpath>();
        var options = new PlanOptions { Follow = soFar.Add };
        return (soFar, Planner.Plan(Print(false).SelectMany(l => l).ToArray(), setup, options).Value!);
    }

    private static Toolpath InSmallBlocks(Toolpath plan, PrintSetup setup)
    {
        using var memory = new MemoryStream();
        GCodeWriter.Write(plan, SetupFormat.Of(setup, plan).Value!, memory);
        memory.Position = 0;
        var options = new DecodeOptions { Dialect = setup.Printer.Dialect, FilamentDiameter = 1.75, BlockSize = ToolpathBlock.FollowedSize };
        return GCodeDecoder.DecodeStream(memory, options).Value!.Toolpath;
    }
}

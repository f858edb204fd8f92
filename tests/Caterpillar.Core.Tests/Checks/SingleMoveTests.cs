using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Checks that are shown a few moves by hand, and how moves get to them.</summary>
public class SingleMoveTests
{
    private static readonly PrintSetup Setup = SmallPrint.Setup(p => p with { MaxStationaryVolume = 10 });

    // Pushed in place, one after the other; 10 mm³ are allowed.
    [TestCase(new[] { -4.0, 12 }, "12 mm³ are extruded in place")]
    [TestCase(new[] { 4.0, -12 }, "12 mm³ are retracted in place")]
    [TestCase(new[] { 6.0, 6 }, "12 mm³ are extruded in place")]
    [TestCase(new[] { -6.0, -6 }, "12 mm³ are retracted in place")]
    [TestCase(new[] { -6.0, 8, 6 }, null)]
    [TestCase(new[] { 6.0, 0, 4 }, null)]
    [TestCase(new[] { 6.0, double.NaN, 6 }, null)]
    public void Material_in_place_counts_by_itself_and_together(double[] pushed, string? found)
    {
        var list = Stationary(pushed);
        Assert.That(list.Select(d => d.Message.Substring(0, d.Message.IndexOf(", but", StringComparison.Ordinal))),
            Is.EqualTo(found is null ? Array.Empty<string>() : [found]));
    }

    // What is just allowed is no finding, and does not hide the next.
    [Test]
    public void Material_in_place_is_told_once_it_is_too_much()
    {
        const double Most = 10 * (1 + 1e-9);
        Assert.That(Stationary(Most), Is.Empty);
        Assert.That(Stationary(Most, 1).Single().Count, Is.EqualTo(1));
        Assert.That(Stationary(Most, 1, 1, 1).Single().Count, Is.EqualTo(1), "not again for each drop");
        Assert.That(Stationary(-Most, -1, -1, -1).Single().Count, Is.EqualTo(1), "also when it is pulled back");
        Assert.That(Stationary(Most, 1, 11).Single().Count, Is.EqualTo(2), "again for each lump");
    }

    // A circle in between is a move; homing ends a blob.
    [TestCase(true, false, 0)]
    [TestCase(false, true, 0)]
    [TestCase(false, false, 1)]
    public void Material_in_place_is_counted_up_to_the_next_move(bool circle, bool home, int found)
    {
        var findings = new Findings(Setup.Printer, _ => null, _ => null);
        var check = new ExtruderCheck(Setup, findings);
        check.Move(new CheckedMove { StartKnown = true, Kind = MoveKind.Prime, Pushed = 10 });
        if (circle) check.Move(new CheckedMove { StartKnown = true, Kind = MoveKind.Print, Arc = new Arc(Vec3.UnitX, 360), Length = 6, Pushed = 5 });
        if (home) check.Event(new MoveEvent(1, new HomeEvent()));
        check.Move(new CheckedMove { StartKnown = true, Kind = MoveKind.Prime, Pushed = 10 });
        Assert.That(findings.ToList().Sum(d => d.Count), Is.EqualTo(found));
    }

    // After G28 the head goes to the switches; an extrusion or a travel to elsewhere that follows G28 at once is none of that. What comes after is known again.
    [TestCase(0, 0, false, true, false)]
    [TestCase(0, 0.5, false, false, true)]
    [TestCase(0, 0, true, false, true)]
    [TestCase(7, 0, false, false, true)]
    public void A_head_homes_where_it_travels_to_the_switches(double x, double e, bool prints, bool homes, bool known)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(10, 10, 10));
        builder.AddEvent(new HomeEvent());
        builder.Add(new Vec3(x, 0, 0), e, e, 20, prints ? MoveKind.Print : MoveKind.Travel, Role.Unspecified, -1, 0, -1);
        builder.Add(new Vec3(20, 0, 0), 0, 0, 20, MoveKind.Travel, Role.Unspecified, -1, 0, -1);
        builder.Add(new Vec3(30, 0, 0), 0, 0, 20, MoveKind.Travel, Role.Unspecified, -1, 0, -1);
        var seen = new Seen();
        CheckRun.Run(builder.Build([new ToolpathTool(1)]), [seen], null, default);
        Assert.That(seen.All, Is.EqualTo(new[] { (homes, false), (false, known), (false, true) }));
    }

    // Extrusions 16 nozzles thick and more are no extrusions: E is read in the wrong mode. Twenty of them are enough to say so.
    [TestCase(19, 1.0, 0)]
    [TestCase(20, 1.0, 1)]
    [TestCase(40, 0.5, 0)]
    [TestCase(40, 0.55, 1)]
    public void A_file_of_extrusions_that_no_nozzle_prints_is_read_in_the_wrong_mode(int extrusions, double thick, int found)
    {
        var check = new ModeCheck(Setup.Printer, NewFindings(out var findings));
        for (var i = 0; i < extrusions; i++)
            check.Move(new CheckedMove { Index = i, Start = new Vec3(i, 0), End = new Vec3(i + 1, 0), Length = 1, Kind = MoveKind.Print, E = 1,
                Deposited = i < thick * extrusions ? 2.6 : 0.1 });
        check.End(Empty);
        Assert.That(findings.ToList().Sum(d => d.Count), Is.EqualTo(found));
    }

    [TestCase(0, 0, 0, "X, Y, Z")]
    [TestCase(1, 0, 0, "Y, Z")]
    [TestCase(0, 1, 0, "X, Z")]
    [TestCase(0, 0, 1, "X, Y")]
    [TestCase(1, 1, 0, "Z")]
    [TestCase(1, 0, 1, "Y")]
    [TestCase(0, 1, 1, "X")]
    [TestCase(1, 1, 1, null)]
    public void A_file_must_say_where_the_head_is_in_each_axis(double x, double y, double z, string? axes)
    {
        var expected = axes is null ? Array.Empty<string>() : [$"The file prints before the position in {axes} is known. Home first, or move in {axes}."];
        foreach (var homes in new[] { true, false })
        {
            var check = new FileCheck(Empty, new CheckScope(200, IsWholeFile: true), NewFindings(out var findings));
            if (homes) check.Event(new MoveEvent(0, new HomeEvent(x > 0, y > 0, z > 0)));
            else check.Move(new CheckedMove { End = new Vec3(x, y, z), Length = 1, Kind = MoveKind.Travel });
            check.Move(new CheckedMove { Length = 1, Kind = MoveKind.Print, E = 1, Deposited = 0.1 });
            Assert.That(findings.ToList().Where(d => d.Code == CheckCodes.UnknownPosition).Select(d => d.Message), Is.EqualTo(expected), $"{homes}");
        }
    }

    // Two extrusions in line and half a millimeter between them.
    [TestCase(MoveKind.Travel, false, 1)]
    [TestCase(MoveKind.Travel, true, 1)]
    [TestCase(MoveKind.Wipe, false, 0)]
    public void A_gap_is_a_travel_also_where_something_happens_in_place(MoveKind between, bool primes, int found)
    {
        var check = new GapCheck(NewFindings(out var findings));
        Show(MoveKind.Print, 0, 10);
        Show(between, 10, 10.5);
        if (primes) Show(MoveKind.Prime, 10.5, 10.5);
        Show(MoveKind.Print, 10.5, 20);
        Assert.That(findings.ToList().Sum(d => d.Count), Is.EqualTo(found));

        void Show(MoveKind kind, double from, double to)
            => check.Move(new CheckedMove
            {
                Start = new Vec3(from, 0), End = new Vec3(to, 0), StartKnown = true, Kind = kind, Length = to - from, Deposited = 1,
            });
    }

    [Test]
    public void Only_tools_whose_filament_is_not_stated_get_that_of_the_material()
    {
        var toolpath = new SmallPrint().Print(20, 10, 0.2).Build().With(tools: [new ToolpathTool(null), new ToolpathTool(3)]);
        var volumes = PrintCheck.WithVolumes(toolpath, Setup).Tools.Select(t => t.VolumePerE).ToArray();
        Assert.That(volumes[0], Is.EqualTo(SmallPrint.FilamentArea).Within(1e-9));
        Assert.That(volumes[1], Is.EqualTo(3));
    }

    [Test]
    public void Where_a_head_comes_from_after_homing_is_not_checked()
    {
        int Found(bool homes)
        {
            var print = new SmallPrint(0, 0, 0);
            if (homes) print.Event(new HomeEvent());
            // 100 mm in X by 600 mm/s, where 500 are allowed.
            var builder = print.Print(100, 0, 0, 0, speed: 600);
            return SmallPrint.Find(builder.Build(), Setup, "limit.").Length;
        }

        Assert.That((Found(false), Found(true)), Is.EqualTo((1, 0)));
    }

    // 12 mm³/s by 2.595 mm/s are F155.7, which is written as F156.
    [TestCase(2.595, 0)]
    [TestCase(2.62, 1)]
    public void What_is_slowed_down_to_the_flow_that_is_possible_is_not_too_fast_in_the_file(double speed, int found)
    {
        var setup = SmallPrint.Setup(p => p with { MaxFlow = 12 });
        var print = new SmallPrint(10, 10, 0.3).Go(10, 12, 0.3).Print(60, 12, 0.3, 12 / 2.595, speed: speed);
        using var stream = new MemoryStream();
        var list = SafeWriter.Write(print.Build(), setup, stream, "a test").Diagnostics;
        Assert.That(list.Count(d => d.Code == CheckCodes.Flow), Is.EqualTo(found));
    }

    [Test]
    public void Round_beds_are_called_round()
    {
        string Outside(BedShape shape)
            => SmallPrint.Find(new SmallPrint(0, 0, 1).Go(500, 0, 1).Build(), SmallPrint.Setup(p => p with { BedShape = shape, Origin = BedOrigin.Center }),
                CheckCodes.Outside).Single().Message;

        Assert.That(Outside(BedShape.Round), Does.EndWith(", round. Move or scale the print."));
        Assert.That(Outside(BedShape.Rectangle), Does.Not.Contain("round"));
    }

    [Test]
    public void An_event_that_is_not_in_the_file_has_no_line()
    {
        var plan = new SmallPrint().Event(new FanEvent(1)).Print(20, 10, 0.2).Build();
        var place = new WrittenPlaces(plan, _ => null, new WrittenLines(), Setup.Printer).OfEvent(0);
        Assert.That((place.Line, place.Step), Is.EqualTo(((int?)null, (int?)0)));
    }

    // 0.4 mm and a thousandth of that for rounding.
    [TestCase(0.4 * 1.001, 0)]
    [TestCase(0.4 * 1.0011, 1)]
    public void A_layer_may_be_as_high_as_the_nozzle_is_wide(double thickness, int found)
    {
        var print = new SmallPrint(10, 10, thickness).InLayer(new Layer(0, thickness, thickness)).Print(30, 10, thickness, 0.4);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.Height), Has.Length.EqualTo(found));
    }

    // Where a file does not say how thick its layers are, the settings may be thicker than the nozzle.
    [Test]
    public void A_height_that_is_not_stated_is_not_that_of_a_layer()
    {
        var setup = Setup with { Settings = new PrintSettings { LayerHeight = 0.6 } };
        Assert.That(SmallPrint.Find(new SmallPrint(10, 10, 0.6).Print(30, 10, 0.6, 0.4).Build(), setup, CheckCodes.Height), Is.Empty);
    }

    // Heights of an extrusion in mm, nominal and filled: with a layer of 0.25 mm they are stated; else what is below counts, and roundness where nothing is.
    [TestCase(0.25, 0.45, 0.25, 0.25)]
    [TestCase(0, 0.45, 0.2, 0.2)]
    [TestCase(0, 8, 0.3, 0.5)]
    [TestCase(0.25, 8, 0.25, 0.25)]
    public void The_height_of_a_extrusion_is_stated_or_measured(double thickness, double z, double nominal, double filled)
    {
        const double Area = Math.PI / 16;
        var setup = Setup with { Settings = new PrintSettings { LayerHeight = 0.3, FirstLayerHeight = 0.3 } };
        var printed = new PrintedSoFar(setup);
        printed.Add(Extrusion(0.25, 0.25, 0.3), 0.25);
        printed.Add(new CheckedMove { Length = 100, Kind = MoveKind.Travel }, 0);
        printed.Advance(0);
        var extrusions = new ExtrusionCheck(setup, printed, new Findings(setup.Printer, _ => null, _ => null));
        var (a, b) = extrusions.Extrusion(Extrusion(z, thickness, Area));
        Assert.That(new[] { a, b }, Is.EqualTo(new[] { nominal, filled }).Within(1e-12));
    }

    // Half of the square of the thickness, and three nozzles: as much is still an extrusion of this layer.
    [TestCase(0.03125, true)]
    [TestCase(0.03124, false)]
    [TestCase(3 * 0.4 * 0.25, true)]
    [TestCase(3 * 0.4 * 0.2501, false)]
    public void A_layer_says_how_high_its_extrusions_are_where_they_may_be(double area, bool known)
    {
        var setup = SmallPrint.Setup(p => p with { CheckSeverities = new(ExtrusionCheck.Codes.Select(c => new CheckSeverity(c, null))) });
        var extrusions = new ExtrusionCheck(setup, new PrintedSoFar(setup), new Findings(setup.Printer, _ => null, _ => null));
        Assert.That(extrusions.Extrusion(Extrusion(8, 0.25, area)) == (0.25, 0.25), Is.EqualTo(known));
    }

    [Test]
    public void Material_in_place_on_a_tower_runs_down_its_sides()
    {
        var tower = new SmallPrint().Wall(60, 70, 60, 5).Over(65, 60, 5.2).Prime(9);
        Assert.That(SmallPrint.Find(tower.Build(), Setup, CheckCodes.Squeezed), Is.Empty);
    }

    [Test]
    public void Progress_is_heard_every_4096_moves()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 0; i < 9000; i++) builder.Add(new Vec3(i % 2, 0), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, i);
        var toolpath = builder.Build([new ToolpathTool(1)]);
        var heard = new List<int>();
        new CheckRun([], toolpath.Tools, default).Block(CheckRun.BlocksOf(toolpath).Single(), heard.Add);
        Assert.That(heard, Is.EqualTo(new[] { 0, 4096, 8192 }));
    }

    // The first part of the file is a check, the second is written; both report their share only.
    [TestCase(false)]
    [TestCase(true)]
    public void Progress_of_writing_ends_at_one(bool isDraft)
    {
        var progress = new Shares();
        var print = new SmallPrint();
        for (var i = 0; i < ToolpathBlock.Capacity + 100; i++) print.Go(i % 2 == 0 ? 60 : 10, 10 + 0.001 * i, 0.2);
        using var stream = new MemoryStream();
        var written = isDraft ? SafeWriter.Write(print.Build(), Setup, stream, "a test", progress, isDraft: true)
            : SafeWriter.Write(print.Build(), Setup, stream, "a test", progress);
        Assert.That(written.Value, Is.Not.Null);
        Assert.That(progress.All, Is.All.InRange(0, 1));
        Assert.That(progress.All.Last(), Is.EqualTo(1));
    }

    [Test]
    public void Whoever_brings_blocks_to_a_check_that_was_stopped_does_not_wait()
    {
        var toolpath = new SmallPrint().InLayer(new Layer(0, 0.2, 0.2)).Print(20, 10, 0.2).Build();
        var block = CheckRun.BlocksOf(toolpath).Single();
        using var cancel = new CancellationTokenSource();
        using var checks = new MoveChecks(Setup, toolpath.Tools, () => new Findings(Setup.Printer, toolpath), cancel.Token, 1);
        checks.Take(block);
        checks.Stop();
        for (var i = 0; i < 5; i++) checks.Take(block);
        cancel.Cancel();
        Assert.That(() => checks.Finish(toolpath, new CheckScope(200), null), Throws.InstanceOf<OperationCanceledException>());
    }

    private sealed class Seen : MoveCheck
    {
        public List<(bool Homes, bool Known)> All { get; } = [];

        public override IReadOnlyList<string> Codes => [];

        public override void Move(in CheckedMove move) => All.Add((move.IsHoming, move.StartKnown));
    }

    // 20 mm along X.
    private static CheckedMove Extrusion(double z, double thickness, double area) => new()
    {
        Start = new Vec3(10, 10, z), End = new Vec3(30, 10, z), Length = 20, Kind = MoveKind.Print, StartKnown = true, Deposited = 20 * area,
        Thickness = thickness,
    };

    // Where layers are not known yet, and where the file has other tools, the whole is looked at in the end.
    [Test]
    public void Blocks_may_be_checked_before_the_whole_is_known()
    {
        var toolpath = new SmallPrint(10, 10, 9).InLayer(new Layer(0, 9, 0.2)).Print(80, 10, 9).Build();
        var block = CheckRun.BlocksOf(toolpath).Single();
        string[] Found(Toolpath read, params DecodedBlock[] blocks)
        {
            using var checks = new MoveChecks(Setup, toolpath.Tools, () => new Findings(Setup.Printer, toolpath), default, 8);
            foreach (var each in blocks) checks.Take(each);
            return [.. checks.Finish(read, new CheckScope(200), null).Select(d => d.Code)];
        }

        Assert.That(Found(toolpath), Is.EqualTo(new[] { CheckCodes.InAir, CheckCodes.Unsupported }));
        Assert.That(Found(toolpath, block), Is.EqualTo(new[] { CheckCodes.InAir, CheckCodes.Unsupported }));
        Assert.That(Found(toolpath, block with { Thicknesses = null }), Is.EqualTo(new[] { CheckCodes.InAir, CheckCodes.Unsupported }));
        var other = toolpath.With(tools: [new ToolpathTool(1000)]);
        Assert.That(Found(other, block), Is.EqualTo(PrintCheck.Run(other, Setup).Select(d => d.Code)).And.Member(CheckCodes.Width), "other tools");
    }

    private static readonly Toolpath Empty = new ToolpathBuilder(MoveSource.Lines, null).Build([new ToolpathTool(1)]);

    private static Findings NewFindings(out Findings findings) => findings = new Findings(Setup.Printer, _ => null, _ => null);

    private static IReadOnlyList<Diagnostic> Stationary(params double[] pushed)
    {
        var findings = new Findings(Setup.Printer, _ => null, _ => null);
        var check = new ExtruderCheck(Setup, findings);
        foreach (var volume in pushed) check.Move(new CheckedMove { StartKnown = true, Kind = MoveKind.Prime, Pushed = volume });
        return findings.ToList();
    }
}

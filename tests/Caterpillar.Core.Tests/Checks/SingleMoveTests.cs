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
    [TestCase(new[] { -4.0, 12 }, "12 mm³ are pushed out")]
    [TestCase(new[] { 4.0, -12 }, "12 mm³ are pulled back")]
    [TestCase(new[] { 6.0, 6 }, "12 mm³ are pushed out")]
    [TestCase(new[] { -6.0, -6 }, "12 mm³ are pulled back")]
    [TestCase(new[] { -6.0, 8, 6 }, null)]
    [TestCase(new[] { 6.0, 0, 4 }, null)]
    [TestCase(new[] { 6.0, double.NaN, 6 }, null)]
    public void Material_in_place_counts_by_itself_and_together(double[] pushed, string? found)
    {
        var list = Stationary(pushed);
        Assert.That(list.Select(d => d.Message.Substring(0, d.Message.IndexOf(" while", StringComparison.Ordinal))),
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
        Assert.That(Stationary(Most, 1, 11).Single().Count, Is.EqualTo(2), "again for each lump");
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

    [Test]
    public void Round_beds_are_called_round()
    {
        string Outside(BedShape shape)
            => SmallPrint.Find(new SmallPrint(0, 0, 1).Go(500, 0, 1).Build(), SmallPrint.Setup(p => p with { BedShape = shape, Origin = BedOrigin.Center }),
                CheckCodes.Outside).Single().Message;

        Assert.That(Outside(BedShape.Round), Does.EndWith(", round."));
        Assert.That(Outside(BedShape.Rectangle), Does.Not.Contain("round"));
    }

    [Test]
    public void An_event_that_is_not_in_the_file_has_no_line()
    {
        var plan = new SmallPrint().Event(new FanEvent(1)).Print(20, 10, 0.2).Build();
        var place = new WrittenPlaces(plan, _ => null, new WrittenLines(plan.Count), Setup.Printer).OfEvent(0);
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

    [Test]
    public void Progress_is_heard_every_4096_moves()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 0; i < 9000; i++) builder.Add(new Vec3(i % 2, 0), 0, 0, 50, MoveKind.Travel, Role.Unspecified, -1, 0, i);
        var toolpath = builder.Build([new ToolpathTool(1)]);
        var heard = new List<int>();
        new CheckRun([], toolpath.Tools, default).Block(CheckRun.BlocksOf(toolpath, 0).Single(), heard.Add);
        Assert.That(heard, Is.EqualTo(new[] { 0, 4096, 8192 }));
    }

    // The first part of the file is a check, the second is written; both report their share only.
    [TestCase(false)]
    [TestCase(true)]
    public void Progress_of_writing_ends_at_one(bool isDraft)
    {
        var progress = new Shares();
        var print = new SmallPrint();
        for (var i = 0; i < 300; i++) print.Print(i % 2 == 0 ? 60 : 10, 10 + 0.4 * (i / 2), 0.2);
        using var stream = new MemoryStream();
        var written = isDraft ? SafeWriter.WriteDraft(print.Build(), Setup, stream, "a test", progress)
            : SafeWriter.Write(print.Build(), Setup, stream, "a test", progress);
        Assert.That(written.Value, Is.Not.Null);
        Assert.That(progress.All, Is.All.InRange(0, 1));
        Assert.That(progress.All.Last(), Is.EqualTo(1));
    }

    [Test]
    public void Whoever_brings_blocks_to_a_check_that_was_stopped_does_not_wait()
    {
        var toolpath = new SmallPrint().InLayer(new Layer(0, 0.2, 0.2)).Print(20, 10, 0.2).Build();
        var block = CheckRun.BlocksOf(toolpath, 0).Single();
        using var cancel = new CancellationTokenSource();
        using var follower = new DepositFollower(toolpath.Tools, Setup, 1, cancel.Token);
        cancel.Cancel();
        for (var i = 0; i < 5; i++) Assert.That(follower.Take(block), Is.True);
        Assert.That(() => follower.Finish(toolpath, null!, null), Throws.InstanceOf<OperationCanceledException>());
    }

    private static IReadOnlyList<Diagnostic> Stationary(params double[] pushed)
    {
        var findings = new Findings(Setup.Printer, _ => null, _ => null);
        var check = new StationaryCheck(Setup.Printer, findings);
        foreach (var volume in pushed) check.Move(new CheckedMove { StartKnown = true, Kind = MoveKind.Prime, Pushed = volume });
        return findings.ToList();
    }
}

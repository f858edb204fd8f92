using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Checks that are off do not run, and what the others find does not depend on them.</summary>
public sealed class SwitchedOffTests
{
    private static readonly Printer Strict = new()
    {
        StartGCode = ValueList<string>.Empty, EndGCode = ValueList<string>.Empty, MaxFlow = 5, MaxSpeed = new(45, 500, 500, 500),
        HeadBoxes = new(new Bounds(new Vec3(-25, -45, 8), new Vec3(50, 30, 60))), Gantry = new(new Bounds(new Vec3(0, 20, 30), new Vec3(0, 60, 60))),
        ExcludedAreas = new(new Bounds(new Vec3(150, 150), new Vec3(160, 160))), Clips = new(new Bounds(new Vec3(0, 100, 0), new Vec3(12, 110, 5))),
    };

    private static readonly Lazy<Toolpath> Bad = new(ManyFindings);
    private static readonly Lazy<Diagnostic[]> Expected = new(() => Written(Bad.Value, []));

    public static IEnumerable<string> Codes() => CheckCodes.All.Select(r => r.Code);

    [TestCaseSource(nameof(Codes))]
    public void A_check_that_is_off_changes_nothing_of_what_the_others_find(string code)
    {
        Assert.That(Expected.Value.Select(d => d.Code).Distinct().Count(), Is.GreaterThan(24));
        Assert.That(Written(Bad.Value, [code]), Is.EqualTo(Expected.Value.Where(d => d.Code != code)));
    }

    [TestCase("extrusion.", "first_layer.")]
    [TestCase("collision.", "nozzle.")]
    [TestCase("extrusion.", "first_layer.", "collision.", "nozzle.")]
    [TestCase("limit.")]
    [TestCase("file.")]
    [TestCase("bed.")]
    public void Checks_that_are_off_together_change_nothing_of_what_the_others_find(params string[] words)
    {
        bool IsOff(string code) => words.Any(w => code.StartsWith(w, StringComparison.Ordinal));
        Assert.That(Expected.Value.Select(d => d.Code).Where(IsOff), Is.Not.Empty);
        Assert.That(Written(Bad.Value, Codes().Where(IsOff)), Is.EqualTo(Expected.Value.Where(d => !IsOff(d.Code))));
    }

    [Test]
    public void The_file_is_the_same_where_all_checks_are_off()
    {
        var (plain, unread) = (new MemoryStream(), new MemoryStream());
        var print = new SmallPrint().Wall(60, 80, 50, 4).Build();
        var checkedFile = SafeWriter.Write(print, Off([]), plain, isDraft: true);
        var written = SafeWriter.Write(print, Off(Codes()), unread, isDraft: true);
        Assert.That((written.Value!.Bytes, written.Value.Lines), Is.EqualTo((checkedFile.Value!.Bytes, checkedFile.Value.Lines)));
        Assert.That((written.Value.PrintTime, checkedFile.Value.PrintTime is > 0), Is.EqualTo(((double?)null, true)), "read back, it is timed");
        Assert.That(unread.ToArray(), SameBytes.As(plain.ToArray()));
        Assert.That(SafeWriter.Write(Bad.Value, Off(Codes()), unread).Diagnostics, Is.Empty, "nothing is refused");
    }

    [Test]
    public void No_draft_is_written_where_nothing_is_looked_for()
    {
        PrintDraft? Begin(IEnumerable<string> off) => PrintDraft.Begin(new SmallPrint().Print(20, 10, 0.2).Build(), Off(off), default);
        Assert.That(Begin(Codes()), Is.Null);
        using var one = Begin(Codes().Where(c => c != CheckCodes.Unsupported));
        Assert.That(one, Is.Not.Null);
    }

    private static PrintSetup Off(IEnumerable<string> codes)
    {
        // The comments of the setup would name the codes.
        var printer = Strict with { CheckSeverities = new(codes.Select(c => new CheckSeverity(c, null))), SetupComments = false };
        return new PrintSetup(printer, new Material(), new PrintSettings());
    }

    private static Diagnostic[] Written(Toolpath toolpath, IEnumerable<string> off)
        => [.. SafeWriter.Write(toolpath, Off(off), new MemoryStream(), isDraft: true).Diagnostics.Where(d => d.Code != SafeWriter.Refused)];

    private static Toolpath ManyFindings()
    {
        var print = new SmallPrint(10, 10, 20).Event(new NozzleTemperatureEvent(500)).Event(new BedTemperatureEvent(300));
        print.Wall(60, 80, 50, 12).Go(70, 30, 200).Go(70, 30, 3).Print(70, 70, 3).Go(70, 70, 200).Go(70, 30, 200).Go(70, 30, 3).Go(70, 70, 3);
        print.Over(200, 10, 1).Over(50, 105, 3).Go(5, 105, 3).Over(200, 200, 0.2).Go(230, 200, 0.2).Go(200, 200, 0.2).Go(200, 200, -1).Go(200, 200, 30);
        print.Over(140, 155, 0.2).Print(170, 155, 0.2).Over(50, 150, 4).Print(60, 150, 4);
        print.Over(50, 160, 0.2).Print(100, 160, 0.2).Over(50, 160, 0.2).Print(100, 160, 0.2);
        print.Over(50, 170, 0.04).Print(70, 170, 0.04).Over(50, 180, 0.2).Print(60, 180, 0.2, 0.3);
        print.Over(100, 170, 0.2).Print(110, 170, 0.2).Go(110.5, 170, 0.2).Print(120, 170, 0.2);
        for (var k = 0; k < 5; k++) print.Over(100, 190 + 0.4 * k, 5 - 0.2 * k).Print(110, 190 + 0.4 * k, 5 - 0.2 * k);
        print.Over(150, 180, 0.6).InLayer(new Layer(0, 0.6, 0.6)).Print(160, 180, 0.6, 0.4).InLayer(new Layer(1, 0.2, 0.2));
        print.Over(150, 190, 0.2).Event(new AccelerationEvent(90_000)).Event(new RawEvent("M203 X900")).Print(160, 190, 0.2).Print(180, 190, 0.2, speed: 60);
        print.Prime(600).Event(new RawEvent("M221 S50")).Print(185, 190, 0.2).Event(new RawEvent("G91")).Event(new RawEvent("G1 X186\nG92 X185"));
        print.Print(180, 192, 0.2).Event(new NozzleTemperatureEvent(50)).Print(185, 192, 0.2);
        return print.Event(new ToolEvent(3)).Print(188, 192, 0.2, tool: 3).Build();
    }
}

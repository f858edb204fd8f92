using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>A small bad print or file for each code: it is found by name, as serious as the printer says, refused, and written with a reason.</summary>
public class CheckCodeTests
{
    private const string Reason = "a test of the machine";

    public static IEnumerable<string> Codes() => CheckCodes.All.Select(r => r.Code);

    [TestCaseSource(nameof(Codes))]
    public void Each_code_is_found_with_its_usual_severity(string code)
    {
        var list = Write(code, null, null).Diagnostics.Where(d => d.Code == code).ToArray();
        Assert.That(list.Select(d => d.Severity), Is.EqualTo(new[] { CheckCodes.Find(code)!.Severity }), code);
        Assert.That(list[0].Message, Has.Length.GreaterThan(20));
    }

    [TestCaseSource(nameof(Codes))]
    public void Each_code_refuses_where_it_is_an_error_and_a_reason_that_stays_as_a_comment_overrides_it(string code)
    {
        var refused = Write(code, "error", null);
        Assert.That(refused.Value, Is.Null);
        Assert.That(refused.Diagnostics.Where(d => d.Severity == Severity.Error).Select(d => d.Code), Has.Member(code).And.Member(SafeWriter.Refused));
        var written = Write(code, "error", Reason);
        Assert.That(written.Diagnostics.Where(d => d.Code == code).Select(d => d.Severity), Is.EqualTo(new[] { Severity.Warning }));
        var lines = Encoding.ASCII.GetString(written.Value!.ToBytes()).Split('\n');
        var at = Array.FindIndex(lines, l => l.IndexOf("Reason: " + Reason, StringComparison.Ordinal) >= 0);
        Assert.That(at, Is.InRange(0, 5));
        Assert.That(lines.Skip(at + 1).Take(8), Has.Some.StartsWith(";").And.Some.Contains("error " + code));
    }

    [TestCaseSource(nameof(Codes))]
    public void Each_code_can_be_a_note_or_off(string code)
    {
        var noted = Write(code, "note", Reason);
        Assert.That(noted.Value, Is.Not.Null);
        Assert.That(noted.Diagnostics.Where(d => d.Code == code).Select(d => d.Severity), Is.EqualTo(new[] { Severity.Note }));
        Assert.That(Write(code, "off", Reason).Diagnostics.Select(d => d.Code), Has.No.Member(code));
    }

    [TestCaseSource(nameof(Codes))]
    public void Each_code_is_found_where_all_others_are_off(string code)
    {
        var others = string.Concat(Codes().Where(c => c != code).Select(c => "," + c + "=off"));
        var expected = Write(code, "error", Reason).Diagnostics.Where(d => d.Code == code);
        Assert.That(Write(code, "error" + others, Reason).Diagnostics, Is.EqualTo(expected).And.Not.Empty);
    }

    // What is found beside the code, as an error, must not decide.
    private static Result<GCodeDocument> Write(string code, string? severity, string? reason)
    {
        var severities = severity is null ? "" : code + "=" + severity;
        PrintSetup Setup(Func<Printer, Printer>? change) => severity is null ? SmallPrint.Setup(change) : SmallPrint.Setup(change).With(
            "check_severities=" + severities).OrThrow();
        if (Files.TryGetValue(code, out var text))
        {
            var setup = Setup(null);
            var file = SmallPrint.Decode(Encoding.ASCII.GetBytes(text), setup);
            return SafeWriter.ToDocument(file, file.Toolpath, setup, reason ?? (severity is null ? Reason : null)) is var result
                && severity is null ? new Result<GCodeDocument>(result.Value, PrintCheck.Run(file, setup)) : result;
        }
        var (print, printer) = Prints(code);
        var own = Setup(printer);
        var toolpath = print.Build();
        if (severity is not null) return SafeWriter.ToDocument(toolpath, own, reason);
        return SafeWriter.ToDocument(toolpath, own);
    }

    private static readonly Dictionary<string, string> Files = new()
    {
        [CheckCodes.ExtrusionMode] = "G28\nM109 S200\nG90\nM83\nG1 X10 Y10 Z5\n"
            + string.Concat(Enumerable.Range(1, 20).Select(i => $"G1 X{10 + i} E{(i % 2 == 0 ? "-" : "")}0.1\n")) + "M104 S0\n",
        [CheckCodes.Starved] = "G28\nM109 S200\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X30 E0.6\nG1 X31 E-0.3\nG1 X60 E1\nM104 S0\n",
        [CheckCodes.NoHoming] = "M109 S200\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 E0.3\nM104 S0\n",
        [CheckCodes.NoHeating] = "G28\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 E0.3\n",
        [CheckCodes.UnknownPosition] = "G28 X Z\nM109 S200\nM83\nG1 X10 Z0.2 F3000\nG1 X20 E0.3\nM104 S0\n",
        [CheckCodes.UnknownCommand] = "MY_START\nG28\nM109 S200\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 E0.3\nM104 S0\n",
        [CheckCodes.HeatLeftOn] = "G28\nM109 S200\nM83\nG1 X10 Y10 Z0.2 F3000\nG1 X20 E0.3\n",
    };

    private static (SmallPrint Print, Func<Printer, Printer>? Printer) Prints(string code) => code switch
    {
        CheckCodes.Outside => (new SmallPrint().Go(230, 10, 0.2), null),
        CheckCodes.FileExtrusion => (At(80, 60, 0.2).Print(100, 60, 0.2).Event(new RawEvent("M221 S50")).Print(120, 60, 0.2), null),
        CheckCodes.Below => (new SmallPrint().Go(20, 10, -1), null),
        CheckCodes.AxisRange => (At(10, 10, 0.2).Go(30, 10, 0.2), p => p with
        {
            RotaryAxes = new(new RotaryAxis(RotaryWord.C, true, PathAxis.Z, Vec3.Zero)),
            SlideRange = new(new Bounds(Vec3.Zero, new Vec3(20, 200, 200))),
        }),
        CheckCodes.ExcludedArea => (At(80, 60, 0.2).Print(130, 60, 0.2),
            p => p with { ExcludedAreas = new(new Bounds(new Vec3(100, 50), new Vec3(120, 70))) }),
        CheckCodes.NozzleHits => (Wall().Go(70, 30, 200).Go(70, 30, 3).Print(70, 70, 3), null),
        CheckCodes.TravelHits => (Wall().Go(70, 30, 200).Go(70, 30, 3).Go(70, 70, 3), null),
        CheckCodes.HeadHits => (Wall(12).Go(70, 30, 200).Go(70, 30, 1),
            p => p with { HeadBoxes = new(new Bounds(new Vec3(-25, -45, 8), new Vec3(50, 30, 60))) }),
        CheckCodes.GantryHits => (Wall(12).Go(200, 10, 200).Go(200, 10, 1),
            p => p with { Gantry = new(new Bounds(new Vec3(0, 20, 8), new Vec3(0, 60, 60))) }),
        CheckCodes.ClipHit => (new SmallPrint(50, 105, 10).Go(50, 105, 3).Go(5, 105, 3),
            p => p with { Clips = new(new Bounds(new Vec3(0, 100, 0), new Vec3(12, 110, 5))) }),
        CheckCodes.Slope => (Stairs(), null),
        CheckCodes.Unsupported => (At(50, 50, 0.2).Print(60, 50, 0.2).Go(60, 50, 4).Print(70, 50, 4), null),
        CheckCodes.InAir => (At(50, 50, 4).Print(60, 50, 4), null),
        CheckCodes.Duplicate => (At(50, 50, 0.2).Print(100, 50, 0.2).Go(100, 50, 5).Go(50, 50, 0.2).Print(100, 50, 0.2), null),
        CheckCodes.TooLow => (At(50, 50, 0.01).Print(70, 50, 0.01), null),
        CheckCodes.Blob => (At(50, 50, 0.2).Print(70, 50, 0.2).Go(100, 100, 0.2).Prime(11), null),
        CheckCodes.Squeezed => (At(50, 50, 0.1).Print(70, 50, 0.1), null),
        CheckCodes.Width => (At(50, 50, 0.2).Print(60, 50, 0.2, 0.3), null),
        CheckCodes.Height => (At(50, 50, 0.6).InLayer(new Layer(0, 0.6, 0.6)).Print(60, 50, 0.6, 0.4), null),
        CheckCodes.Gap => (At(50, 50, 0.2).Print(60, 50, 0.2).Go(60.5, 50, 0.2).Print(70, 50, 0.2), null),
        CheckCodes.FirstLayer => (Wall(25), null),
        CheckCodes.Flow => (At(10, 10, 0.2).Print(30, 10, 0.2), p => p with { MaxFlow = 1 }),
        CheckCodes.Speed => (At(10, 10, 0.2).Print(30, 10, 0.2), p => p with { MaxSpeed = new(40, 40, 40, 40) }),
        CheckCodes.TravelSpeed => (At(10, 10, 0.2).Go(30, 10, 0.2).Print(40, 10, 0.2), p => p with { MaxSpeed = new(40, 500, 500, 500) }),
        CheckCodes.Acceleration => (new SmallPrint().Event(new AccelerationEvent(90_000)).Print(30, 10, 0.2), null),
        CheckCodes.Raised => (At(10, 10, 0.2).Print(20, 10, 0.2).Event(new RawEvent("M203 X900")).Print(30, 10, 0.2), null),
        CheckCodes.Tool => (new SmallPrint().Event(new ToolEvent(3)).Print(30, 10, 0.2, tool: 3), null),
        CheckCodes.NozzleTemperature => (new SmallPrint().Event(new NozzleTemperatureEvent(500)).Print(30, 10, 0.2), null),
        CheckCodes.BedTemperature => (new SmallPrint().Event(new BedTemperatureEvent(300)).Print(30, 10, 0.2), null),
        CheckCodes.ChamberTemperature => (new SmallPrint().Event(new ChamberTemperatureEvent(90)).Print(30, 10, 0.2), null),
        CheckCodes.Stationary => (At(10, 10, 0.2).Print(30, 10, 0.2).Go(30, 10, 50).Prime(600), null),
        CheckCodes.Amount => (At(10, 10, 0.2).Print(30, 10, 0.2, 30), null),
        CheckCodes.ColdExtrusion => (new SmallPrint().Event(new NozzleTemperatureEvent(50)).Print(30, 10, 0.2), null),
        CheckCodes.FilePosition => (At(10, 10, 0.2).Print(30, 10, 0.2).Event(new RawEvent("G1 X40\nG92 X30")).Print(60, 10, 0.2), null),
        CheckCodes.FileModes => (At(10, 10, 0.2).Print(30, 10, 0.2).Event(new RawEvent("G91")).Print(60, 10, 0.2), null),
        CheckCodes.UnsafeCommand => (At(10, 10, 0.2).Print(30, 10, 0.2).Event(new RawEvent("M302 S0")).Print(60, 10, 0.2), null),
        CheckCodes.UnverifiedCommand => (At(10, 10, 0.2).Print(30, 10, 0.2).Event(new RawEvent("MY_MACRO")).Print(60, 10, 0.2), null),
        CheckCodes.PauseCommand => (At(10, 10, 0.2).Print(30, 10, 0.2).Event(new RawEvent("M600")).Print(60, 10, 0.2), null),
        CheckCodes.MachineCommand => (At(10, 10, 0.2).Print(30, 10, 0.2).Event(new RawEvent("M42 P4 S1")).Print(60, 10, 0.2), null),
        CheckCodes.SettingCommand => (At(10, 10, 0.2).Print(30, 10, 0.2).Event(new RawEvent("M500")).Go(30, 10, 20), null),
        _ => throw new ArgumentOutOfRangeException(nameof(code), code, "No print for this code."),
    };

    // Where the head comes from is not known: only the second move of a file is looked at.
    private static SmallPrint At(double x, double y, double z) => new SmallPrint(x, y, 20).Go(x, y, z);

    private static SmallPrint Wall(double top = 4) => new SmallPrint().Wall(60, 80, 50, top);

    private static SmallPrint Stairs()
    {
        var print = At(150, 150, 0.2).Print(160, 150, 0.2).Over(50, 50, 100);
        for (var k = 0; k < 5; k++) print.Go(50, 50 + 0.4 * k, 5 - 0.2 * k).Print(60, 50 + 0.4 * k, 5 - 0.2 * k).Go(60, 50 + 0.4 * k, 100)
            .Go(50, 50 + 0.4 * k + 0.4, 100);
        return print;
    }
}

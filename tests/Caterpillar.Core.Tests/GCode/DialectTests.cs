using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;
using Decoder = Caterpillar.GCode.Decoder;

namespace Caterpillar.Tests.GCode;

/// <summary>Small programs and what each firmware makes of them, from its source (see docs/gcode.md).</summary>
public class DialectTests
{
    private const string All = "slicer marlin1 marlin2 prusa bambu klipper reprapfirmware repetier smoothie";

    // The sum of E of two moves that both say E1: 2 where E is relative, 1 where it is absolute.
    [TestCase("G90 M83", "slicer marlin1 marlin2 prusa bambu klipper reprapfirmware repetier smoothie", "cnc")]
    [TestCase("M83 G90", "slicer marlin1 prusa bambu klipper reprapfirmware repetier", "marlin2 smoothie cnc")]
    [TestCase("G91", "slicer marlin1 marlin2 bambu klipper repetier smoothie cnc", "prusa reprapfirmware")]
    [TestCase("G91 M82", "slicer marlin1 bambu klipper repetier cnc", "marlin2 smoothie prusa reprapfirmware")]
    [TestCase("M82 G91", "slicer marlin1 marlin2 bambu klipper repetier smoothie cnc", "prusa reprapfirmware")]
    [TestCase("M83 G91", All + " cnc", "")]
    [TestCase("G91 M83 G90 M82", "", All + " cnc")]
    [TestCase("M83 G90 M83", All, "cnc")]
    [TestCase("", "", All + " cnc")]
    public void Modes_of_E(string modes, string relative, string absolute)
    {
        var program = string.Concat(modes.Split([' '], StringSplitOptions.RemoveEmptyEntries).Select(m => m + "\n")) + "G1 X10 E1\nG1 X20 E1\n";
        foreach (var name in Names(relative)) Assert.That(Decode(program, name).Report.ENet, Is.EqualTo(2), name);
        foreach (var name in Names(absolute)) Assert.That(Decode(program, name).Report.ENet, Is.EqualTo(1), name);
    }

    [Test]
    public void The_order_of_modes_is_reported_where_firmwares_differ()
    {
        foreach (var program in new[] { "M83\nG90\n", "G91\nM82\n", "G91\n" })
            Assert.That(Codes(program + "G1 X1 E1\nG1 X2 E1\n", "marlin2"), Does.Contain("gcode.dialect_e_mode"), program);
        foreach (var program in new[] { "G90\nM83\n", "M82\n", "G91\nM83\n", "" })
            Assert.That(Codes(program + "G1 X1 E1\nG1 X2 E1\n", "marlin2"), Does.Not.Contain("gcode.dialect_e_mode"), program);
    }

    // Machine X at the end, and the sum of E.
    [TestCase("G1 X10 E1\nG92\nG1 X15 E1\n", 15, 1, "marlin1 marlin2 prusa reprapfirmware repetier sailfish")]
    [TestCase("G1 X10 E1\nG92\nG1 X15 E1\n", 25, 2, "slicer bambu klipper")]
    [TestCase("G1 X10 E1\nG92\nG1 X15 E1\n", 15, 2, "smoothie")]
    [TestCase("G1 X10\nG92 X0\nG1 X5 E1\nG92\nG1 X1 E2\n", 11, 2, "marlin1 marlin2 prusa reprapfirmware repetier sailfish")]
    [TestCase("G1 X10\nG92 X0\nG1 X5 E1\nG92\nG1 X1 E2\n", 16, 3, "slicer bambu klipper")]
    [TestCase("G1 X10\nG92 X0\nG1 X5 E1\nG92\nG1 X1 E2\n", 1, 3, "smoothie")]
    public void Bare_G92(string program, double x, double e, string dialects)
    {
        foreach (var name in Names(dialects))
        {
            var decoding = Decode(program, name);
            Assert.That(End(decoding).X, Is.EqualTo(x), name);
            Assert.That(decoding.Report.ENet, Is.EqualTo(e), name);
        }
        Assert.That(Codes(program, "marlin2"), Does.Contain("gcode.dialect_g92"));
    }

    [Test]
    public void G92_names_a_place_and_the_head_stays()
    {
        foreach (var name in Names(All + " sailfish cnc grbl"))
        {
            var decoding = Decode("G1 X10 Y5\nG92 X0 Y1\nG1 X5\nG1 Y2\n", name);
            Assert.That(End(decoding).X, Is.EqualTo(15), name);
            Assert.That(End(decoding).Y, Is.EqualTo(6), name);
            Assert.That(decoding.Report.EndPosition, Is.EqualTo(new Caterpillar.Geometry.Vec3(5, 2, 0)), name);
        }
    }

    [Test]
    public void Before_an_axis_is_known_G92_says_where_it_is()
    {
        var decoding = Decode("G92 X100 Y50 Z0\nG1 X110\n", "marlin2");
        Assert.That(decoding.Toolpath.Start, Is.EqualTo(new Caterpillar.Geometry.Vec3(100, 50, 0)));
        Assert.That(End(decoding), Is.EqualTo(new Caterpillar.Geometry.Vec3(110, 50, 0)));
    }

    [TestCase("slicer marlin1 marlin2 prusa reprapfirmware repetier smoothie cnc grbl", 25.4)]
    [TestCase("klipper", 1)]
    public void Inches(string dialects, double x)
    {
        foreach (var name in Names(dialects)) Assert.That(End(Decode("G20\nG1 X1 E1\n", name)).X, Is.EqualTo(x), name);
        if (x == 1) Assert.That(Codes("G20\nG1 X1\n", dialects), Does.Contain("gcode.inches"));
    }

    [Test]
    public void Homing_is_a_way_to_zero_of_the_named_axes()
    {
        foreach (var name in Names(All))
        {
            var decoding = Decode("G1 X10 Y10 Z5\nG28 X\nG1 X3 Y4 Z5\n", name);
            var moves = decoding.Toolpath.Moves().ToArray();
            Assert.That(moves[1].End, Is.EqualTo(new Caterpillar.Geometry.Vec3(0, 10, 5)), name);
            Assert.That(decoding.Toolpath.Events.Single(), Is.EqualTo(new MoveEvent(1, new HomeEvent(true, false, false))), name);
            Assert.That(decoding.Report.TravelSegments, Is.EqualTo(2), "homing is no move of the file's own");
        }
    }

    // Print length of a half circle of radius 5, in absolute or relative mode, by I J or R.
    [TestCase("G3 X0 Y10 I0 J5 E1", All + " cnc grbl", "sailfish bfb")]
    [TestCase("G3 X0 Y10 R5 E1", "slicer marlin1 marlin2 bambu reprapfirmware repetier cnc", "klipper smoothie prusa sailfish")]
    [TestCase("G91\nG3 X0 Y10 I0 J5 E1", "slicer marlin1 marlin2 prusa bambu reprapfirmware repetier smoothie cnc", "klipper sailfish")]
    public void Half_circles(string arc, string drawn, string refused)
    {
        foreach (var name in Names(drawn))
        {
            var decoding = Decode(arc + "\n", name);
            Assert.That(decoding.Report.PrintLength + decoding.Report.TravelLength, Is.EqualTo(5 * Math.PI).Within(1e-9), name);
        }
        foreach (var name in Names(refused))
        {
            Assert.That(Decode(arc + "\n", name).Toolpath.Count, Is.Zero, name);
            Assert.That(Codes(arc + "\n", name), Does.Contain("gcode.arc_refused"), name);
        }
    }

    [TestCase("slicer marlin1 marlin2 prusa bambu smoothie sailfish", 3)]
    [TestCase("klipper reprapfirmware repetier", 1)]
    public void P_of_an_arc_counts_turns(string dialects, int turns)
    {
        foreach (var name in Names(dialects).Where(n => DialectTable.Find(n)!.Arcs && n != "smoothie"))
            Assert.That(Decode("G3 X0 Y0 I5 J0 P3\n", name).Report.TravelLength, Is.EqualTo(10 * Math.PI * turns).Within(1e-9), name);
    }

    [TestCase("G4 P2", 0.002, "slicer marlin1 marlin2 prusa klipper reprapfirmware smoothie sailfish")]
    [TestCase("G4 P2", 2, "cnc grbl")]
    [TestCase("G4 S2", 2, "slicer marlin1 marlin2 prusa reprapfirmware smoothie")]
    [TestCase("G4 S2", 0, "klipper cnc grbl")]
    [TestCase("G4 S1 P500", 1, "marlin2")]
    [TestCase("G4 S1 P500", 0.5, "klipper")]
    public void Dwell(string program, double seconds, string dialects)
    {
        foreach (var name in Names(dialects))
            Assert.That(Decode(program + "\n", name).Toolpath.Events.Select(e => e.Event).OfType<DwellEvent>().Sum(d => d.Seconds), Is.EqualTo(seconds), name);
    }

    [TestCase("M0", "slicer marlin1 marlin2 prusa bambu reprapfirmware cnc grbl", "klipper smoothie")]
    [TestCase("M226", "reprapfirmware", "klipper cnc")]
    [TestCase("M601", "prusa reprapfirmware", "marlin2 klipper")]
    [TestCase("PAUSE", "klipper", "marlin2 prusa")]
    [TestCase("M400 U1", "bambu", "marlin2")]
    [TestCase("M400", "", "bambu marlin2")]
    public void Pauses(string program, string waits, string goesOn)
    {
        foreach (var name in Names(waits)) Assert.That(Decode(program + "\n", name).Toolpath.Events.Select(e => e.Event), Has.Some.InstanceOf<PauseEvent>(), name);
        foreach (var name in Names(goesOn)) Assert.That(Decode(program + "\n", name).Toolpath.Events.Select(e => e.Event), Has.None.InstanceOf<PauseEvent>(), name);
    }

    [TestCase("slicer cnc grbl", 10, 1)]
    [TestCase("marlin1 marlin2 prusa klipper reprapfirmware smoothie repetier", 5, 0.5)]
    public void Factors_of_speed_and_flow(string dialects, double speed, double deposited)
    {
        foreach (var name in Names(dialects))
        {
            var move = Decode("M220 S50\nM221 S50\nG1 X10 E1 F600\n", name).Toolpath[0];
            Assert.That(move.Speed, Is.EqualTo(speed), name);
            Assert.That(move.E, Is.EqualTo(move.Kind == MoveKind.Travel ? 0 : 1), name);
            if (move.Kind == MoveKind.Print && name != "grbl") Assert.That(move.Deposited, Is.EqualTo(deposited), name);
        }
    }

    [TestCase("slicer smoothie cnc grbl", 2)]
    [TestCase("marlin1 marlin2 prusa klipper reprapfirmware repetier sailfish", 1)]
    public void Axis_words_without_G(string dialects, int moves)
    {
        foreach (var name in Names(dialects)) Assert.That(Decode("G1 X10\nX20\n", name).Toolpath.Count, Is.EqualTo(moves), name);
        if (moves == 1) Assert.That(Codes("G1 X10\nX20\n", "marlin2"), Does.Contain("gcode.dialect_modal"));
    }

    [TestCase("slicer marlin1 marlin2 prusa smoothie repetier", -4)]
    [TestCase("klipper reprapfirmware", 1)]
    public void The_position_of_E_is_shared_or_each_tools_own(string dialects, double change)
    {
        foreach (var name in Names(dialects)) Assert.That(Decode("G1 X1 E5\nT1\nG1 X2 E1\n", name).Toolpath[1].E, Is.EqualTo(change), name);
    }

    [TestCase("marlin2", "T1", 1)]
    [TestCase("cnc", "T1", 0)]
    [TestCase("cnc", "T1\nM6", 1)]
    [TestCase("cnc", "M6 T1", 1)]
    [TestCase("bambu", "T255", 0)]
    [TestCase("klipper", "ACTIVATE_EXTRUDER EXTRUDER=extruder1", 1)]
    [TestCase("marlin2", "M104 T1 S200", 0)]
    public void Tool_changes(string dialect, string program, int tool)
        => Assert.That(Decode(program + "\nG1 X1 E1\n", dialect).Toolpath[0].Tool, Is.EqualTo(tool));

    [TestCase("marlin2", "M106 S127.5", 0.5)]
    [TestCase("marlin2", "M106 S1", 1 / 255.0)]
    [TestCase("reprapfirmware", "M106 S0.5", 0.5)]
    [TestCase("reprapfirmware", "M106 S255", 1)]
    [TestCase("marlin2", "M106", 1)]
    [TestCase("marlin2", "M107", 0)]
    public void Fans(string dialect, string program, double speed)
        => Assert.That(Decode(program + "\n", dialect).Toolpath.Events.Single().Event, Is.EqualTo(new FanEvent(speed)));

    [Test]
    public void Retraction_is_balanced_for_each_tool()
    {
        var decoding = Decode("M83\nG1 X10 E1\nG1 E-2\nG1 X20\nG1 X21 E0.5\nG1 E2\nG1 X30 E1\nG1 X29 E-0.5\nT1\nG1 X28 E1\nT0\nG1 E0.5\n", "marlin2");
        Assert.That(decoding.Toolpath.Moves().Select(m => m.Kind), Is.EqualTo(new[]
        {
            MoveKind.Print, MoveKind.Retract, MoveKind.Travel, MoveKind.MovingRestore, MoveKind.Restore, MoveKind.Print, MoveKind.Wipe, MoveKind.Print, MoveKind.Restore,
        }));
        Assert.That(decoding.Toolpath[4].Deposited, Is.EqualTo(0.5).Within(1e-12), "more is pushed than was pulled");
        Assert.That(Decode("M83\nG1 E3\nG1 X1 E1\n", "marlin2").Toolpath[0].Kind, Is.EqualTo(MoveKind.Prime));
    }

    [Test]
    public void Volumes_need_M200_or_the_firmware_for_it()
    {
        Assert.That(Decode("M200 D1.75\nG1 X1 E1\n", "marlin2").Toolpath.Tools[0].VolumePerE, Is.EqualTo(1));
        Assert.That(Decode("M200 D1.75\nG1 X1 E1\n", "klipper").Toolpath.Tools[0].VolumePerE, Is.Null);
        Assert.That(Decode("G1 X1 E1\n", "ultigcode").Toolpath.Tools[0].VolumePerE, Is.EqualTo(1));
        Assert.That(Decode("G1 X1 E1\n; filament_diameter = 2\n", "marlin2").Toolpath.Tools[0].VolumePerE, Is.EqualTo(Math.PI).Within(1e-12));
    }

    [TestCase("; generated by PrusaSlicer 2.5\nG1 X1 E1\n; gcode_flavor = marlin2\n", "marlin2")]
    [TestCase(";FLAVOR:Griffin\nG1 X1 E1\n", "marlin1")]
    [TestCase(";FLAVOR:UltiGCode\nG1 X1 E1\n", "ultigcode")]
    [TestCase("; gcode_flavor = reprapfirmware\nG1 X1 E1\n", "reprapfirmware")]
    [TestCase("START_PRINT\nG1 X1 E1\n", "klipper")]
    [TestCase("M862.3 P \"MK3S\"\nG1 X1 E1\n", "prusa")]
    [TestCase("; BambuStudio 1.9\nG1 X1 E1\n", "bambu")]
    [TestCase("M103\nM101\nG1 X1\n", "bfb")]
    [TestCase("G1 X1 A1\n", "cnc")]
    [TestCase("G1 X1 A1\nG1 X2 B1\n", "sailfish")]
    [TestCase("G0 X1\nM3 S1000\nG1 X1\nM5\n", "grbl")]
    public void Files_say_what_they_are_for(string program, string dialect)
    {
        var decoding = Decoder.Decode(Encoding.ASCII.GetBytes(program)).Value!;
        Assert.That(decoding.Dialect.Name, Is.EqualTo(dialect));
        Assert.That(decoding.Evidence, Is.Not.Empty);
    }

    [Test]
    public void Without_evidence_it_is_Marlin_2_and_a_remark_says_so()
    {
        var result = Decoder.Decode(Encoding.ASCII.GetBytes("G1 X1 E1\n"));
        Assert.That(result.Value!.Dialect.Name, Is.EqualTo("marlin2"));
        Assert.That(result.Diagnostics.Select(d => d.Code), Does.Contain("gcode.dialect_default"));
    }

    [Test]
    public void The_end_of_a_stream_is_looked_at_first_where_that_can_be_done()
    {
        var text = new StringBuilder("G21\nG90\nM83\n");
        for (var i = 0; i < 20_000; i++) text.Append("G1 X").Append(i % 7).Append(" Y").Append(i % 5).Append(" E0.1\n");
        var bytes = Encoding.ASCII.GetBytes(text.Append("; gcode_flavor = klipper\n").ToString());
        using var plain = new MemoryStream(bytes);
        var decoding = Decoder.DecodeStream(plain).Value!;
        Assert.That(decoding.Dialect.Name, Is.EqualTo("klipper"));
        Assert.That(decoding.Report.Bytes, Is.EqualTo(bytes.Length));
        using var memory = new MemoryStream();
        using (var packed = new System.IO.Compression.GZipStream(memory, System.IO.Compression.CompressionMode.Compress, true)) packed.Write(bytes, 0, bytes.Length);
        memory.Position = 0;
        var unpacked = Decoder.DecodeStream(memory).Value!;
        Assert.That(unpacked.Dialect.Name, Is.EqualTo("klipper"));
        Assert.That(unpacked.Toolpath.Count, Is.EqualTo(decoding.Toolpath.Count));
    }

    [Test]
    public void The_manual_is_current()
    {
        var file = Path.Combine(TestData.Repository, "docs", "gcode.md");
        if (Environment.GetEnvironmentVariable("CATERPILLAR_RENEW") == "1") File.WriteAllText(file, DialectManual.Write());
        Assert.That(File.ReadAllText(file), Is.EqualTo(DialectManual.Write()), "set CATERPILLAR_RENEW=1 and run this test to renew it");
    }

    private static string[] Names(string names) => names.Split([' '], StringSplitOptions.RemoveEmptyEntries);

    private static Decoding Decode(string program, string dialect)
        => Decoder.Decode(Encoding.ASCII.GetBytes(program), new DecodeOptions { Dialect = DialectTable.Find(dialect)! }).Value!;

    private static IEnumerable<string> Codes(string program, string dialect)
        => Decoder.Decode(Encoding.ASCII.GetBytes(program), new DecodeOptions { Dialect = DialectTable.Find(dialect)! }).Diagnostics.Select(d => d.Code);

    private static Caterpillar.Geometry.Vec3 End(Decoding decoding) => decoding.Toolpath[decoding.Toolpath.Count - 1].End;
}

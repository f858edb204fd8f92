using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Simulation;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode.Flavors;

/// <summary>G10 and G11 by the settings of the file: length, speed and lift.</summary>
public class FirmwareRetractionTests
{
    private const double Exact = 1e-9;

    private const string Sources = """
        slicer: GCodeProcessor.cpp reads no settings of the retraction
        marlin2: feature/fwretract.cpp, retract (current_hop)
        marlin1: as Marlin 2
        prusa: Marlin_main.cpp, retract (retract_zlift)
        bambu: no M207
        klipper: extras/firmware_retraction.py: no lift
        reprapfirmware: GCodes.cpp, RetractFilament (actualZHop); Tools/Tool.cpp, SetFirmwareRetraction
        repetier: M207 is the jerk
        smoothie: Extruder.cpp: lifts by a move, which is not followed
        sailfish: no G10
        cnc: G10 is something else
        ultigcode: Marlin_main.cpp, case 10: no lift
        bfb: no G10
        grbl: G10 is something else
        """;

    // Z of the machine at the end.
    private const string Heights = """
        |                                slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        M207 Z0.5;G1 Z5;G10;G1 X1            | 5  5.5 5.5 5.5 5 5 5.5 5 5 5 5 5 5 5
        M207 Z0.5;G1 Z5;G10;G10;G1 X1        | 5  5.5 5.5 5.5 5 5 5.5 5 5 5 5 5 5 5
        M207 Z0.5;G1 Z5;G10;G1 X1 Z2;G1 X3   | 2  2.5 2.5 2.5 2 2 2.5 2 2 2 2 2 2 2
        M207 Z0.5;G1 Z5;G10;G11;G1 X1        | 5  5   5   5   5 5 5   5 5 5 5 5 5 5
        M207 Z0.5;G1 Z5;G11;G1 X1            | 5  5   5   5   5 5 5   5 5 5 5 5 5 5
        M207 Z0.5;G1 Z5;G10;G28 Z;G11;G1 Z1  | 1  1   1   1   1 1 1   1 1 1 1 1 1 1
        G1 Z5;G10;M207 Z0.5;G10;G1 X1        | 5  5   5   5   5 5 5   5 5 5 5 5 5 5
        """;

    private static readonly Printer Rigid = new()
    {
        Cornering = Cornering.Jerk,
        MaxSpeed = new(500, 500, 10, 50),
        MaxAcceleration = new(5000, 5000, 100, 5000),
        Jerk = new(0, 0, 0, 0),
        PrintAcceleration = 1000,
        TravelAcceleration = 2000,
        RetractionAcceleration = 1500,
        LookaheadMoves = 0,
    };

    private static IEnumerable<TestCaseData> HeightCases() => ProgramTable.Cases(Heights, Sources);

    [TestCaseSource(nameof(HeightCases))]
    public void G10_lifts_the_head_as_the_firmware_does(string program, string flavor, string z, string source)
    {
        var toolpath = ProgramTable.Decode(program, flavor).Toolpath;
        Assert.That(ProgramTable.Text(toolpath[toolpath.Count - 1].End.Z), Is.EqualTo(z), source);
    }

    [Test]
    public void The_lift_follows_the_retraction_and_comes_back_before_the_deretraction()
    {
        var decoding = ProgramTable.Decode("M207 Z0.5;G1 X1 Z5 F600;G10;G1 X2;G11;G1 X3", "marlin2");
        Assert.That(decoding.Toolpath.Moves().Select(m => (m.Kind, m.End.Z)), Is.EqualTo(new[]
        {
            (MoveKind.Travel, 5), (MoveKind.Retract, 5), (MoveKind.Travel, 5.5), (MoveKind.Travel, 5.5), (MoveKind.Travel, 5), (MoveKind.Deretract, 5),
            (MoveKind.Travel, 5.0),
        }));
        Assert.That(decoding.Report.EndPosition.Z, Is.EqualTo(5));
    }

    // 10 mm at 100 mm/s, 3 mm at 30 mm/s, and 3.5 mm at 15 mm/s.
    [TestCase("marlin2", "M207 S3 F1800\nM208 S0.5 F900")]
    [TestCase("marlin1", "M207 S3 F1800\nM208 S0.5 F900")]
    [TestCase("prusa", "M207 S3 F1800\nM208 S0.5 F900")]
    [TestCase("smoothie", "M207 S3 F1800\nM208 S0.5 F900")]
    [TestCase("ultigcode", "M207 S3 F1800\nM208 S0.5 F900")]
    [TestCase("reprapfirmware", "M207 S3 R0.5 F1800 T900")]
    [TestCase("reprapfirmware", "M207 P0 S3 R0.5 F1800 T900\nM207 P1 S9 R9 F60")]
    [TestCase("klipper", "SET_RETRACTION RETRACT_LENGTH=3 RETRACT_SPEED=30 UNRETRACT_EXTRA_LENGTH=0.5 UNRETRACT_SPEED=15")]
    public void The_length_and_the_speeds_are_those_that_the_file_sets(string flavor, string settings)
    {
        double[] expected = [0.15, 2 * 30 / 1500.0 + (3 - 900 / 1500.0) / 30, 2 * 15 / 1500.0 + (3.5 - 225 / 1500.0) / 15];
        Assert.That(Times(flavor, settings + "\nG1 X10 F6000\nG10\nG11"), Is.EqualTo(expected).Within(Exact));
    }

    [Test]
    public void One_speed_of_RepRapFirmware_is_for_both_ways()
        => Assert.That(Times("reprapfirmware", "M207 S3 F1800\nG1 X10 F6000\nG10\nG11").Skip(1).Distinct().Count(), Is.EqualTo(1));

    // 0.5 mm with 100 mm/s², limited by nothing: 2 √(0.5 / 100) s.
    [Test]
    public void The_lift_takes_its_time()
        => Assert.That(Times("marlin2", "M207 S3 F1800 Z0.5\nG1 X10 F6000\nG10\nG1 X20\nG11")[2], Is.EqualTo(2 * Math.Sqrt(0.5 / 100)).Within(Exact));

    [TestCase("marlin2", "M207 S5", 1)]
    [TestCase("marlin2", "M208 S5", 1)]
    [TestCase("prusa", "M207 S5", 1)]
    [TestCase("smoothie", "M207 S5", 1)]
    [TestCase("reprapfirmware", "M207 S5", 1)]
    [TestCase("klipper", "SET_RETRACTION RETRACT_LENGTH=5", 1)]
    [TestCase("klipper", "M207 S5", 0)]
    [TestCase("repetier", "M207 X5", 0)]
    public void A_change_between_G10_and_G11_is_named(string flavor, string line, int warnings)
    {
        int Count(string program) => ProgramTable.Run(program, flavor).Diagnostics.Count(d => d.Code == "gcode.retraction_changed");
        Assert.That(Count($"G1 X10;G10;{line};G11"), Is.EqualTo(warnings));
        Assert.That(Count($"G1 X10;{line};G10;G11;{line}"), Is.Zero);
    }

    [Test]
    public void G11_of_Klipper_does_nothing_after_a_change()
    {
        var all = Times("klipper", "G1 X10 F6000\nG10\nG11");
        Assert.That(Times("klipper", "G1 X10 F6000\nG10\nSET_RETRACTION RETRACT_SPEED=30\nG11"), Is.EqualTo(all.Take(2)).Within(Exact));
        Assert.That(all, Has.Length.EqualTo(3));
    }

    [Test]
    public void A_lift_by_a_move_is_not_followed_and_named()
        => Assert.That(ProgramTable.Run("M207 Z1", "smoothie").Diagnostics.Select(d => d.Code), Does.Contain("gcode.unsupported_motion"));

    private static double[] Times(string flavor, string lines)
    {
        var rules = FlavorTable.Find(flavor)!;
        var toolpath = GCodeDecoder.Decode(Encoding.ASCII.GetBytes(lines + "\n"), new DecodeOptions { Flavor = rules }).Value!.Toolpath;
        var printer = Rigid with { Flavor = rules, RetractionLength = 3, RetractionSpeed = 30 };
        return Timeline.Of(toolpath, new PrintSetup { Printer = printer }).Trapezoids().Select(t => t.Duration).ToArray();
    }
}

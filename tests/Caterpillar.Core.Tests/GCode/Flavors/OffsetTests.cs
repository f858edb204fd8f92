using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode.Flavors;

/// <summary>Home offsets, babysteps, coordinate systems, stored positions and splines.</summary>
public class OffsetTests
{
    private const string Sources = """
        slicer: GCodeProcessor.cpp has none of these
        marlin2: geometry/M206_M428.cpp, M206; module/motion.cpp, set_home_offset, set_axis_is_at_home; motion/M290.cpp; G53-G59.cpp; pause/G61.cpp
        marlin1: as Marlin 2
        prusa: Marlin_main.cpp, case 206 (add_homing), axis_is_at_home; M290, G54 and G60 are unknown
        bambu: none of these
        klipper: gcode.py, cmd_default: none of these
        reprapfirmware: GCodes3.cpp, OffsetAxes (-value is the origin); GCodes2.cpp, case 290 (within 1 mm, R0), case 60; GCodes.cpp, DoStraightMove (R)
        repetier: Commands.cpp, case 290 (zBabystepsMissing); M206 writes the EEPROM
        smoothie: Endstops.cpp, case 206: at the next homing, which is not followed
        sailfish: gpx.c, gpx_convert_line: none of these but G54, which is not followed
        cnc: G61 is exact stop; none of the others
        ultigcode: Marlin_main.cpp, case 206 (add_homing), axis_is_at_home
        bfb: gcodeExport.cpp: none of these
        grbl: gcode.c: G61 is exact stop; none of the others
        """;

    // Z of the machine at the end.
    private const string Heights = """
        |                              slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G1 Z10;M206 Z-5;G1 Z1              | 1   6   6   1  1  1   6    1  1  1  1  1  1  1
        G1 Z10;M206 Z-5;G28 Z;G1 Z1        | 1   6   6   6  1  1   6    1  1  1  1  6  1  1
        G1 Z10;M206 Z-5;G28 X;G1 Z1        | 1   6   6   1  1  1   6    1  1  1  1  1  1  1
        G1 Z10;M206 Z-5;M206 Z2;G1 Z1      | 1  -1  -1   1  1  1  -1    1  1  1  1  1  1  1
        G1 Z10;M206 Z-5;G92 Z0;G1 Z1       | 11 11  11  11 11 11  11   11 11 11 11 11 11 11
        G1 Z10;M290 Z0.3                   | 10 10.3 10.3 10 10 10 10.3 10.3 10 10 10 10 10 10
        G1 Z10;M290 Z5;G1 Z1               | 1   3   3   1  1  1   2    6  1  1  1  1  1  1
        G1 Z10;M290 S-0.5;G91;G1 Z1        | 11 10.5 10.5 11 11 11 10.5 10.5 11 11 11 11 11 11
        G1 Z10;M290 Z1;G28 Z;G1 Z1         | 1   1   1   1  1  1   2    1  1  1  1  1  1  1
        G1 Z10;M290 Z1;M290 Z0.2 R0;G1 Z1  | 1  2.2 2.2  1  1  1  1.2  2.2 1  1  1  1  1  1
        """;

    // X of the machine at the end.
    private const string PathSamples = """
        |                              slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G1 X10;G60;G1 X20;G61 X2           | 20 12  12  20 20 20  20   20 20 20 20 20 20 20
        G1 X10;G60;G1 X20;G61              | 20 10  10  20 20 20  20   20 20 20 20 20 20 20
        G1 X10;G60;G1 X20;G61 S1           | 20 20  20  20 20 20  20   20 20 20 20 20 20 20
        G1 X10;G60;G92 X0;G1 X20;G61 X     | 30 10  10  30 30 30  30   30 30 30 30 30 30 30
        G1 X10;G60 S3;G1 X20;G60 Q3        | 20 10  10  20 20 20  20   20 20 20 20 20 20 20
        G1 X10;G60 S1;G1 X20;G1 R1 X2      | 2   2   2   2  2  2  12    2  2  2  2  2  2  2
        G1 X10;G92 X5;G54;G1 X1            | 6   1   1   6  6  6   6    6  6  6  6  6  6  6
        G1 X10;G55;G92 X0;G54;G1 X1        | 11  1   1  11 11 11  11   11 11 11 11 11 11 11
        G1 X10;G55;G92 X0;G54;G55;G1 X1    | 11 11  11  11 11 11  11   11 11 11 11 11 11 11
        G1 X10;G55;G92 X0;G28 X;G1 X1      | 1   1   1   1  1  1   1   11 11  1 11  1  1 11
        """;

    private static IEnumerable<TestCaseData> HeightCases() => ProgramTable.Cases(Heights, Sources);

    private static IEnumerable<TestCaseData> PlaceCases() => ProgramTable.Cases(PathSamples, Sources);

    [TestCaseSource(nameof(HeightCases))]
    public void Offsets_change_the_height_as_the_firmware_does(string program, string flavor, string z, string source)
    {
        var toolpath = ProgramTable.Decode(program, flavor).Toolpath;
        Assert.That(ProgramTable.Text(toolpath[toolpath.Count - 1].End.Z), Is.EqualTo(z), source);
    }

    [TestCaseSource(nameof(PlaceCases))]
    public void Stored_places_and_coordinate_systems_are_those_of_the_firmware(string program, string flavor, string x, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.X(ProgramTable.Decode(program, flavor))), Is.EqualTo(x), source);

    [Test]
    public void A_babystep_moves_the_head_and_not_its_coordinates()
    {
        var decoding = ProgramTable.Decode("G1 X1 Y2 Z10;M290 Z0.3;G1 X5", "marlin2");
        Assert.That(decoding.Toolpath.Moves().Select(m => m.End), Is.EqualTo(new[] { new Vec3(1, 2, 10), new Vec3(1, 2, 10.3), new Vec3(5, 2, 10.3) }));
        Assert.That(decoding.Report.EndPosition, Is.EqualTo(new Vec3(5, 2, 10)));
        Assert.That(ProgramTable.Run("G1 X1;M290 X1", "marlin2").Diagnostics.Select(d => d.Code), Does.Contain("gcode.unsupported_motion"));
    }

    [TestCase("G1 X10 Y10 Z5;G60;G1 X20 Y30 Z1;G61", "20,30,5 10,10,5", TestName = "up first")]
    [TestCase("G1 X10 Y10 Z5;G60;G1 X20 Y30 Z9;G61", "10,10,9 10,10,5", TestName = "down last")]
    [TestCase("G1 X10 Y10 Z5;G60;G1 X20 Y30 Z9;G61 Y-1 Z", "20,9,5", TestName = "straight in the axes named")]
    [TestCase("G1 X10 Y10 Z5;G60;G1 X20 Y30 Z9;G61 E", "", TestName = "E does not move")]
    public void Marlin_returns_to_a_stored_position(string program, string path)
        => Assert.That(string.Join(" ", ProgramTable.Decode(program, "marlin2").Toolpath.Moves().Skip(2)
            .Select(m => ProgramTable.Text(m.End.X) + "," + ProgramTable.Text(m.End.Y) + "," + ProgramTable.Text(m.End.Z))), Is.EqualTo(path));

    [Test]
    public void G61_moves_at_a_speed_of_its_own_and_E_gets_the_position_of_that_time()
    {
        var moves = ProgramTable.Decode("G1 X10 E5 F600;G60;G1 X20 E9;G61 X E F1200;G1 X30 E6", "marlin2").Toolpath.Moves().ToArray();
        Assert.That(moves.Select(m => m.Speed), Is.EqualTo(new[] { 10.0, 10, 20, 10 }));
        Assert.That(moves.Select(m => m.E), Is.EqualTo(new[] { 5.0, 4, 0, 1 }));
    }

    // y = 12 t (1 − t), x = 30 (1 − t) t² + 10 t³, and z rises evenly. The second difference is √116 mm: √(0.75 · 10.77 / 0.01) = 28.4 chords.
    [TestCase("marlin2")]
    [TestCase("marlin1")]
    public void A_spline_becomes_chords(string flavor)
    {
        var moves = ProgramTable.Decode("G1 X1 Y2 Z3 E1;G5 X11 Y2 Z5 I0 J4 P0 Q4 E3.9 F600", flavor).Toolpath.Moves().Skip(1).ToArray();
        Assert.That(moves, Has.Length.EqualTo(29));
        for (var i = 1; i <= 29; i++)
        {
            var t = i / 29.0;
            var expected = new Vec3(1 + 30 * (1 - t) * t * t + 10 * t * t * t, 2 + 12 * t * (1 - t), 3 + 2 * t);
            Assert.That(moves[i - 1].End.DistanceTo(expected), Is.LessThan(1e-12));
            Assert.That(moves[i - 1].E, Is.EqualTo(0.1).Within(1e-12));
        }
        Assert.That(moves[28].End, Is.EqualTo(new Vec3(11, 2, 5)));
        Assert.That(moves[0].Speed, Is.EqualTo(10));
    }

    [Test]
    public void Each_chord_is_near_to_its_spline()
    {
        var moves = ProgramTable.Decode("G1 X1 Y2;G5 X11 Y2 I0 J4 P0 Q4", "marlin2").Toolpath.Moves().Skip(1).ToArray();
        var off = 0.0;
        for (var i = 0; i < 29; i++)
        {
            var t = (i + 0.5) / 29;
            var middle = new Vec3(1 + 30 * (1 - t) * t * t + 10 * t * t * t, 2 + 12 * t * (1 - t), 0);
            off = Math.Max(off, middle.DistanceTo((moves[i].Start + moves[i].End) / 2));
        }
        Assert.That(off, Is.InRange(0.005, 0.01));
    }

    [TestCase("G18;G5 X10 I1 J1 P1 Q1", "marlin2", "gcode.arc_refused")]
    [TestCase("G5 X10 I1 J1 P1 Q1", "cnc", "gcode.unsupported_motion")]
    public void Splines_that_are_not_followed_are_named(string program, string flavor, string code)
        => Assert.That(ProgramTable.Run(program, flavor).Diagnostics.Select(d => d.Code), Does.Contain(code));

    [TestCase("G55;G1 X5", 1)]
    [TestCase("G10 L2 P2 X3;G55;G1 X5", 0)]
    [TestCase("G10 L2 P2 X0 Y0 Z0;G55;G1 X5", 0)]
    [TestCase("G10 L20 P2 X3;G55;G1 X5", 0)]
    [TestCase("G54;G1 X5", 0)]
    public void Grbl_does_not_know_a_position_in_a_system_without_origin(string program, int warnings)
        => Assert.That(ProgramTable.Run(program, "grbl").Diagnostics.Count(d => d.Code == "gcode.workspace"), Is.EqualTo(warnings));

    // Offset 2 of E: with MOVE=1 it is extruded at once, and the coordinates stay.
    [TestCase("G1 X1 E5;SET_GCODE_OFFSET E=2 MOVE=1", "7")]
    [TestCase("G1 X1 E5;SET_GCODE_OFFSET E=2 MOVE=1;G1 X2 E5", "7")]
    [TestCase("G1 X1 E5;SET_GCODE_OFFSET E=2;G1 X2 E5", "7")]
    public void An_offset_of_E_moves_the_extruder_if_it_says_so(string program, string sum)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program, "klipper").Toolpath.Moves().Sum(m => m.E)), Is.EqualTo(sum));

    [Test]
    public void An_offset_of_Klipper_moves_the_head_at_its_speed()
    {
        var moves = ProgramTable.Decode("G1 X1 Z1 F600;SET_GCODE_OFFSET Z=0.2 MOVE=1 MOVE_SPEED=3;G1 X2;G28 Z;G1 Z1", "klipper").Toolpath.Moves().ToArray();
        Assert.That(moves.Select(m => m.End.Z), Is.EqualTo(new[] { 1, 1.2, 1.2, 0, 1.2 }).Within(1e-12));
        Assert.That(moves[1].Speed, Is.EqualTo(3));
        Assert.That(moves[2].Speed, Is.EqualTo(10));
    }
}

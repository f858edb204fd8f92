using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode.Flavors;

/// <summary>G92: alone, with axes, with E, and taken back.</summary>
public class OriginTests
{
    private const string Sources = """
        slicer: GCodeProcessor.cpp, process_G92 (any_found); G92.1 and G92.2 as the test data
        marlin2: geometry/G92.cpp, G92 (subcode 0, 1); module/motion.cpp, update_workspace_offset
        marlin1: Marlin_main.cpp, gcode_G92
        prusa: Marlin_main.cpp, gcode_G92: only axes that are seen; 92.1 is read as 92
        bambu: GCodeProcessor.cpp, process_G92 (any_found); G92.1 is no command of its table
        klipper: gcode_move.py, cmd_G92: without offsets base_position is last_position
        reprapfirmware: GCodes3.cpp, SetPositions; GCodes2.cpp, HandleGcode (a fraction of G92 runs a macro file)
        repetier: Commands.cpp, processGCode, case 92; Printer.cpp, setOrigin
        smoothie: Robot.cpp, on_gcode_received, case 92: without arguments, and G92.1, G92.2, g92_offset is 0; E is 0
        sailfish: gpx.c, gpx_convert_line, case 92: axes that are set; atoi reads 92.1 as 92
        cnc: interp_internal.cc, enhance_block (NCE_ALL_AXES_MISSING_WITH_G52_OR_G92); interp_convert.cc, convert_axis_offsets
        ultigcode: Marlin_main.cpp, process_commands, case 92: axes that are seen
        bfb: gcodeExport.cpp: G92 E0 only; the firmware is closed, taken as most do
        grbl: gcode.c, NON_MODAL_SET_COORDINATE_OFFSET (no axis words is an error), NON_MODAL_RESET_COORDINATE_OFFSET (G92.1 only)
        """;

    // X of the machine at the end.
    private const string PathSamples = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G1 X10;G92;G1 X15           | 25  15  15  15  25  25  15  15  15  15  15  15  15  15
        G1 X10;G92 X0;G1 X5;G92;G1 X1 | 16 11 11  11  16  16  11  11   1  11  11  11  11  11
        G1 X10;G92 X0;G1 X5         | 15  15  15  15  15  15  15  15  15  15  15  15  15  15
        G1 X10;G92 X100;G1 X101     | 11  11  11  11  11  11  11  11  11  11  11  11  11  11
        G91;G1 X10;G92 X0;G1 X5     | 15  15  15  15  15  15  15  15  15  15  15  15  15  15
        G1 X10;G92 X0;G92 X5;G1 X6  | 11  11  11  11  11  11  11  11  11  11  11  11  11  11
        G1 X10;G92 X0;G1 X5;G92.1;G1 X1 | 1 1  1  11  11  11  11  11   1  11   1  11  11   1
        G1 X10;G92 X0;G1 X5;G92.2;G1 X1 | 1 11 11 11  11  11  11  11   1  11   1  11  11  11
        """;

    // The sum of E.
    private const string Sums = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G1 X1 E1;G92;G1 X2 E1       | 2  1  1  1  2  2  1  1  2  1  1  1  0  0
        G1 X1 E5;G92 E0;G1 X2 E1    | 6  6  6  6  6  6  6  6  6  6  6  6  0  0
        G1 X1 E5;G92 E4;G1 X2 E1    | 2  2  2  2  2  2  2  2  2  2  2  2  0  0
        M83;G1 X1 E5;G92 E0;M82;G1 X2 E1 | 6 6 6 6  6  6  6  6  6  6  6  6  0  0
        M83;G1 X1 E5;G92 E9;G1 X2 E1 | 6  6  6  6  6  6  6  6  6  6 -3  6  0  0
        """;

    private static IEnumerable<TestCaseData> PlaceCases() => ProgramTable.Cases(PathSamples, Sources);

    private static IEnumerable<TestCaseData> SumCases() => ProgramTable.Cases(Sums, Sources);

    [TestCaseSource(nameof(PlaceCases))]
    public void The_place_gets_another_name(string program, string flavor, string x, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.X(ProgramTable.Decode(program, flavor))), Is.EqualTo(x), source);

    [TestCaseSource(nameof(SumCases))]
    public void The_position_of_E_gets_another_name(string program, string flavor, string sum, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program, flavor).Report.ENet), Is.EqualTo(sum), source);

    [Test]
    public void Before_an_axis_is_known_G92_says_where_it_is()
    {
        var decoding = ProgramTable.Decode("G92 X100 Y50 Z0;G1 X110", "marlin2");
        Assert.That(decoding.Toolpath.Start, Is.EqualTo(new Vec3(100, 50, 0)));
        Assert.That(decoding.Toolpath[0].End, Is.EqualTo(new Vec3(110, 50, 0)));
    }

    [Test]
    public void A_bare_G92_is_reported()
        => Assert.That(ProgramTable.Run("G1 X10;G92;G1 X15", "marlin2").Diagnostics.Select(d => d.Code), Does.Contain("gcode.flavor_g92"));

    [Test]
    public void Positions_as_written_follow_G92()
        => Assert.That(ProgramTable.Decode("G1 X10 Y5;G92 X0 Y1;G1 X5;G1 Y2", "marlin2").Report.EndPosition, Is.EqualTo(new Vec3(5, 2, 0)));

    // gcode_move.py, cmd_SET_GCODE_OFFSET: base_position changes by the difference of the offsets.
    [TestCase("G1 X1 E5;SET_GCODE_OFFSET E=2;G1 X2 E5", "7")]
    [TestCase("SET_GCODE_OFFSET E=2;SET_GCODE_OFFSET E=2;G1 X2 E5", "7")]
    [TestCase("SET_GCODE_OFFSET E=2;SET_GCODE_OFFSET E_ADJUST=1;G1 X2 E5", "8")]
    public void An_offset_of_E_of_Klipper_is_extruded_by_the_next_absolute_move(string program, string sum)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program, "klipper").Toolpath.Moves().Sum(m => m.E)), Is.EqualTo(sum));
}

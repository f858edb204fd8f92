using System.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode.Flavors;

/// <summary>G90, G91, M82 and M83 in all orders.</summary>
public class ModesOfETests
{
    private const string Sources = """
        slicer: GCodeProcessor.cpp, process_G1 (extract_absolute_position_on_axis): relative where the global or the local type is
        marlin2: gcode.h, set_relative_mode (sets all axes and E), set_e_absolute, set_e_relative; gcode.cpp, get_destination_from_command
        marlin1: Marlin_main.cpp, gcode_get_destination: axis_relative_modes[i] || relative_mode
        prusa: Marlin_main.cpp, process_commands, case 90, 91 (X, Y, Z of axis_relative_modes), M82, M83 (E of it)
        bambu: GCodeProcessor.cpp, process_G1 (absolute_position), process_G90, process_G91, process_M82, process_M83
        klipper: gcode_move.py, cmd_G1: absolute_coord and absolute_extrude
        reprapfirmware: GCodes2.cpp, case 90, 91 (axesRelative), M82, M83 (drivesRelative), 120, 121; GCodes.cpp, LoadExtrusionAndFeedrateFromGCode
        repetier: Printer.cpp, setDestinationStepsFromGCode: relativeCoordinateMode || relativeExtruderCoordinateMode
        smoothie: Robot.cpp, on_gcode_received, case 90, 91 (absolute_mode and e_absolute_mode), M82, M83 (e_absolute_mode); push_state, pop_state
        sailfish: gpx.c, calculate_target_position: relativeCoordinates || extruderIsRelative
        cnc: interp_find.cc, find_ends: the distance mode holds for A too; interp_convert.cc knows no M82, M83
        ultigcode: Marlin_main.cpp, get_coordinates: axis_relative_modes[i] || relative_mode
        bfb: gcodeExport.cpp, writeMoveBFB: no words with amounts
        grbl: gcode.c, gc_execute_line: E is an unsupported letter
        """;

    // The sum of E of two moves that both say E1: 2 where E is relative, 1 where it is absolute, 0 if there is none.
    private const string Sums = """
        |            slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        M105            | 1  1  1  1  1  1  1  1  1  1  1  1  0  0
        M82             | 1  1  1  1  1  1  1  1  1  1  1  1  0  0
        M83             | 2  2  2  2  2  2  2  2  2  2  1  2  0  0
        G90;M82         | 1  1  1  1  1  1  1  1  1  1  1  1  0  0
        M82;G90         | 1  1  1  1  1  1  1  1  1  1  1  1  0  0
        G90;M83         | 2  2  2  2  2  2  2  2  2  2  1  2  0  0
        M83;G90         | 2  1  2  2  2  2  2  2  1  2  1  2  0  0
        G91             | 2  2  2  1  2  2  1  2  2  2  2  2  0  0
        G91;M82         | 2  1  2  1  2  2  1  2  1  2  2  2  0  0
        M82;G91         | 2  2  2  1  2  2  1  2  2  2  2  2  0  0
        G91;M83         | 2  2  2  2  2  2  2  2  2  2  2  2  0  0
        M83;G91         | 2  2  2  2  2  2  2  2  2  2  2  2  0  0
        G91;G90         | 1  1  1  1  1  1  1  1  1  1  1  1  0  0
        M83;M82         | 1  1  1  1  1  1  1  1  1  1  1  1  0  0
        M83;G90;M83     | 2  2  2  2  2  2  2  2  2  2  1  2  0  0
        G91;M83;G90;M82 | 1  1  1  1  1  1  1  1  1  1  1  1  0  0
        M83;G91;G90     | 2  1  2  2  2  2  2  2  1  2  1  2  0  0
        M83;M120;M82;M121 | 1  1  1  1  1  1  2  1  2  1  1  1  0  0
        """;

    private static System.Collections.Generic.IEnumerable<TestCaseData> SumCases() => ProgramTable.Cases(Sums, Sources);

    [TestCaseSource(nameof(SumCases))]
    public void E_is_absolute_or_relative(string program, string flavor, string sum, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program + ";G1 X10 E1;G1 X20 E1", flavor).Report.ENet), Is.EqualTo(sum), source);

    [Test]
    public void The_order_of_modes_is_reported_where_firmwares_differ()
    {
        foreach (var program in new[] { "M83;G90", "G91;M82", "G91" })
            Assert.That(ProgramTable.Run(program + ";G1 X1 E1;G1 X2 E1", "marlin2").Diagnostics.Select(d => d.Code), Does.Contain("gcode.flavor_e_mode"),
                program);
        foreach (var program in new[] { "G90;M83", "M82", "G91;M83", "G90" })
            Assert.That(ProgramTable.Run(program + ";G1 X1 E1;G1 X2 E1", "marlin2").Diagnostics.Select(d => d.Code), Does.Not.Contain("gcode.flavor_e_mode"),
                program);
    }

    [TestCase("grbl", "gcode.word_refused")]
    [TestCase("bfb", "gcode.no_extruder")]
    public void Amounts_that_a_firmware_does_not_know_are_reported(string flavor, string code)
    {
        Assert.That(ProgramTable.Run("G1 X10 E1", flavor).Diagnostics.Select(d => d.Code), Does.Contain(code));
        Assert.That(ProgramTable.Decode("G1 X10 E1", flavor).Report.ENet, Is.Zero);
    }
}

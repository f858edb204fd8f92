using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode.Flavors;

/// <summary>G2 and G3: center, radius, relative mode, full circles, helices, turns, planes, refusals.</summary>
public class ArcTests
{
    private const string Sources = """
        slicer: GCodeProcessor.cpp, process_G2_G3; ArcWelder.hpp, arc_center; planes, centers and P as the test data
        marlin2: motion/G2_G3.cpp, G2_G3 (R before I J K; ARC_P_CIRCLES), plan_arc
        marlin1: Marlin_main.cpp, gcode_G2_G3 (while (circles_to_do--) plan_arc(current_position …)), plan_arc
        prusa: Marlin_main.cpp, process_commands, case 2, 3 (I J); motion_control.cpp, mc_arc
        bambu: GCodeProcessor.cpp, process_G2_G3 (I J; P must be 1 and the circle closed)
        klipper: gcode_arcs.py, _cmd_inner (no R, no relative mode, I K in X Z), planArc
        reprapfirmware: GCodes.cpp, DoArcMove (R before I J K, at most 1 % too short)
        repetier: Commands.cpp, processArc (R before I J); motion.cpp, PrintLine::arc (Z is at its end from the first chord)
        smoothie: Robot.cpp, process_move (I J K), compute_arc, append_arc
        sailfish: gpx.c, gpx_convert_line: no case 2, 3
        cnc: interp_convert.cc, convert_arc, convert_arc2; interp_arc.cc, arc_data_ijk, arc_data_r
        ultigcode: Marlin_main.cpp, get_arc_coordinates (I J); motion_control.cpp, mc_arc (angular_travel 0 of a closed G3)
        bfb: gcodeExport.cpp writes no arcs
        grbl: gcode.c, MOTION_MODE_CW_ARC (axis words, R, offsets, delta_r; unused words), motion_control.c, mc_arc
        """;

    // Length of the move from 0,0,0, or "no" if the arc is refused.
    private const string Lengths = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G3 X0 Y10 I0 J5             | 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 no 15.708 15.708 no 15.708
        G3 X0 Y10 J5                | 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 no 15.708 15.708 no 15.708
        G2 X5 Y5 I5                 | 7.854  7.854  7.854  7.854  7.854  7.854  7.854  7.854  7.854  no 7.854  7.854  no 7.854
        G3 X5 Y5 I5                 | 23.562 23.562 23.562 23.562 23.562 23.562 23.562 23.562 23.562 no 23.562 23.562 no 23.562
        G3 X0 Y10 R5                | 15.708 15.708 15.708 no     no     no     15.708 15.708 no     no 15.708 no     no 15.708
        G3 X5 Y5 R5                 | 7.854  7.854  7.854  no     no     no     7.854  7.854  no     no 7.854  no     no 7.854
        G2 X5 Y5 R-5                | 23.562 23.562 23.562 no     no     no     23.562 23.562 no     no 23.562 no     no 23.562
        G3 X0 Y10 R4                | 15.708 15.708 15.708 no     no     no     no     no     no     no no     no     no no
        G3 X0 Y10 R4.98             | 15.708 15.708 15.708 no     no     no     15.708 no     no     no no     no     no no
        G3 X0 Y0 R5                 | 0      no     no     no     no     no     no     no     no     no no     no     no no
        G3 X0 Y10 J5 R10            | 15.708 10.472 10.472 15.708 15.708 no     10.472 10.472 15.708 no no     15.708 no no
        G2 X0 Y0 I5                 | 31.416 31.416 31.416 31.416 31.416 31.416 31.416 31.416 31.416 no 31.416 31.416 no 31.416
        G3 X0 Y0 I5                 | 31.416 31.416 31.416 31.416 31.416 31.416 31.416 31.416 31.416 no 31.416 no     no 31.416
        G2 I5                       | 31.416 31.416 31.416 31.416 31.416 31.416 31.416 31.416 31.416 no 31.416 31.416 no no
        G2 X0 Y0 I5 P1              | 31.416 62.832 62.832 31.416 31.416 31.416 31.416 31.416 31.416 no 31.416 31.416 no no
        G2 X0 Y0 I5 P3              | 94.248 125.664 125.664 31.416 no   31.416 31.416 31.416 31.416 no 94.248 31.416 no no
        G3 X0 Y10 J5 P2             | 47.124 78.54  78.54  15.708 no     15.708 15.708 15.708 15.708 no 47.124 15.708 no no
        G3 X0 Y10 Z1 J5             | 15.74  15.74  15.74  15.74  15.74  15.74  15.74  16.708 15.74  no 15.74  15.74  no 15.74
        G2 X0 Y0 Z3 I5              | 31.559 31.559 31.559 31.559 31.559 31.559 31.559 34.416 31.559 no 31.559 31.559 no 31.559
        G91;G3 X0 Y10 J5            | 15.708 15.708 15.708 15.708 15.708 no     15.708 15.708 15.708 no 15.708 15.708 no 15.708
        G91;G2 X0 Y0 I5             | 31.416 31.416 31.416 31.416 31.416 no     31.416 31.416 31.416 no 31.416 31.416 no 31.416
        G3 X0 Y11 J5                | 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 no no     15.708 no no
        G3 X0 Y10.01 J5             | 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 no 15.708 15.708 no no
        G3 X0 Y10.004 J5            | 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 no 15.708 15.708 no 15.708
        G3 X5 Y5                    | 7.071  no     no     no     no     no     no     no     no     no no     no     no no
        G3 X5 Y5 I0 J0              | 7.071  no     no     no     no     no     no     no     no     no no     no     no no
        G18;G3 X0 Z10 I0 K5         | 15.708 15.708 15.708 no     no     15.708 15.708 no     15.708 no 15.708 no     no 15.708
        G18;G3 X5 Z-5 K-5           | 7.854  7.854  7.854  no     no     23.562 7.854  no     7.854  no 7.854  no     no 7.854
        G18;G2 X5 Z-5 K-5           | 23.562 23.562 23.562 no     no     7.854  23.562 no     23.562 no 23.562 no     no 23.562
        G18;G3 X0 Z10 R5            | 15.708 no     no     no     no     no     15.708 no     no     no 15.708 no     no 15.708
        G19;G3 Y5 Z5 K5             | 7.854  7.854  7.854  no     no     7.854  7.854  no     7.854  no 7.854  no     no 7.854
        G19;G17;G3 X0 Y10 J5        | 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 no 15.708 15.708 no 15.708
        """;

    // Length of the arc that goes on from X10 to X10 Y10.
    private const string Centers = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G3 X10 Y10 I0 J5            | 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 no 15.708 15.708 no 15.708
        G90.1;G3 X10 Y10 I10 J5     | 15.708 59.881 59.881 59.881 59.881 59.881 59.881 59.881 59.881 no 15.708 59.881 no 59.881
        G90.1;G91.1;G3 X10 Y10 I0 J5 | 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 15.708 no 15.708 15.708 no 15.708
        """;

    private static IEnumerable<TestCaseData> LengthCases() => ProgramTable.Cases(Lengths, Sources);

    private static IEnumerable<TestCaseData> CenterCases() => ProgramTable.Cases(Centers, Sources);

    [TestCaseSource(nameof(LengthCases))]
    public void Arcs_are_drawn_or_refused(string program, string flavor, string length, string source)
        => Assert.That(Length(program, flavor, 0), Is.EqualTo(length), source);

    [TestCaseSource(nameof(CenterCases))]
    public void Centers_are_relative_or_absolute(string program, string flavor, string length, string source)
        => Assert.That(Length("G0 X10;" + program, flavor, 10), Is.EqualTo(length), source);

    // Two full circles before a half one, 3 mm up: rise and E of each move.
    [TestCase("marlin2", "3/2")]
    [TestCase("marlin1", "0/0 0/0 3/2")]
    [TestCase("repetier", "3/0 0/2")]
    public void Turns_and_rises_share_the_extrusion_or_not(string flavor, string moves)
    {
        var toolpath = ProgramTable.Decode("G3 X0 Y10 Z3 J5 P2 E2", flavor).Toolpath;
        var z = 0.0;
        var all = new List<string>();
        foreach (var move in toolpath.Moves())
        {
            all.Add(ProgramTable.Text(move.End.Z - z) + "/" + ProgramTable.Text(move.E));
            z = move.End.Z;
        }
        Assert.That(string.Join(" ", all), Is.EqualTo(moves));
    }

    private static string Length(string program, string flavor, double before)
    {
        var result = ProgramTable.Run(program, flavor);
        if (result.Diagnostics.Any(d => d.Code == "gcode.arc_refused")) return "no";
        return ProgramTable.Text(result.Value!.Report.PrintLength + result.Value.Report.TravelLength - before);
    }
}

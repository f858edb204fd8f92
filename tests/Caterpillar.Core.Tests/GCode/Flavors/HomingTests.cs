using System.Collections.Generic;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode.Flavors;

/// <summary>G28 and its like.</summary>
public class HomingTests
{
    private const string Sources = """
        slicer: GCodeProcessor.cpp, process_G28: named axes, or all, to 0
        marlin2: calibrate/G28.cpp, G28 (home_all, workspace_plane); module/motion.cpp, set_axis_is_at_home (position_shift is 0)
        marlin1: Marlin_main.cpp, gcode_G28, set_axis_is_at_home (position_shift is 0)
        prusa: Marlin_main.cpp, gcode_G28 (home_x_value …)
        bambu: GCodeProcessor.cpp, process_G28: named axes, or all, to 0
        klipper: extras/homing.py, cmd_G28; gcode_move.py, _handle_home_rails_end (base_position is homing_position)
        reprapfirmware: GCodes.cpp, DoHome; SetPositions of G92 keeps no shift
        repetier: Commands.cpp, processGCode, case 28; Printer.cpp, homeAxis: coordinateOffset stays
        smoothie: Endstops.cpp, on_gcode_received, process_home_command: g92_offset stays
        sailfish: gpx.c, gpx_convert_line, case 28, 161, 162 (home_axes)
        cnc: interp_convert.cc, convert_home, convert_savehome: over the point named to the stored one, in the axes named
        ultigcode: Marlin_main.cpp, process_commands, case 28 (code_value_long() != 0)
        bfb: gcodeExport.cpp: G28 of the start code
        grbl: gcode.c, NON_MODAL_GO_HOME_0, NON_MODAL_GO_HOME_1, NON_MODAL_SET_HOME_0, NON_MODAL_SET_HOME_1
        """;

    // Where the machine stands at the end: X,Y,Z. Every program begins with a move to X10 Y10 Z5.
    private const string PathSamples = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G28                         | 0,0,0   0,0,0   0,0,0   0,0,0   0,0,0   0,0,0   0,0,0   0,0,0   0,0,0   0,0,0   0,0,0   0,0,0   0,0,0   0,0,0
        G28 X0                      | 0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  0,10,5
        G28 Y0 Z0                   | 10,0,0  10,0,0  10,0,0  10,0,0  10,0,0  10,0,0  10,0,0  10,0,0  10,0,0  10,0,0  10,0,0  10,0,0  10,0,0  10,0,0
        G28 X5;G1 X6                | 6,10,5  6,10,5  6,10,5  1,10,5  6,10,5  6,10,5  6,10,5  6,10,5  6,10,5  6,10,5  6,10,5  1,10,5  6,10,5  6,10,5
        G92 X0;G28 X0;G1 X3         | 3,10,5  3,10,5  3,10,5  3,10,5  3,10,5  3,10,5  3,10,5  13,10,5 13,10,5 3,10,5  13,10,5 3,10,5  3,10,5  13,10,5
        G28.1;G1 X20;G28 X0         | 0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  0,10,5  10,10,5 0,10,5  0,10,5  10,10,5
        G30.1;G1 X20;G30 X0         | 20,10,5 20,10,5 20,10,5 20,10,5 20,10,5 20,10,5 20,10,5 20,10,5 20,10,5 20,10,5 10,10,5 20,10,5 20,10,5 10,10,5
        G161 X0                     | 10,10,5 10,10,5 10,10,5 10,10,5 10,10,5 10,10,5 10,10,5 10,10,5 10,10,5 0,10,5  10,10,5 10,10,5 10,10,5 10,10,5
        """;

    // X of the machine after each move.
    private const string Paths = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G1 X10;G28 X0               | 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0
        G1 X10;G91;G28 X0           | 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0
        G1 X10;G28 X4               | 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,4,0 10,0 10,0 10,4,0
        G1 X10;G91;G28 X5           | 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,0 10,15,0 10,0 10,0 10,15,0
        """;

    private static IEnumerable<TestCaseData> PlaceCases() => ProgramTable.Cases(PathSamples, Sources);

    private static IEnumerable<TestCaseData> LengthCases() => ProgramTable.Cases(Paths, Sources);

    [TestCaseSource(nameof(PlaceCases))]
    public void Homing_goes_to_its_place(string program, string flavor, string place, string source)
    {
        var toolpath = ProgramTable.Decode("G1 X10 Y10 Z5;" + program, flavor).Toolpath;
        var end = toolpath[toolpath.Count - 1].End;
        Assert.That(ProgramTable.Text(end.X) + "," + ProgramTable.Text(end.Y) + "," + ProgramTable.Text(end.Z), Is.EqualTo(place), source);
    }

    [TestCaseSource(nameof(LengthCases))]
    public void Homing_moves_have_their_length(string program, string flavor, string path, string source)
        => Assert.That(string.Join(",", ProgramTable.Decode(program, flavor).Toolpath.Moves().Select(m => ProgramTable.Text(m.End.X))), Is.EqualTo(path),
            source);

    [Test]
    public void Homing_is_an_event_and_no_move_of_the_files_own()
    {
        foreach (var name in FlavorTable.All.Select(d => d.Name))
        {
            var decoding = ProgramTable.Decode("G1 X10 Y10 Z5;G28 X0;G1 X3 Y4 Z5", name);
            Assert.That(decoding.Toolpath[1].End, Is.EqualTo(new Vec3(0, 10, 5)), name);
            Assert.That(decoding.Toolpath.Events.Single().Event, Is.EqualTo(new HomeEvent(true, false, false)), name);
            Assert.That(decoding.Report.TravelSegments + decoding.Report.PrintSegments, Is.EqualTo(2), name);
        }
    }

    [TestCase("marlin2", 15.708)]
    [TestCase("marlin1", 15.708)]
    [TestCase("slicer", 10)]
    public void Marlin_homes_into_the_plane_XY(string flavor, double length)
        => Assert.That(ProgramTable.Decode("G18;G28;G3 X0 Y10 J5", flavor).Report.TravelLength, Is.EqualTo(length).Within(0.001),
            "in ZX the center is the start");
}

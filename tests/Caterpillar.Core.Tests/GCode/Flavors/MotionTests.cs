using System.Collections.Generic;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.Tests.Flavors;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode.Flavors;

/// <summary>Motion without G, several G in a line, workspaces, kept states, G10 and G11, and what prints without E.</summary>
public class MotionTests
{
    private const string Sources = """
        slicer: GCodeProcessor.cpp; motion without G and several G in a line as the test data
        marlin2: parser.cpp, parse (one command a line; motion modes are an option); gcode.cpp, process_parsed_command
        marlin1: Marlin_main.cpp, process_parsed_command; gcode.cpp, parse
        prusa: Marlin_main.cpp, process_commands: the first G; no command without one
        bambu: GCodeProcessor.cpp, process_gcode_line: the first word is the command
        klipper: gcode.py, _process_commands: the first word is the command; gcode_move.py, cmd_SAVE_GCODE_STATE, cmd_RESTORE_GCODE_STATE, cmd_SET_GCODE_OFFSET
        reprapfirmware: StringParser.cpp, DecodeCommand (several commands a line); GCodes2.cpp, case 53 to 59, 120, 121; GCodes3.cpp, GetSetWorkplaceCoordinates
        repetier: gcode.cpp, parseAscii: the last G; Commands.cpp, executeGCode
        smoothie: GcodeDispatch.cpp (several commands a line, modal_group_1, G53); Robot.cpp, case 10, 54 to 59, 120, 121
        sailfish: gpx.c, gpx_convert_line: the last G of a line; axes without a command are a G1
        cnc: interp_internal.cc, enhance_block (motion_to_be); interp_convert.cc, convert_setup, convert_coordinate_system; interp_find.cc, find_ends (G53)
        ultigcode: Marlin_main.cpp, process_commands: the first G; no command without one
        bfb: gcodeExport.cpp writes none of it
        grbl: gcode.c, AXIS_COMMAND_MOTION_MODE, NON_MODAL_SET_COORDINATE_DATA, NON_MODAL_ABSOLUTE_OVERRIDE, coord_select
        """;

    // X of the machine at the end.
    private const string PathSamples = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G1 X10;X20                  | 20  10  10  10  10  10  10  10  20  20  20  10  10  20
        G1 X10;G90;X20              | 20  10  10  10  10  10  10  10  20  20  20  10  10  20
        G1 X10;G90 X20              | 10  10  10  10  10  10  10  10  10  10  20  10  10  20
        G1 X10;G91 G1 X5            | 15  10  10  10  10  10  15   5  15   5  15  10  10  15
        G1 X10;G1 X5 G91            | 15   5   5   5   5   5   5  10   5  10  15   5   5  15
        G1 X10;G1 X5 G91;G1 X2      | 17   2   2   2   2   2   7  12   7  12  17   2   2  17
        G1 X10;G92 X0;G53 G1 X3     | 13  10  10  10  10  10   3  13   3  13   3  10  10   3
        G10 L2 P2 X100;G55;G1 X5    |  5   5   5   5   5   5 105   5 105   5 105   5   5 105
        G10 L2 P2 X100;G1 X5        |  5   5   5   5   5   5   5   5   5   5   5   5   5   5
        G1 X10;G10 L20 P1 X0;G1 X5  |  5   5   5   5   5   5  15   5  15   5  15   5   5  15
        G10 L2 P9 X7;G59.3;G1 X5    |  5   5   5   5   5   5  12   5  12   5  12   5   5  12
        G10 L2 P2 X100;G55;G54;G1 X5 | 5   5   5   5   5   5   5   5   5   5   5   5   5   5
        G10 L2 P1 X9;G1 X10;G92 X0;G92.1;G1 X1 | 1 1 1 11 11 11 20 11 10 11 10  11  11  10
        G91;M120;G90;M121;G1 X5;G1 X5 | 5  5   5   5   5   5  10   5  10   5   5   5   5   5
        SAVE_GCODE_STATE NAME=a;G91;G1 X5;RESTORE_GCODE_STATE NAME=a;G1 X7 | 12 12 12 12 12 7 12 12 12 12 12 12 12 12
        SAVE_GCODE_STATE NAME=a;G1 X5;RESTORE_GCODE_STATE NAME=a MOVE=1 | 5 5 5 5 5 0 5 5 5 5 5 5 5 5
        SET_GCODE_OFFSET X=2;G1 X5  |  5   5   5   5   5   7   5   5   5   5   5   5   5   5
        SET_GCODE_OFFSET X=2;SET_GCODE_OFFSET X_ADJUST=1;G1 X5 | 5 5 5 5 5 8 5 5 5 5 5 5 5 5
        G1 X5;SET_GCODE_OFFSET X=2 MOVE=1 | 5 5 5  5   5   7   5   5   5   5   5   5   5   5
        G1 X5;SET_GCODE_OFFSET X=2;G28 X0;G1 X5 | 5 5 5 5 5 7 5  5   5   5   5   5   5   5
        """;

    // How often the firmware retracts by itself.
    private const string Retractions = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G10                         | 1  1  1  1  1  1  1  1  1  0  0  1  0  0
        G10 S1                      | 1  1  1  1  1  1  0  1  1  0  0  1  0  0
        G10 P0 S200                 | 0  1  1  1  1  1  0  1  1  0  0  1  0  0
        G10 L2 P1 X5                | 0  1  1  1  1  1  0  1  0  0  0  1  0  0
        G11                         | 1  1  1  1  1  1  1  1  1  0  0  1  0  0
        """;

    // Prints among two moves.
    private const string Prints = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G0 X5;G1 X9                 | 0  0  0  0  0  0  0  0  0  0  1  0  0  1
        M101;G1 X5;M103;G1 X9       | 1  0  0  0  0  0  0  0  0  1  2  0  1  2
        M103;G1 X5;M101;G1 X9       | 1  0  0  0  0  0  0  0  0  1  2  0  1  2
        """;

    private static IEnumerable<TestCaseData> PlaceCases() => ProgramTable.Cases(PathSamples, Sources);

    private static IEnumerable<TestCaseData> RetractionCases() => ProgramTable.Cases(Retractions, Sources);

    private static IEnumerable<TestCaseData> PrintCases() => ProgramTable.Cases(Prints, Sources);

    [TestCaseSource(nameof(PlaceCases))]
    public void The_head_goes_there(string program, string flavor, string x, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.X(ProgramTable.Decode(program, flavor))), Is.EqualTo(x), source);

    [TestCaseSource(nameof(RetractionCases))]
    public void G10_and_G11_retract_or_not(string program, string flavor, string count, string source)
    {
        var moves = ProgramTable.Decode(program, flavor).Toolpath.Moves().ToArray();
        Assert.That(ProgramTable.Text(moves.Count(m => m.Kind is MoveKind.Retract or MoveKind.Deretract)), Is.EqualTo(count), source);
    }

    [TestCaseSource(nameof(PrintCases))]
    public void Moves_print_without_E(string program, string flavor, string count, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program, flavor).Toolpath.Moves().Count(m => m.Kind == MoveKind.Print)), Is.EqualTo(count),
            source);

    [Test]
    public void What_is_not_followed_is_reported()
    {
        foreach (var flavor in FlavorTable.All)
        {
            foreach (var command in CommandTable.Rows.Where(r => r.Flavors.Contains(flavor.Name)).SelectMany(r => r.Commands)
                .Where(c => c.Use == CommandUse.Untracked))
            {
                var found = ProgramTable.Run(FlavorCommandTests.LineOf(command), flavor.Name).Diagnostics.Select(d => d.Code);
                Assert.That(found, Does.Contain("gcode.unsupported_motion"), flavor.Name + " " + command.Name);
            }
        }
        Assert.That(ProgramTable.Run("G1 R1 X5", "reprapfirmware").Diagnostics.Select(d => d.Code), Does.Contain("gcode.unsupported_motion"));
    }

    [TestCase("G1 X10;X20", "marlin2", "gcode.flavor_modal")]
    [TestCase("G91 G1 X20", "klipper", "gcode.flavor_commands")]
    [TestCase("G1 X5 G0 Y6", "reprapfirmware", "gcode.flavor_commands")]
    [TestCase("RESTORE_GCODE_STATE NAME=b", "klipper", "gcode.unknown_state")]
    [TestCase("G55;G1 X5", "cnc", "gcode.workspace")]
    public void What_depends_on_the_machine_is_reported(string program, string flavor, string code)
        => Assert.That(ProgramTable.Run(program, flavor).Diagnostics.Select(d => d.Code), Does.Contain(code));
}

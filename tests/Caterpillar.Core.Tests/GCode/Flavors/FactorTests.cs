using System.Collections.Generic;
using System.Linq;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode.Flavors;

/// <summary>M220 and M221.</summary>
public class FactorTests
{
    private const string Sources = """
        slicer: GCodeProcessor.cpp, process_M220, process_M221: by flavor, so the neutral reading leaves both out
        marlin2: config/M220.cpp, M220 (R, B, S); config/M221.cpp, M221 (flow_percentage of the tool T)
        marlin1: Marlin_main.cpp, gcode_M220 (S), gcode_M221 (flow_percentage of the tool T)
        prusa: Marlin_main.cpp, process_commands, case 220 (B, S, R), case 221 (extrudemultiply of all)
        bambu: start code of its printers: M220 S100; GCodeProcessor.cpp, process_M221 (S without T)
        klipper: gcode_move.py, cmd_M220, cmd_M221 (S is 100 without a number), _handle_activate_extruder (extrude_factor is 1)
        reprapfirmware: GCodes2.cpp, case 220, case 221 (extruder D, or those of the current tool)
        repetier: Commands.cpp, case 220, 221: getS(100), for all extruders
        smoothie: Robot.cpp, case 220; Extruder.cpp, M221 of the selected extruder
        sailfish: gpx.c, case 220 (speed_factor), case 221 (extrusion_factor of the tool T)
        cnc: interp_convert.cc, convert_m: no M220, M221
        ultigcode: Marlin_main.cpp, process_commands, case 220, case 221 (extrudemultiply of the active extruder)
        bfb: gcodeExport.cpp writes none
        grbl: gcode.c: unsupported
        """;

    // mm/s of a move with F600.
    private const string Speeds = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        M220 S50                    | 10  5  5  5  5  5  5  5  5  5 10  5 10 10
        M220 S50;M220               | 10  5  5  5  5 10  5 10  5  5 10  5 10 10
        M220 S50;M220 S200          | 10 20 20 20 20 20 20 20 20 20 10 20 10 10
        M220 S0                     | 10 10 10 10 10 10 10 10 10 10 10 10 10 10
        M220 S50;M220 B;M220 S80;M220 R | 10 5 8 5 8 10 8 10 8 8 10 8 10 10
        M220 S50;M220 B S80;M220 R S30  | 10 3 3 5 3 3 3 3 3 3 10 3 10 10
        """;

    // E that is deposited by a move with E1; of the last move where there are several.
    private const string Flows = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        M221 S50                    | 1  0.5 0.5 0.5 0.5 0.5 0.5 0.5 0.5 0.5 1  0.5 0  0
        M221 S50;M221               | 1  0.5 0.5 0.5 0.5 1   0.5 1   0.5 0.5 1  0.5 0  0
        M221 S50;T1                 | 1  1   1   0.5 0.5 1   1   0.5 1   1   1  1   0  0
        M221 S50;T1;T0              | 1  0.5 0.5 0.5 0.5 1   0.5 0.5 0.5 0.5 1  0.5 0  0
        M221 T1 S50;T1              | 1  0.5 0.5 0.5 1   1   1   0.5 1   0.5 1  1   0  0
        M221 D1 S50;T1              | 1  1   1   0.5 0.5 1   0.5 0.5 1   1   1  1   0  0
        """;

    private static IEnumerable<TestCaseData> SpeedCases() => ProgramTable.Cases(Speeds, Sources);

    private static IEnumerable<TestCaseData> FlowCases() => ProgramTable.Cases(Flows, Sources);

    [TestCaseSource(nameof(SpeedCases))]
    public void Speed_is_scaled(string program, string flavor, string speed, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program + ";G1 X10 F600", flavor).Toolpath[0].Speed), Is.EqualTo(speed), source);

    [TestCaseSource(nameof(FlowCases))]
    public void Material_is_scaled(string program, string flavor, string deposited, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program + ";G1 X10 E1", flavor).Toolpath.Moves().Select(m => m.Deposited).LastOrDefault()),
            Is.EqualTo(deposited), source);

    [Test]
    public void Words_stay_as_written_where_material_is_scaled()
    {
        var move = ProgramTable.Decode("M221 S50;G1 X10 E1;M221 S100;G1 X20 E2", "klipper").Toolpath;
        Assert.That(move.Moves().Select(m => m.E), Is.EqualTo(new[] { 1.0, 1.0 }), "the position of E stays");
        Assert.That(move[0].Kind, Is.EqualTo(MoveKind.Print));
    }
}

using System.Collections.Generic;
using System.Linq;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode.Flavors;

/// <summary>Changes of the tool, where E stands after them, and fans.</summary>
public class ToolTests
{
    private const string Sources = """
        slicer: GCodeProcessor.cpp, process_T; one position of E
        marlin2: gcode.cpp, case 'T'; module/tool_change.cpp: current_position.e is one for all
        marlin1: Marlin_main.cpp, gcode_T, tool_change: current_position[E_AXIS] is one for all
        prusa: Marlin_main.cpp, process_commands, T codes: current_position[E_AXIS] is one for all
        bambu: GCodeProcessor.cpp, process_T (255 and above are commands), process_M1020
        klipper: kinematics/extruder.py, cmd_ACTIVATE_EXTRUDER; gcode_move.py, _handle_activate_extruder (base_position[3] is last_position[3])
        reprapfirmware: GCodes2.cpp, HandleTcode; GCodes.cpp: latestVirtualExtruderPosition is one for all tools
        repetier: Extruder.cpp, selectExtruderById (extrudePosition of each extruder)
        smoothie: Robot.cpp, process_move (machine_position[selected_extruder])
        sailfish: gpx.c, gpx_convert_line (T, case 6, 108, 135; E is A or B by the extruder)
        cnc: interp_convert.cc, convert_tool_select, convert_tool_change: M6
        ultigcode: Marlin_main.cpp, process_commands, code_seen('T'): current_position[E_AXIS] is one for all
        bfb: gcodeExport.cpp, startExtruder (T), writeMoveBFB (M101, M201 …)
        grbl: gcode.c: T is only tracked, M6 is unsupported
        """;

    // Number of the tool that moves.
    private const string Tools = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        T1                          | 1  1  1  1  1  1  1  1  1  1  0  1  1  0
        T1;M6                       | 1  1  1  1  1  1  1  1  1  1  1  1  1  0
        M6 T1                       | 0  0  0  0  0  0  0  0  0  1  1  0  0  0
        M135 T1                     | 0  0  0  0  0  0  0  0  0  1  0  0  0  0
        M108 T1                     | 0  0  0  0  0  0  0  0  0  1  0  0  0  0
        M1020 S1                    | 0  0  0  0  1  0  0  0  0  0  0  0  0  0
        ACTIVATE_EXTRUDER EXTRUDER=extruder1 | 0 0 0 0 0 1 0 0 0 0 0 0 0  0
        M201                        | 0  0  0  0  0  0  0  0  0  0  0  0  1  0
        M301                        | 0  0  0  0  0  0  0  0  0  0  0  0  2  0
        M201 X500                   | 0  0  0  0  0  0  0  0  0  0  0  0  0  0
        M104 T1 S200                | 0  0  0  0  0  0  0  0  0  0  0  0  0  0
        T1;T255                     | 255 255 255 255 1 255 255 255 255 255 0 255 255 0
        T-1                         | 0  0  0  0  0  0  0  0  0  0  0  0  0  0
        """;

    // Change of E of the last move.
    private const string Changes = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G1 X1 E5;T1;G1 X2 E1        | -4 -4 -4 -4 -4  1 -4  1  1  1 -4 -4  0  0
        G1 X1 E5;T1;G1 X2 E1;T0;G1 X3 E6 | 5 5 5 5 5  6  5  1  1  1  5  5  0  0
        G1 X1 E5;T1;G92 E0;G1 X2 E1;T0;G1 X3 E6 | 5 5 5 5 5 6 5 1 1 1 5 5 0  0
        M83;G1 X1 E5;T1;G1 X2 E1    | 1  1  1  1  1  1  1  1  1  1 -4  1  0  0
        """;

    private const string FanSources = """
        slicer: GCodeProcessor.cpp, process_M106, process_M107; GCodeWriter.cpp, set_fan
        marlin2: temp/M106_M107.cpp
        marlin1: Marlin_main.cpp, gcode_M106, gcode_M107
        prusa: Marlin_main.cpp, process_commands, case 106, 107
        bambu: GCodeProcessor.cpp, process_M106, process_M107
        klipper: fan.py, cmd_M106, cmd_M107
        reprapfirmware: GCodes2.cpp, case 106 (S alone), case 107; StringParser.cpp, GetPwmValue (above 1 by 255)
        repetier: Commands.cpp, case 106, 107
        smoothie: switch of the configuration: M106, M107 with 0 to 255
        sailfish: gpx.c, case 106, 107, 126, 127: on or off
        cnc: GCodeWriter.cpp of PrusaSlicer, set_fan: M106 P for Mach3 and Machinekit
        ultigcode: Marlin_main.cpp, process_commands, case 106, 107
        bfb: gcodeExport.cpp, writeSpecificFanCommand
        grbl: gcode.c: unsupported
        """;

    // The speed of the fan, or no event.
    private const string Fans = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        M106 S127.5                 | 0.5 0.5 0.5 0.5 0.5 0.5 0.5 0.5 0.5 1   1   0.5 0.5 -
        M106 S1                     | 0.004 0.004 0.004 0.004 0.004 0.004 1 0.004 0.004 1 1 0.004 0.004 -
        M106 S0                     | 0   0   0   0   0   0   0   0   0   0   1   0   0   -
        M106 P127.5                 | -   -   -   -   -   1   -   -   -   -   0.5 -   -   -
        M106                        | 1   1   1   1   1   1   -   1   1   1   1   1   1   -
        M107                        | 0   0   0   0   0   0   0   0   0   0   0   0   0   -
        M126                        | 1   -   -   -   -   -   -   -   -   1   -   -   -   -
        M127                        | 0   -   -   -   -   -   -   -   -   0   -   -   -   -
        """;

    private static IEnumerable<TestCaseData> ToolCases() => ProgramTable.Cases(Tools, Sources);

    private static IEnumerable<TestCaseData> ChangeCases() => ProgramTable.Cases(Changes, Sources);

    private static IEnumerable<TestCaseData> FanCases() => ProgramTable.Cases(Fans, FanSources);

    [TestCaseSource(nameof(ToolCases))]
    public void A_tool_is_chosen(string program, string flavor, string tool, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program + ";G1 X1", flavor).Toolpath[0].Tool), Is.EqualTo(tool), source);

    [TestCaseSource(nameof(ChangeCases))]
    public void E_stands_somewhere_after_a_change(string program, string flavor, string change, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program, flavor).Toolpath.Moves().Select(m => m.E).LastOrDefault()), Is.EqualTo(change), source);

    [TestCaseSource(nameof(FanCases))]
    public void A_fan_turns(string program, string flavor, string speed, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program, flavor).Toolpath.Events.Select(e => e.Event).OfType<FanEvent>()
            .Select(f => (double?)f.Speed).SingleOrDefault()), Is.EqualTo(speed), source);

    [Test]
    public void RepRapFirmware_heats_tools_by_G10()
    {
        var toolpath = ProgramTable.Decode("G10 P1 S210 R160;G10 P1 X5", "reprapfirmware").Toolpath;
        Assert.That(toolpath.Events.Single().Event, Is.EqualTo(new NozzleTemperatureEvent(210, false, 1)));
        Assert.That(ProgramTable.Run("G10 P1 X5", "reprapfirmware").Diagnostics.Select(d => d.Code), Does.Contain("gcode.unsupported_motion"));
    }

    [Test]
    public void Retraction_is_balanced_for_each_tool()
    {
        var decoding = ProgramTable.Decode("M83;G1 X10 E1;G1 E-2;G1 X20;G1 X21 E0.5;G1 E2;G1 X30 E1;G1 X29 E-0.5;T1;G1 X28 E1;T0;G1 E0.5", "marlin2");
        Assert.That(decoding.Toolpath.Moves().Select(m => m.Kind), Is.EqualTo(new[]
        {
            MoveKind.Print, MoveKind.Retract, MoveKind.Travel, MoveKind.MovingDeretract, MoveKind.Deretract, MoveKind.Print, MoveKind.Wipe, MoveKind.Print,
                MoveKind.Deretract,
        }));
        Assert.That(decoding.Toolpath[4].Deposited, Is.EqualTo(0.5).Within(1e-12), "more is pushed than was pulled");
        Assert.That(ProgramTable.Decode("M83;G1 E3;G1 X1 E1", "marlin2").Toolpath[0].Kind, Is.EqualTo(MoveKind.Prime));
    }
}

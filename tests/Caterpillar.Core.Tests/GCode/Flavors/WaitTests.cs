using System.Collections.Generic;
using System.Linq;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode.Flavors;

/// <summary>Dwells and pauses.</summary>
public class WaitTests
{
    private const string DwellSources = """
        slicer: GCodeProcessor.cpp reads no G4; as Marlin
        marlin2: motion/G4.cpp, G4: P, then S in its place
        marlin1: Marlin_main.cpp, gcode_G4
        prusa: Marlin_main.cpp, process_commands, case 4
        bambu: GCodeProcessor.cpp, process_G4, process_M400: S, or else P
        klipper: toolhead.py, cmd_G4: P alone
        reprapfirmware: GCodes.cpp, DoDwell: S, or else P
        repetier: Commands.cpp, processGCode, case 4
        smoothie: Robot.cpp, on_gcode_received, case 4: delay_ms += S
        sailfish: gpx.c, gpx_convert_line, case 4: P alone
        cnc: interp_check.cc, check_g_codes; interp_convert.cc, convert_dwell: seconds
        ultigcode: Marlin_main.cpp, process_commands, case 4
        bfb: gcodeExport.cpp, writeDelay: G4 P in milliseconds
        grbl: gcode.c, NON_MODAL_DWELL; motion_control.c, mc_dwell: seconds
        """;

    // Seconds.
    private const string Dwells = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G4 P500                     | 0.5  0.5  0.5  0.5  0.5  0.5  0.5  0.5  0.5  0.5  500  0.5  0.5  500
        G4 S2                       | 2    2    2    2    2    0    2    2    2    0    0    2    0    0
        G4 S1 P500                  | 1    1    1    1    1    0.5  1    1    1.5  0.5  500  1    0.5  500
        G4 P500 S1                  | 1    1    1    1    1    0.5  1    1    1.5  0.5  500  1    0.5  500
        G4                          | 0    0    0    0    0    0    0    0    0    0    0    0    0    0
        M400 S2                     | 0    0    0    0    2    0    0    0    0    0    0    0    0    0
        M400 P500                   | 0    0    0    0    0.5  0    0    0    0    0    0    0    0    0
        """;

    private const string PauseSources = """
        slicer: what slicers write: Slic3r/PrintConfig.cpp (pause_print_gcode, color_change_gcode)
        marlin2: gcode.cpp, process_parsed_command: M0, M1, M25, M125, M600; M226 waits for a pin
        marlin1: Marlin_main.cpp, process_parsed_command: M0, M1, M25, M125, M600; M226 waits for a pin
        prusa: Marlin_main.cpp, process_commands: case 0, 1, 25, 125, 600, 601; M226 waits for a pin
        bambu: machine profiles of BambuStudio: M400 U1; M0, M1, M25 and M600 as in Marlin
        klipper: pause_resume.py, cmd_PAUSE; virtual_sdcard.py, cmd_M25; M600 by a macro
        reprapfirmware: GCodes2.cpp, case 25, 226, 600, 601; case 0, 1 end the print
        repetier: Commands.cpp, processMCode, case 25, 600; M226 waits for a pin
        smoothie: Player.cpp, on_gcode_received: M25, M600; M601 goes on
        sailfish: gpx.c, gpx_convert_line, case 1, 25, 71; case 0 does nothing
        cnc: interp_convert.cc, convert_stop: M0, M1, M60
        ultigcode: Marlin_main.cpp, process_commands: case 0, 1, 25, 600, 601
        bfb: gcodeExport.cpp writes none; M0 as most do
        grbl: gcode.c, PROGRAM_FLOW_PAUSED: M0; M1 is ignored
        """;

    // 1 where it waits for the user.
    private const string Pauses = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        M0                          | 1  1  1  1  1  0  0  0  0  0  1  1  1  1
        M1                          | 1  1  1  1  1  0  0  0  0  1  1  1  0  0
        M25                         | 1  1  1  1  1  1  1  1  1  1  0  1  0  0
        M60                         | 0  0  0  0  0  0  0  0  0  0  1  0  0  0
        M71                         | 0  0  0  0  0  0  0  0  0  1  0  0  0  0
        M125                        | 0  1  1  1  0  0  0  0  0  0  0  0  0  0
        M226                        | 1  0  0  0  0  0  1  0  0  0  0  0  0  0
        M600                        | 1  1  1  1  1  1  1  1  1  0  0  1  0  0
        M601                        | 1  0  0  1  0  0  1  0  0  0  0  1  0  0
        PAUSE                       | 1  0  0  0  0  1  0  0  0  0  0  0  0  0
        M400 U1                     | 0  0  0  0  1  0  0  0  0  0  0  0  0  0
        M400                        | 0  0  0  0  0  0  0  0  0  0  0  0  0  0
        """;

    private static IEnumerable<TestCaseData> DwellCases() => ProgramTable.Cases(Dwells, DwellSources);

    private static IEnumerable<TestCaseData> PauseCases() => ProgramTable.Cases(Pauses, PauseSources);

    [TestCaseSource(nameof(DwellCases))]
    public void A_dwell_takes_its_time(string program, string flavor, string seconds, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program, flavor).Toolpath.Events.Select(e => e.Event).OfType<DwellEvent>().Sum(d => d.Seconds)),
            Is.EqualTo(seconds), source);

    [TestCaseSource(nameof(PauseCases))]
    public void A_pause_waits_for_the_user(string program, string flavor, string count, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program, flavor).Toolpath.Events.Count(e => e.Event is PauseEvent)), Is.EqualTo(count), source);
}

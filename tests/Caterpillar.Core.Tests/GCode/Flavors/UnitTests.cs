using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode.Flavors;

/// <summary>Inches, and E as a volume.</summary>
public class UnitTests
{
    private const string Sources = """
        slicer: GCodeProcessor.cpp, process_G20, process_G1 (lengthsScaleFactor; E too)
        marlin2: gcode.cpp, case 20; parser.h, axis_unit_factor (volumetric_unit_factor), value_feedrate; config/M200-M205.cpp, M200
        marlin1: Marlin_main.cpp, gcode_G20, gcode_M200; parser.h, axis_unit_factor
        prusa: Marlin_main.cpp, process_commands: no case 20 of G; case 200 of M
        bambu: GCodeProcessor.cpp, process_G20, process_G1 (lengthsScaleFactor); no M200
        klipper: gcode_move.py, cmd_G20: an error; no M200
        reprapfirmware: GCodes2.cpp, case 20, case 200; GCodeBuffer.cpp, ConvertDistance, GetSpeed; GCodes.cpp, LoadExtrusionAndFeedrateFromGCode
        repetier: Printer.cpp, setDestinationStepsFromGCode (convertToMM, unitIsInches); Commands.cpp, case 200
        smoothie: Robot.cpp, process_move (to_millimeters of X Y Z I J K F, not of E); Extruder.cpp, M200
        sailfish: gpx.c, gpx_convert_line: no case 20; no case 200
        cnc: interp_convert.cc, convert_length_units; find_ends (A is an angle)
        ultigcode: Marlin_main.cpp, process_commands: no case 20 of G, no case 200 of M; UltiLCD2_menu_print.cpp (volume_to_filament_length)
        bfb: gcodeExport.cpp writes millimeters only
        grbl: gcode.c, UNITS_MODE_INCHES; no M200
        """;

    // X of the machine at the end.
    private const string PathSamples = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G20;G1 X1                   | 25.4 25.4 25.4 1    25.4 1    25.4 25.4 25.4 1    25.4 1    1    25.4
        G20;G21;G1 X1               | 1    1    1    1    1    1    1    1    1    1    1    1    1    1
        G21;G1 X1                   | 1    1    1    1    1    1    1    1    1    1    1    1    1    1
        G20;G91;G1 X1;G1 X1         | 50.8 50.8 50.8 2    50.8 2    50.8 50.8 50.8 2    50.8 2    2    50.8
        G1 X10;G20;G92 X1;G1 X2     | 35.4 35.4 35.4 11   35.4 11   35.4 35.4 35.4 11   35.4 11   11   35.4
        M120;G20;M121;G1 X1         | 25.4 25.4 25.4 1    25.4 1    1    25.4 1    1    25.4 1    1    25.4
        """;

    // The sum of E.
    private const string Sums = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G20;G1 X1 E1                | 25.4 25.4 25.4 1    25.4 1    25.4 25.4 1    1    1    1    0    0
        G20;G92 E1;G1 X1 E3         | 50.8 50.8 50.8 2    50.8 2    50.8 50.8 2    2    2    2    0    0
        M200 D1;G20;G1 X1 E1        | 25.4 16387.064 16387.064 1 25.4 1 25.4 25.4 1  1    1    1    0    0
        """;

    // mm/s of a move with F60.
    private const string Speeds = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G1 X1 F60                   | 1    1    1    1    1    1    1    1    1    1    1    1    1    1
        G20;G1 X1 F60               | 25.4 25.4 25.4 1    25.4 1    25.4 25.4 25.4 1    25.4 1    1    25.4
        """;

    // Length of a quarter of a circle of radius 1.
    private const string Arcs = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        G20;G3 X1 Y1 J1             | 39.898 39.898 39.898 1.571 39.898 1.571 39.898 39.898 39.898 0 39.898 1.571 0 39.898
        """;

    // mm³ of one unit of E, or - where the file does not say it.
    private const string Volumes = """
        |                       slicer marlin2 marlin1 prusa bambu klipper reprapfirmware repetier smoothie sailfish cnc ultigcode bfb grbl
        M105                        | - - - - - - - - - - - 1 - -
        M200 D1.75                  | - 1 1 1 - - 1 1 1 - - 1 - -
        M200 D0                     | - - - - - - - - - - - 1 - -
        M200 D1.75;M200 D0          | - - - - - - - - - - - 1 - -
        M200                        | - - - - - - - - - - - 1 - -
        """;

    private static IEnumerable<TestCaseData> PlaceCases() => ProgramTable.Cases(PathSamples, Sources);

    private static IEnumerable<TestCaseData> SumCases() => ProgramTable.Cases(Sums, Sources);

    private static IEnumerable<TestCaseData> SpeedCases() => ProgramTable.Cases(Speeds, Sources);

    private static IEnumerable<TestCaseData> ArcCases() => ProgramTable.Cases(Arcs, Sources);

    private static IEnumerable<TestCaseData> VolumeCases() => ProgramTable.Cases(Volumes, Sources);

    [TestCaseSource(nameof(PlaceCases))]
    public void Places_are_inches_or_mm(string program, string flavor, string x, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.X(ProgramTable.Decode(program, flavor))), Is.EqualTo(x), source);

    [TestCaseSource(nameof(SumCases))]
    public void E_is_inches_or_mm(string program, string flavor, string sum, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program, flavor).Report.ENet), Is.EqualTo(sum), source);

    [TestCaseSource(nameof(SpeedCases))]
    public void F_is_inches_or_mm(string program, string flavor, string speed, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program, flavor).Toolpath[0].Speed), Is.EqualTo(speed), source);

    [TestCaseSource(nameof(ArcCases))]
    public void Centers_are_inches_or_mm(string program, string flavor, string length, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program, flavor).Report.TravelLength + ProgramTable.Decode(program, flavor).Report.PrintLength),
            Is.EqualTo(length), source);

    [TestCaseSource(nameof(VolumeCases))]
    public void E_is_a_volume_or_a_length(string program, string flavor, string volume, string source)
        => Assert.That(ProgramTable.Text(ProgramTable.Decode(program + ";G1 X1 E1", flavor).Toolpath.Tools[0].VolumePerE), Is.EqualTo(volume), source);

    [TestCase("klipper")]
    [TestCase("prusa")]
    public void Inches_that_are_refused_are_reported(string flavor)
        => Assert.That(ProgramTable.Run("G20;G1 X1", flavor).Diagnostics.Select(d => d.Code), Does.Contain("gcode.inches"));

    [Test]
    public void A_file_may_say_the_diameter_of_its_filament()
        => Assert.That(ProgramTable.Decode("G1 X1 E1;; filament_diameter = 2", "marlin2").Toolpath.Tools[0].VolumePerE,
            Is.EqualTo(System.Math.PI).Within(1e-12).Or.Null);
}

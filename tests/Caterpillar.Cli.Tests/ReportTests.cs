using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>Whole reports, as they are read.</summary>
public class ReportTests : CliFixture
{
    private const string TwoTools = """
        ; filament_diameter = 1.75
        G28
        M104 S200 T0
        M109 S200 T0
        M83
        G4 S2
        T0
        ;LAYER_CHANGE
        ;Z:0.2
        ;HEIGHT:0.2
        ;TYPE:External perimeter
        G1 X10 Y10 Z0.2 F3000
        G1 X60 E2 F1200
        G1 E-1 F1800
        G1 X10 Y20 F6000
        G1 E1 F1800
        ;TYPE:Internal infill
        G1 X60 E2 F2400
        T1
        ;LAYER_CHANGE
        ;Z:0.4
        ;HEIGHT:0.2
        ;TYPE:External perimeter
        G1 Z0.4
        G1 X10 E2 F1200
        ;LAYER_CHANGE
        ;Z:0.6
        ;HEIGHT:0.2
        ;TYPE:Internal infill
        G1 Z0.6
        G1 X12 E0.1
        G1 X60 Y25 F6000
        G1 X10 E2 F600
        M84

        """;

    [Test]
    public void Statistics_of_two_tools_and_three_layers()
    {
        File.WriteAllText("two.gcode", TwoTools);
        Same(Run("decode", "two.gcode", "--stats", "--set", "cost_per_kg=20", "--set", "density_g_cm3=1.24"), """
            two.gcode: Marlin 2 (The file does not state its G-code flavor.)
              Printed      202 mm in 5 moves, 3 layers
              Traveled     113.793 mm in 5 moves, 1 retraction
              Extruded     8.1 mm of E, net 8.1 mm
              Printed box  10, 10, 0.2 to 60, 25, 0.6 mm
              All moves    10, 10, 0.2 to 60, 25, 0.6 mm
              Outer wall   100 mm, 0.524 mm wide, 0.096 mm² on average
              Infill       102 mm, 0.526 mm wide, 0.097 mm² on average
              Ignored: M84 ×1
              Time           1 min 45 s with the limits of printer generic
              Printing       11.44 s
              Traveling      1.62 s
              Extruder only  0.11 s, 1 retraction
              Heating        1 min 30 s
              Dwells         2 s
              Material       8.1 mm of filament, 0.02 cm³, 0.02 g, costs 0
              Maximum flow   3.85 mm³/s in move 6
              Maximum speed  100 mm/s

              Role        time    share  length  material
              Outer wall  5.03 s  4.8 %  0.1 m   0.01 cm³
              Infill      6.42 s  6.1 %  0.1 m   0.01 cm³

              Tool  time    filament  mass
              0     4.83 s  4 mm      0.01 g
              1     8.34 s  4.1 mm    0.01 g

              3 layers of 2.59 s to 5.74 s. The slowest starts after 1 min 39 s.
              2.6 s  1  ████████████████████████████████████████
              2.9 s  0
              3.2 s  0
              3.5 s  0
              3.9 s  0
              4.2 s  0
              4.5 s  0
              4.8 s  1  ████████████████████████████████████████
              5.1 s  0
              5.4 s  1  ████████████████████████████████████████

            """);
        Assert.That(Run("decode", "two.gcode", "--stats", "--csv").Code, Is.EqualTo(2));
        Assert.That(Run("decode", "two.gcode", "--json", "--csv").Code, Is.EqualTo(2));
    }

    [Test]
    public void The_state_of_the_machine_at_a_line()
    {
        File.WriteAllText("two.gcode", TwoTools);
        Same(Run("simulate", "two.gcode", "--at", "line:20"), """
            1 min 45 s with the limits of printer generic

              Time    1 min 37 s, 8.34 s left
              Move    7 of 13 (0 % done), line 24
              Action  Travel
              Nozzle  60, 20, 0.2 mm, tool 1
              Speed   0 mm/s, 0 mm³/s
              Layer   1, Z 0.4 mm
              Heat    nozzle 20 of 0 °C, bed 20 of 0 °C, fan 0 %
              So far  0.165 m of path, 4 of E, 0.01 cm³

            """);
    }

    [Test]
    public void Sections_as_a_table_and_for_programs()
    {
        File.WriteAllText("part.stl", Box(20, 10, 2));
        Same(Run("sections", "part.stl", "--every", "0.8"), """
            part.stl
            Z mm      LENGTH mm  AREA mm²  OUTER  HOLES  OPEN ENDS
            0.4       60         200       1      0      0
            1.2       60         200       1      0      0

            """);
        Same(Run("sections", "part.stl", "--every", "0.8", "--json"), """
            [
             {"model": "part.stl", "sections": [
              {"z": 0.4, "length": 60, "area": 200, "outer": 1, "holes": 0, "open": 0},
              {"z": 1.2, "length": 60, "area": 200, "outer": 1, "holes": 0, "open": 0}
             ]}
            ]

            """);
        Assert.That(Run("sections", "part.stl", "--every", "0.8", "-o", "table.txt").Output, Is.Empty);
        Assert.That(File.ReadAllText("table.txt").Split('\n').Count(l => l.Contains("200")), Is.EqualTo(2));
        Assert.That(Run("sections", "part.stl", "--every", "1e-9").Code, Is.EqualTo(2));
    }

    [Test]
    public void A_box_selects_what_is_inside_of_its_two_corners()
    {
        File.WriteAllText("two.gcode", TwoTools);
        Assert.That(Run("convert", "two.gcode", "-o", "o.gcode", "--box", "1,2").Code, Is.EqualTo(2));
        Assert.That(Run("convert", "two.gcode", "-o", "o.gcode", "--box", "0,0,0.3,99,99,0.5", "--flow", "2").Code, Is.Zero);
        Assert.That(Changed("o.gcode"), Is.EqualTo(new[] { "G1 X10 E4 F1200" }));
        Assert.That(Run("convert", "two.gcode", "-o", "p.gcode", "--box", "99,99,0.5,0,0,0.3", "--flow", "2").Code, Is.Zero);
        Assert.That(Changed("p.gcode"), Is.EqualTo(Changed("o.gcode")));
    }

    private static string[] Changed(string file) => File.ReadAllLines(file).Except(TwoTools.Split('\n')).ToArray();

    private static void Same(CliRun run, string expected)
    {
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(run.Text.Replace("\r\n", "\n"), Is.EqualTo(expected));
    }

    [Test]
    public void Help_of_a_verb_ends_with_its_examples()
    {
        var help = Run("sections", "--help").Text;
        Assert.That(help, Does.Contain("Examples:\n  # ").And.Contain("\n  caterpillar sections "));
    }

    [TestCase(5.25, "5.25 s")]
    [TestCase(59.999, "60 s")]
    [TestCase(60, "1 min 0 s")]
    [TestCase(3599.4, "59 min 59 s")]
    [TestCase(3600, "1 h 0 min 0 s")]
    [TestCase(90061, "25 h 1 min 1 s")]
    public void Times_have_hours_minutes_and_seconds(double seconds, string text) => Assert.That(StatisticsText.Duration(seconds), Is.EqualTo(text));
}

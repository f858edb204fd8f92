using System.Linq;
using System.Text;
using Caterpillar.Flavors;
using NUnit.Framework;

namespace Caterpillar.Tests.Flavors;

/// <summary>Commands in the words of another flavor, and how the words of a line are found.</summary>
[Category("Arithmetic")]
public class EquivalentTests
{
    [TestCase("M900 K0.05", "marlin2", "klipper", "SET_PRESSURE_ADVANCE ADVANCE=0.05")]
    [TestCase("m900 k0.05", "marlin2", "klipper", "SET_PRESSURE_ADVANCE ADVANCE=0.05")]
    [TestCase("SET_PRESSURE_ADVANCE EXTRUDER=extruder ADVANCE=0.05", "klipper", "reprapfirmware", "M572 D0 S0.05")]
    [TestCase("M572 D0 S0.05", "reprapfirmware", "marlin2", "M900 K0.05")]
    [TestCase("M900 K0.05", "marlin2", "smoothie", "")]
    [TestCase("M900 K0.05", "marlin2", "unknown", "")]
    [TestCase("M593 F40", "marlin2", "klipper", "SET_INPUT_SHAPER SHAPER_FREQ_X=40 SHAPER_FREQ_Y=40")]
    [TestCase("M593", "marlin2", "klipper", null)]
    [TestCase("TURN_OFF_HEATERS", "klipper", "marlin2", "M104 S0|M140 S0")]
    [TestCase("SET_HEATER_TEMPERATURE HEATER=heater_bed TARGET=60", "klipper", "marlin2", "M140 S60")]
    [TestCase("SET_HEATER_TEMPERATURE HEATER=extruder TARGET=200", "klipper", "marlin2", "M104 S200")]
    [TestCase("SET_HEATER_TEMPERATURE HEATER=other TARGET=200", "klipper", "marlin2", null)]
    [TestCase("SET_HEATER_TEMPERATURE HEATER=extruder", "klipper", "marlin2", null)]
    [TestCase("BED_MESH_PROFILE LOAD=default", "klipper", "marlin2", "M420 S1")]
    [TestCase("BED_MESH_PROFILE LOAD=other", "klipper", "marlin2", null)]
    [TestCase("M420 S0", "marlin2", "klipper", "BED_MESH_CLEAR")]
    [TestCase("M117 Layer 3 of 9", "marlin2", "klipper", "SET_DISPLAY_TEXT MSG=Layer 3 of 9")]
    [TestCase("SET_DISPLAY_TEXT MSG=\"Layer 3 of 9\"", "klipper", "marlin2", "M117 Layer 3 of 9")]
    [TestCase("RESPOND MSG=hello", "klipper", "reprapfirmware", "M118 hello")]
    [TestCase("M73 P40", "marlin2", "repetier", "M532 X40 L0")]
    [TestCase("M73 L7", "bambu", "klipper", "SET_PRINT_STATS_INFO CURRENT_LAYER=7")]
    [TestCase("G28", "marlin2", "klipper", null)]
    [TestCase("M900 K1", "unknown", "klipper", null)]
    public void A_line_becomes_the_lines_of_its_row(string line, string from, string to, string? expected)
        => Assert.That(Equivalents.Of(line, from, to) is { } lines ? string.Join("|", lines) : null, Is.EqualTo(expected));

    [TestCase("SET_HEATER_TEMPERATURE HEATER=chamber TARGET=50", "M141 S50")]
    [TestCase("SET_HEATER_TEMPERATURE HEATER=heater_bed TARGET=60", "M140 S60")]
    public void Heaters_of_Klipper_are_known_by_their_names(string line, string expected)
        => Assert.That(Equivalents.Of(line, "klipper", "marlin2"), Is.EqualTo(new[] { expected }));

    [TestCase("marlin2", "klipper", "M900 M420 G29")]
    [TestCase("klipper", "marlin2", "SET_PRESSURE_ADVANCE BED_MESH_PROFILE BED_MESH_CLEAR BED_MESH_CALIBRATE")]
    [TestCase("marlin2", "prusa", "G29")]
    [TestCase("marlin2", "marlin1", "")]
    [TestCase("marlin2", "unknown", "")]
    [TestCase("unknown", "marlin2", "")]
    public void Some_commands_are_always_translated(string from, string to, string commands)
        => Assert.That(string.Join(" ", Equivalents.AlwaysOf(from, to)), Is.EqualTo(commands));

    [TestCase("G1 X5 Y0", "X", true)]
    [TestCase("G1 x5", "X", true)]
    [TestCase("G1 X5", "Y", false)]
    [TestCase("G1 X5", "!Y", true)]
    [TestCase("G1 X5", "!X", false)]
    [TestCase("M420 S1", "S1", true)]
    [TestCase("M420 S1.0", "S1", true)]
    [TestCase("M420 S10", "S1", false)]
    [TestCase("M420 S12", "S12", true)]
    [TestCase("M420 S", "S0", false)]
    [TestCase("M420 Z S0", "S0 !X", true)]
    [TestCase("M420 Z S0", "S0 X", false)]
    [TestCase("M98 P\"X.g\" S1", "X", false)]
    [TestCase("M98 P\"a.g\" X1", "X", true)]
    [TestCase("M98 P\"a.g X1", "X", false)]
    [TestCase("M552 I am Here", "~here", true)]
    [TestCase("M552 I am her", "~here", false)]
    [TestCase("M552 I am Here", "~here S0", false)]
    [TestCase("M552", "", true)]
    public void Words_choose_among_the_rows_of_a_command(string line, string when, bool fits)
        => Assert.That(Text(line).Fits(when), Is.EqualTo(fits));

    [TestCase("G1 X5", true, "G1")]
    [TestCase("  g01X5", true, "G1")]
    [TestCase("G 028", true, "G28")]
    [TestCase("G0", true, "G0")]
    [TestCase("G00", true, "G0")]
    [TestCase("G29.1", true, "G29.1")]
    [TestCase("G92.0 X0", true, "G92")]
    [TestCase("T-1", true, "T-1")]
    [TestCase("START_PRINT A=1", false, "START_PRINT")]
    [TestCase("G1_MACRO", false, "G1_MACRO")]
    [TestCase("$H=5", false, "$H")]
    [TestCase("macro*7", false, "MACRO")]
    [TestCase("M", false, "M")]
    [TestCase("   ", false, "")]
    public void The_name_of_a_command_is_a_letter_with_a_number_or_a_word(string line, bool isCode, string name)
    {
        var text = Text(line);
        Assert.That((text.IsCode, text.Length), Is.EqualTo((isCode, name.Length)));
        Assert.That(string.Concat(Enumerable.Range(0, name.Length).Select(i => Text(line)[i])), Is.EqualTo(name));
        Assert.That(text.Hash(name.Length), Is.EqualTo(CommandText.HashOf(name)));
        Assert.That((text.Begins(name, name.Length), text.Begins(name + "1", name.Length + 1)), Is.EqualTo((true, false)));
        if (name.Length > 0) Assert.That(text.Begins("?", 1), Is.False);
    }

    private static CommandText Text(string line)
    {
        var bytes = Encoding.ASCII.GetBytes(line);
        return new CommandText(bytes, 0, bytes.Length);
    }

    [TestCase(0.002, 0.0005, 0.001, 10, 10.0004, false)]
    [TestCase(0.5, 0.0005, 0.001, 10, 10.011, true)]
    [TestCase(0.5, 0.0005, 0.001, 10, 10.009, false)]
    [TestCase(0.5, 0.005, 0.001, 1, 1.004, false)]
    [TestCase(0.5, 0.0005, 0.1, 10, 10.6, true)]
    public void Arcs_are_refused_whose_radii_differ_too_much(double largest, double smallest, double relative, double start, double end, bool isRefused)
        => Assert.That(new ArcTolerance(smallest, largest, relative).Refuses(start, end), Is.EqualTo(isRefused));
}

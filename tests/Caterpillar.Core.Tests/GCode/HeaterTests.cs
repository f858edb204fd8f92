using System.Linq;
using System.Text;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Commands that heat, by the rules of their firmware.</summary>
[Category("Arithmetic")]
public class HeaterTests
{
    private static DecodedGCode Decode(string flavor, string text)
        => GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text), new DecodeOptions { Flavor = FlavorTable.Find(flavor)! }).Value!;

    private static string Events(string flavor, string text)
        => string.Join("; ", Decode(flavor, text).Toolpath.Events.Select(e => e.Event switch
        {
            NozzleTemperatureEvent n => With(n.Tool is { } tool ? $"nozzle {tool} {n.Celsius}" : $"nozzle {n.Celsius}", n.Wait),
            BedTemperatureEvent b => With($"bed {b.Celsius}", b.Wait),
            ChamberTemperatureEvent c => With($"chamber {c.Celsius}", c.Wait),
            var other => other.GetType().Name,
        }));

    private static string With(string text, bool wait) => text + (wait ? " wait" : "");

    [TestCase("marlin2", "M104 S200", "nozzle 200")]
    [TestCase("marlin2", "M109 S200", "nozzle 200 wait")]
    [TestCase("marlin2", "M104 T1 S200", "nozzle 1 200")]
    [TestCase("marlin2", "M140 S60", "bed 60")]
    [TestCase("marlin2", "M190 S60", "bed 60 wait")]
    [TestCase("marlin2", "M141 S45", "chamber 45")]
    [TestCase("marlin2", "M191 S45", "chamber 45 wait")]
    [TestCase("klipper", "SET_HEATER_TEMPERATURE HEATER=heater_bed TARGET=60", "bed 60")]
    [TestCase("klipper", "SET_HEATER_TEMPERATURE HEATER=Heater_Bed", "bed 0")]
    [TestCase("klipper", "SET_HEATER_TEMPERATURE HEATER=chamber TARGET=45", "chamber 45")]
    [TestCase("klipper", "SET_HEATER_TEMPERATURE HEATER=extruder1 TARGET=210", "nozzle 1 210")]
    [TestCase("klipper", "SET_HEATER_TEMPERATURE HEATER=dryer TARGET=50", "")]
    [TestCase("klipper", "TURN_OFF_HEATERS", "bed 0; nozzle 0")]
    [TestCase("marlin2", "TURN_OFF_HEATERS", "")]
    [TestCase("reprapfirmware", "M568 P1 S215", "nozzle 1 215")]
    [TestCase("reprapfirmware", "M568 P1 A0", "nozzle 1 0")]
    [TestCase("reprapfirmware", "G10 P1 S215", "nozzle 1 215")]
    [TestCase("marlin2", "M568 P1 S215", "")]
    public void A_command_heats_what_it_names(string flavor, string line, string events) => Assert.That(Events(flavor, line + "\n"), Is.EqualTo(events));

    [TestCase("marlin2", "M141 S45")]
    [TestCase("marlin2", "M104 S200")]
    [TestCase("reprapfirmware", "M568 P1 S215")]
    [TestCase("reprapfirmware", "M568 P1 A0")]
    [TestCase("marlin2", "M106 S128")]
    [TestCase("marlin2", "M400")]
    public void What_is_read_as_an_event_is_not_counted_as_unread(string flavor, string line)
        => Assert.That(Decode(flavor, line + "\n").Ignored, Is.Empty);
}

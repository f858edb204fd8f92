using System.Collections.Generic;
using System.Linq;
using Caterpillar.Flavors;
using NUnit.Framework;

namespace Caterpillar.Tests.Flavors;

/// <summary>The table of commands, and its lookup.</summary>
public class FlavorCommandTests
{
    [TestCase("marlin2", "M206 Z-5", "M206", "Never")]
    [TestCase("marlin2", "m0206z-5", "M206", "Never")]
    [TestCase("marlin2", "M 206 Z-5", "M206", "Never")]
    [TestCase("repetier", "M206 T3 P5 X2", "M206", "Never")]
    [TestCase("klipper", "M206 Z-5", "M206", "Ignored")]
    [TestCase("marlin2", "G28 X Y", "G28", "Tracked")]
    [TestCase("marlin2", "G28 X Z", "G28", "Start")]
    [TestCase("marlin2", "G28", "G28", "Start")]
    [TestCase("marlin2", "M84 S0", "M84", "Ok")]
    [TestCase("marlin2", "M84 E", "M84", "Depends")]
    [TestCase("marlin2", "M84 X E", "M84", "End")]
    [TestCase("marlin2", "M84", "M84", "End")]
    [TestCase("reprapfirmware", "M0", "M0", "End")]
    [TestCase("marlin2", "M0", "M0", "Pause")]
    [TestCase("reprapfirmware", "G10 L20 P1 X0", "G10", "Tracked")]
    [TestCase("reprapfirmware", "G10 P1 X5", "G10", "Untracked")]
    [TestCase("reprapfirmware", "G29 S1", "G29", "Start")]
    [TestCase("bambu", "G29.20 A3", "G29.20", "Start")]
    [TestCase("bambu", "G29.2 S0", "G29.2", "Start")]
    [TestCase("bambu", "M1002 gcode_claim_action : 14", "M1002", "Ok")]
    [TestCase("bambu", "M1002 judge_flag g29_before_print_flag", "M1002", "Depends")]
    [TestCase("bambu", "T1000", "T1000", "Depends")]
    [TestCase("bambu", "T1", "T", "Tracked")]
    [TestCase("prusa", "M862.3 P \"MK3S\"", "M862.3", "Start")]
    [TestCase("marlin2", "M862.3 P \"MK4\"", "M862.3", "Start")]
    [TestCase("prusa", "D-1", "D-1", "Never")]
    [TestCase("prusa", "T?", "T?", "Depends")]
    [TestCase("klipper", "set_pin PIN=fan VALUE=1", "SET_PIN", "Depends")]
    [TestCase("klipper", "RESPOND TYPE=command MSG=action:pause", "RESPOND", "Depends")]
    [TestCase("klipper", "RESPOND MSG=\"hello\"", "RESPOND", "Ok")]
    [TestCase("klipper", "MMU_CHANGE_TOOL TOOL=1", "MMU_*", "Depends")]
    [TestCase("grbl", "$H", "$H", "Never")]
    [TestCase("grbl", "$130=200", "$", "Ok")]
    [TestCase("grbl", "o100 if [#1 GT 2]", "O", "Depends")]
    [TestCase("reprapfirmware", "while iterations < 3", "WHILE", "Depends")]
    [TestCase("slicer", "M620 S0A", "M620", "Depends")]
    public void A_command_means_what_its_firmware_does(string flavor, string line, string name, string use)
    {
        var found = FlavorCommands.Of(FlavorTable.Find(flavor)!).Find(line);
        Assert.That((found?.Name, found?.Use.ToString()), Is.EqualTo((name, use)));
    }

    [TestCase("marlin2", "START_PRINT")]
    [TestCase("marlin2", "M862.9")]
    [TestCase("marlin2", "M620 S0A")]
    [TestCase("klipper", "MY_MACRO")]
    [TestCase("klipper", "M12345")]
    [TestCase("marlin2", "")]
    [TestCase("marlin2", "  ")]
    [TestCase("marlin2", "G")]
    [TestCase("marlin2", "G.5")]
    [TestCase("grbl", "M104 S200")]
    public void Other_commands_are_unknown(string flavor, string line)
        => Assert.That(FlavorCommands.Of(FlavorTable.Find(flavor)!).Find(line), Is.Null);

    [Test]
    public void Every_row_has_an_effect_known_sources_and_flavors_and_can_be_reached()
    {
        var names = FlavorTable.All.Select(f => f.Name).Concat(["buddy", "fluidnc"]).ToHashSet();
        var sources = CommandTable.Sources.Select(s => s.Key).ToHashSet();
        foreach (var row in CommandTable.Rows)
        {
            Assert.That(row.Flavors, Is.SubsetOf(names), row.Commands[0].Name);
            foreach (var command in row.Commands)
            {
                Assert.That(command.Effect, Is.Not.Empty, command.Name);
                Assert.That(command.Source.Split(' '), Is.SubsetOf(sources), command.Name);
                foreach (var flavor in row.Flavors) Reached(flavor, command);
            }
        }
    }

    [Test]
    public void A_lookup_compares_the_name_not_only_its_hash()
    {
        var commands = FlavorCommands.Of(FlavorTable.Klipper);
        var known = CommandTable.Rows.SelectMany(r => r.Commands).Select(c => c.Name).ToHashSet();
        var seen = new List<string>();
        for (var i = 0; i < 100_000; i++)
        {
            var name = "X" + i.ToString(System.Globalization.CultureInfo.InvariantCulture) + "_MACRO";
            if (!known.Contains(name) && commands.Find(name) is not null) seen.Add(name);
        }
        Assert.That(seen, Is.Empty);
    }

    /// <summary>A line of which the command is the meaning.</summary>
    internal static string LineOf(FlavorCommand command)
    {
        var words = command.When.Split(' ').Where(w => w.Length > 0 && w[0] != '!').Select(w => w.TrimStart('~'));
        var name = command.Name is "T" or "O" or "S" or "F" ? command.Name + "1" : command.Name.TrimEnd('*');
        return string.Join(" ", new[] { name }.Concat(words));
    }

    private static void Reached(string flavor, FlavorCommand command)
    {
        var rules = FlavorTable.Find(flavor switch { "buddy" => "marlin2", "fluidnc" => "grbl", _ => flavor })!;
        var found = FlavorCommands.Of(rules).Find(LineOf(command));
        // Marlin 2 and Grbl have some commands of their versions themselves.
        if (flavor is "buddy" or "fluidnc") Assert.That(found, Is.Not.Null, flavor + " " + LineOf(command));
        else Assert.That(found, Is.EqualTo(command), flavor + " " + LineOf(command));
    }
}

using System.IO;
using System.Linq;
using System.Text;
using System.Threading;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class TurtleTests : CliFixture
{
    private const string Square = "param side = 10\nstart 50 50 0.2\nrate 600\nrepeat 4 [ forward side; left 90 ]\n";

    [Test]
    public void A_script_becomes_a_file_with_its_name()
    {
        File.WriteAllText("square.turtle", Square);
        var run = Run("turtle", "square.turtle");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(Files(), Is.EqualTo(new[] { "square.gcode", "square.turtle" }));
        Assert.That(Prints(File.ReadAllText("square.gcode")), Is.EqualTo(new[] { "G1 X60 E0.5 F600", "G1 Y60 E0.5", "G1 X50 E0.5", "G1 Y50 E0.5" }));
    }

    [Test]
    public void A_script_names_its_printer_and_an_option_names_another()
    {
        // 2 × 1 mm at 20 mm/s: 40 mm³/s, more than the default printer melts.
        var script = Encoding.UTF8.GetBytes("use \"potter_super\"\nbead 2 1\nspeed 20\nstart 50 50 1\nforward 10");
        Assert.That(Run(script, ["turtle", "-"]).Code, Is.Zero);
        Assert.That(Run(script, ["turtle", "-", "--printer", "generic"]).Code, Is.EqualTo(3));
        Assert.That(Run(Encoding.UTF8.GetBytes("use \"poter_super\"\nforward 1"), ["turtle", "-"]).Messages, Does.Contain("potter_super"));
    }

    [Test]
    public void Parameters_seed_and_filament_come_from_outside()
    {
        var run = Run(Encoding.UTF8.GetBytes(Square), ["turtle", "-", "--var", "side=20", "--set", "filament_diameter_mm=2.85"]);
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(Prints(run.Text).First(), Is.EqualTo("G1 X70 E1 F600"), "the E factor is mm of filament, whatever its diameter");
        byte[] random = Encoding.UTF8.GetBytes("start 50 50 0.2\nrepeat 3 [ forward random(1, 9) ]");
        Assert.That(Run(random, ["turtle", "-", "--seed", "3"]).Output,
            Is.EqualTo(Run(random, ["turtle", "-", "--seed", "3"]).Output).And.Not.EqualTo(Run(random, ["turtle", "-"]).Output));
        Assert.That(Run(random, ["turtle", "-"]).Output, Is.EqualTo(Run(random, ["turtle", "-", "--seed", "0"]).Output));
    }

    [Test]
    public void The_printer_plan_retracts_where_the_drawn_one_does_not()
    {
        var script = Encoding.UTF8.GetBytes("start 50 50 0.2\nforward 10\npenup\nforward 30\npendown\nforward 10");
        Assert.That(string.Join(" ", Prints(Run(script, ["turtle", "-"]).Text)), Does.Not.Contain("E-"));
        Assert.That(Prints(Run(script, ["turtle", "-", "--plan", "printer"]).Text), Does.Contain("G1 E-0.8 F2100"));
    }

    [TestCase("forwrd 10", 1, "standard input:1:1: error turtle.unknown: Unknown command 'forwrd'. Did you mean 'forward'?")]
    [TestCase("forward 1\nforward 1 / 0", 1, "standard input:2:9: error turtle.not_finite")]
    [TestCase("left 90", 1, "prints nothing")]
    [TestCase("forward 1000", 3, "bed.outside")]
    public void Bad_programs_are_reported_and_nothing_is_written(string script, int code, string message)
    {
        var run = Run(Encoding.UTF8.GetBytes(script), ["turtle", "-", "-o", "out.gcode"]);
        Assert.That((run.Code, Files().Length), Is.EqualTo((code, 0)), run.Messages);
        Assert.That(run.Messages, Does.Contain(message));
    }

    [TestCase("turtle")]
    [TestCase("turtle", "square.turtle", "--var", "side")]
    [TestCase("turtle", "square.turtle", "--var", "side=x")]
    [TestCase("turtle", "square.turtle", "--var", "side=1", "--var", "side=2")]
    [TestCase("turtle", "square.turtle", "--plan", "wild")]
    [TestCase("turtle", "square.turtle", "--squeeze", "0.1")]
    [TestCase("turtle", "square.turtle", "--in-place")]
    [TestCase("turtle", "square.turtle", "--printer", "nobody")]
    public void Wrong_values_are_wrong_usage(params string[] words)
    {
        File.WriteAllText("square.turtle", Square);
        Assert.That(Run(words).Code, Is.EqualTo(2));
    }

    [Test]
    public void A_missing_script_and_an_interruption_have_their_codes()
    {
        Assert.That(Run("turtle", "none.turtle").Code, Is.EqualTo(1));
        using var stop = new CancellationTokenSource();
        stop.Cancel();
        Assert.That(Run(Encoding.UTF8.GetBytes("repeat 1000000 [ left 1 ]"), ["turtle", "-"], stop.Token).Code, Is.EqualTo(130));
    }

    [Test]
    public void Printed_lines_go_to_standard_error_as_they_are()
    {
        var run = Run(Encoding.UTF8.GetBytes("start 50 50 0.2\nforward 10\nprint \"at {turtle_x}\"\nprint 1 + 1"), ["turtle", "-"]);
        Assert.That(run.Code, Is.Zero);
        Assert.That(run.Messages.Replace("\r", ""), Does.StartWith("at 60\n2\n"));
        Assert.That(run.Text, Does.Not.Contain("at 60"));
    }

    [Test]
    public void Files_are_included_from_the_folder_of_the_script_and_from_allowed_ones()
    {
        Directory.CreateDirectory("a/lib");
        Directory.CreateDirectory("b");
        File.WriteAllText("a/lib/square.turtle", "def square side [ repeat 4 [ forward side; left 90 ] ]\n");
        File.WriteAllText("b/more.turtle", "square 10\n");
        File.WriteAllText("a/main.turtle", "start 50 50 0.2\ninclude \"lib/square.turtle\"\ninclude \"more.turtle\"\n");
        var missing = Run("turtle", "a/main.turtle", "-o", "x.gcode");
        Assert.That(missing.Code, Is.EqualTo(1));
        Assert.That(missing.Messages, Does.Contain("a/main.turtle:3:9: error turtle.file: File 'more.turtle' not found."));
        Assert.That(Run("turtle", "a/main.turtle", "-o", "x.gcode", "--include", "b").Code, Is.Zero);
        Assert.That(Run("turtle", "a/main.turtle", "-o", "x.gcode", "--include", "nowhere").Code, Is.EqualTo(2));
    }

    [Test]
    public void The_memory_limit_stops_a_script()
    {
        var run = Run(Encoding.UTF8.GetBytes("repeat 1000000 [ push ]"), ["turtle", "-", "--memory-limit", "64MB"]);
        Assert.That(run.Code, Is.EqualTo(1));
        Assert.That(run.Messages, Does.StartWith("standard input:1:").And.Contain("memory.limit"));
    }

    [Test]
    public void The_commands_of_the_language_are_listed()
    {
        var run = Run("turtle", "--commands");
        Assert.That(run.Code, Is.Zero);
        Assert.That(run.Text, Does.Contain("forward distance [rise]"));
    }

    // Between the start and the end code.
    private static string[] Prints(string gcode)
        => gcode.Split('\n').SkipWhile(l => l != ";TYPE:Unspecified").TakeWhile(l => l != ";TYPE:Custom")
            .Where(l => l.StartsWith("G1 ", System.StringComparison.Ordinal)).ToArray();
}

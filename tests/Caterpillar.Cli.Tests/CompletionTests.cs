using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>What shells complete, asked of the shells themselves where they are installed.</summary>
public class CompletionTests : CliFixture
{
    [Test]
    public void Every_verb_and_option_is_completed()
    {
        Assert.That(Completed("caterpillar "), Is.SupersetOf(Verbs.All().Select(v => v.Name)));
        foreach (var verb in Verbs.All())
        {
            var options = verb.Options.Where(o => !o.Hidden && o.Name.StartsWith("--", StringComparison.Ordinal)).Select(o => o.Name);
            Assert.That(Completed($"caterpillar {verb.Name} --"), Is.SupersetOf(options.Append("--quiet")), verb.Name);
        }
    }

    [TestCase("caterpillar sli", "slice")]
    [TestCase("caterpillar slice --printer ender", "ender3")]
    [TestCase("caterpillar slice part.stl --infill-c", "--infill-curves")]
    [TestCase("caterpillar slice --lay", "--lay-flat")]
    [TestCase("caterpillar slice --set layer_height_m", "layer_height_mm=")]
    [TestCase("caterpillar -q convert --e-mode rel", "relative")]
    [TestCase("caterpillar convert --flavor klip", "klipper")]
    [TestCase("caterpillar completions f", "fish")]
    [TestCase("caterpillar decode prin", "")]
    [TestCase("caterpillar slice ", "")]
    public void A_line_is_completed_up_to_the_cursor(string line, string expected)
        => Assert.That(string.Join(" ", Completed(line)), Is.EqualTo(expected));

    [TestCase("zsh", "--lay-flat:Rotate each model so that its largest flat face is on the bed")]
    [TestCase("fish", "--lay-flat\tRotate each model so that its largest flat face is on the bed")]
    [TestCase("powershell", "--lay-flat\tRotate each model so that its largest flat face is on the bed")]
    public void Descriptions_are_short(string shell, string expected)
        => Assert.That(Run("completions", shell, "--line", "caterpillar slice --lay").Text.Trim(), Is.EqualTo(expected));

    [TestCase("caterpillar sli", "slice")]
    [TestCase("caterpillar slice --set layer_height_m", "layer_height_mm=")]
    [TestCase("caterpillar decode prin", "print.gcode")]
    public void Bash_completes(string line, string expected)
    {
        File.WriteAllBytes("c.bash", Run("completions", "bash").Output);
        File.WriteAllText("print.gcode", "G28\n");
        var script = $"caterpillar() {{ dotnet '{Program}' \"$@\"; }}; source c.bash; COMP_LINE='{line}'; COMP_POINT=${{#COMP_LINE}}; COMP_WORDS=({line}); "
            + "COMP_CWORD=$((${#COMP_WORDS[@]}-1)); _caterpillar; echo \"${COMPREPLY[@]}\"";
        Assert.That(Shell("bash", "--norc", "-c", script).Trim(), Is.EqualTo(expected));
    }

    [TestCase("caterpillar slice --lay", "--lay-flat")]
    [TestCase("caterpillar decode prin", "print.gcode")]
    public void Fish_completes(string line, string expected)
    {
        File.WriteAllBytes("c.fish", Run("completions", "fish").Output);
        File.WriteAllText("print.gcode", "G28\n");
        var answer = Shell("fish", "--no-config", "-c", $"function caterpillar; dotnet '{Program}' $argv; end; source c.fish; complete -C '{line}'");
        Assert.That(answer.Split('\n')[0].Split('\t')[0], Is.EqualTo(expected), answer);
    }

    [Test]
    public void Zsh_reads_its_completions()
    {
        File.WriteAllBytes("_caterpillar", Run("completions", "zsh").Output);
        var answer = Shell("zsh", "-f", "-c", "fpath=($PWD $fpath); autoload -Uz compinit; compinit -u -D; _caterpillar 2>/dev/null; "
            + "whence -w _caterpillar; echo $_comps[caterpillar]");
        Assert.That(answer.Split('\n').Take(2), Is.EqualTo(new[] { "_caterpillar: function", "_caterpillar" }));
        Assert.That(Shell("zsh", "-f", "-n", "_caterpillar"), Is.Empty);
    }

    [Test]
    public void PowerShell_asks_the_program()
        => Assert.That(Run("completions", "powershell").Text, Does.Contain("Register-ArgumentCompleter").And.Contain("completions powershell --line"));

    private static string Program => typeof(App).Assembly.Location;

    private static string[] Completed(string line)
        => Run("completions", "bash", "--line", line).Text.Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);

    private static string Shell(string program, params string[] arguments)
    {
        try
        {
            using var process = Process.Start(new ProcessStartInfo(program, arguments) { RedirectStandardOutput = true, RedirectStandardError = true })!;
            var errors = process.StandardError.ReadToEndAsync();
            var output = process.StandardOutput.ReadToEnd();
            process.WaitForExit();
            Assert.That(errors.Result, Is.Empty);
            return output;
        }
        catch (System.ComponentModel.Win32Exception)
        {
            Assert.Ignore(program + " is not installed.");
            throw;
        }
    }
}

using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>What shells complete, asked of the shells themselves where they are installed.</summary>
public class CompletionTests : CliFixture
{
    [TestCase("bash")]
    [TestCase("zsh")]
    [TestCase("fish")]
    [TestCase("powershell")]
    public void Every_verb_and_option_is_completed(string shell)
    {
        var run = Run("completions", shell);
        Assert.That((run.Code, run.Messages), Is.EqualTo((0, "")));
        foreach (var verb in Verbs.All())
        {
            Assert.That(run.Text, Does.Contain(verb.Name));
            foreach (var option in verb.Options.Where(o => o.Name.StartsWith("--", StringComparison.Ordinal)))
                Assert.That(run.Text, Does.Contain(shell == "fish" ? "-l " + option.Name[2..] : option.Name), verb.Name);
        }
        Assert.That(run.Text, Does.Contain("--quiet").Or.Contain("-l quiet"));
        Assert.That(run.Text, Does.Contain("prusa_mk3s").And.Contain("layer_height_mm=").And.Contain("klipper"));
    }

    [TestCase("caterpillar|sli", "slice")]
    [TestCase("caterpillar|slice|--printer|ender", "ender3")]
    [TestCase("caterpillar|slice|part.stl|--infill-c", "--infill-curves")]
    [TestCase("caterpillar|slice|--lay", "--lay-flat")]
    [TestCase("caterpillar|slice|--set|layer_height_m", "layer_height_mm=")]
    [TestCase("caterpillar|-q|convert|--e-mode|rel", "relative")]
    [TestCase("caterpillar|decode|prin", "print.gcode")]
    [TestCase("caterpillar|completions|f", "fish")]
    public void Bash_completes(string words, string expected)
    {
        File.WriteAllBytes("c.bash", Run("completions", "bash").Output);
        File.WriteAllText("print.gcode", "G28\n");
        var list = string.Join(" ", words.Split('|').Select(w => $"'{w}'"));
        var script = $"source c.bash; COMP_WORDS=({list}); COMP_CWORD=$((${{#COMP_WORDS[@]}}-1)); _caterpillar; echo \"${{COMPREPLY[@]}}\"";
        Assert.That(Shell("bash", "--norc", "-c", script).Trim(), Is.EqualTo(expected));
    }

    [TestCase("caterpillar sli", "slice")]
    [TestCase("caterpillar slice --printer ender", "ender3")]
    [TestCase("caterpillar slice --lay", "--lay-flat")]
    [TestCase("caterpillar convert --e-mode rel", "relative")]
    [TestCase("caterpillar decode prin", "print.gcode")]
    public void Fish_completes(string line, string expected)
    {
        File.WriteAllBytes("c.fish", Run("completions", "fish").Output);
        File.WriteAllText("print.gcode", "G28\n");
        var answer = Shell("fish", "--no-config", "-c", $"source c.fish; complete -C '{line}'");
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

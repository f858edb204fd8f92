using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary>The program as a separate process.</summary>
public class ProcessTests : CliFixture
{
    [Test]
    public void It_returns_its_exit_code_and_keeps_messages_out_of_the_output()
    {
        File.WriteAllText("part.stl", Box(20, 10, 2));
        Assert.That(Start("slice part.stl -o -", out var output, out _), Is.Zero);
        Assert.That(output, Does.Contain("G1 X").And.Not.Contain("\r"));
        Assert.That(Start("slice none.stl", out output, out var messages), Is.EqualTo(1));
        Assert.That((output, messages), Is.EqualTo(("", "none.stl: file not found." + Environment.NewLine)));
        Assert.That(Start("printers generic", out output, out _), Is.Zero);
        Assert.That(output, Does.Contain("Generic 220"));
    }

    [Test]
    public void A_signal_ends_it_even_while_it_waits_for_input()
    {
        if (!RuntimeInformation.IsOSPlatform(OSPlatform.Linux)) Assert.Ignore("Signals are sent with kill.");
        // SIGINT is ignored in jobs that a script runs in the background.
        string[] signals = IgnoresInterrupts() ? ["TERM"] : ["INT", "TERM"];
        var processes = signals.Select(_ => Process.Start(Info("slice -"))!).ToArray();
        // They wait for standard input, which stays open.
        System.Threading.Thread.Sleep(1500);
        foreach (var (process, signal) in processes.Zip(signals))
        {
            using var ended = process;
            Assert.That(process.HasExited, Is.False, signal);
            Send(signal, process);
            Assert.That(process.WaitForExit(20_000), Is.True, signal);
            Assert.That(process.ExitCode, Is.EqualTo(130), signal);
        }
        Assert.That(Files(), Is.Empty);
    }

    [Test]
    public void A_batch_that_is_interrupted_says_what_is_done_and_goes_on_later()
    {
        if (!RuntimeInformation.IsOSPlatform(OSPlatform.Linux)) Assert.Ignore("Signals are sent with kill.");
        File.WriteAllText("part.stl", Box(20, 10, 2));
        File.WriteAllText("t.csv", "infill_density_percent\n" + string.Join("\n", Enumerable.Range(1, 90)) + "\n");
        const string Command = "slice part.stl --table t.csv -o out/{row}.gcode --summary s.csv --resume --jobs 2";
        using var process = Process.Start(Info(Command))!;
        var first = process.StandardError.ReadLine();
        Send(IgnoresInterrupts() ? "TERM" : "INT", process);
        var messages = process.StandardError.ReadToEnd();
        process.WaitForExit();
        Assert.That(process.ExitCode, Is.EqualTo(130), messages);
        Assert.That(first, Does.StartWith("[1/90] out/01.gcode"));
        Assert.That(messages, Does.Contain("of 90 done").And.Contain("Interrupted. To continue, repeat the command with --resume."));
        var written = Directory.GetFileSystemEntries("out").Length;
        Assert.That(written, Is.InRange(1, 89));
        Assert.That(File.ReadLines("s.csv").Count(l => l.Contains(",done,", StringComparison.Ordinal)), Is.EqualTo(written), "whole files only");
        Assert.That(Start(Command, out _, out messages), Is.Zero);
        Assert.That(messages, Does.Contain($"{90 - written} of 90 done, {written} skipped"));
        Assert.That(Directory.GetFileSystemEntries("out"), Has.Length.EqualTo(90));
    }

    [Test]
    public void Every_verb_ends_soon_after_an_interrupt()
    {
        if (!RuntimeInformation.IsOSPlatform(OSPlatform.Linux)) Assert.Ignore("Signals are sent with kill.");
        var turns = string.Concat(Enumerable.Range(2, 300).Select(i => $"G2 X100 Y100 Z{i} I5 J0 P100000 E100000\n"));
        File.WriteAllText("helix.gcode", "G28\nM83\nM109 S200\nG1 X100 Y100 Z1 F3000\n" + turns);
        File.WriteAllText("part.stl", Box(200, 200, 200));
        string[] commands =
        [
            "check helix.gcode", "view helix.gcode -o a.html", "image helix.gcode -o a.png", "simulate helix.gcode --at 50%",
            "convert helix.gcode --scale 1,2,1 -o a.gcode", "slice part.stl --set layer_height_mm=0.005 -o b.gcode", "decode -", "turtle -", "curves -",
            "sections - --heights 1", "printers --import - -",
        ];
        var processes = commands.Select(c => Process.Start(Info(c))!).ToArray();
        System.Threading.Thread.Sleep(3000);
        foreach (var process in processes) Send(IgnoresInterrupts() ? "TERM" : "INT", process);
        // Most of it is waiting for a processor: work that does not stop by itself is ended after 0.4 s.
        foreach (var (process, command) in processes.Zip(commands))
        {
            var ended = process.WaitForExit(20_000);
            if (!ended) process.Kill();
            Assert.That((ended, process.ExitCode), Is.EqualTo((true, 130)), command);
            Assert.That(process.StandardError.ReadToEnd(), Does.Contain("Interrupted. Nothing was written."), command);
            process.Dispose();
        }
        Assert.That(Files(), Is.EqualTo(new[] { "helix.gcode", "part.stl" }), "no temporary files either");
    }

    [TestCase("slice <({0} part.stl) -o a.gcode")]
    [TestCase("{0} part.stl | {1} slice /dev/stdin -o a.gcode")]
    [TestCase("mkfifo pipe; {0} part.stl > pipe & {1} slice pipe -o a.gcode")]
    [TestCase("{1} sections <({0} part.stl) --heights 1 >&- ; test $? = 1")]
    [TestCase("{1} slice part.stl -o /dev/stdout 2>&- | grep ^G1 > lines")]
    [TestCase("{1} printers --keys | head -1")]
    [TestCase("ulimit -v 1900000; {1} slice part.stl -o a.gcode; test $? = 1")]
    public void Pipes_closed_outputs_and_little_memory_are_no_bugs(string command)
    {
        if (!RuntimeInformation.IsOSPlatform(OSPlatform.Linux)) Assert.Ignore("Commands of bash.");
        File.WriteAllText("part.stl", Box(20, 10, 2));
        var program = "dotnet '" + typeof(App).Assembly.Location + "'";
        command = (command.StartsWith("slice", StringComparison.Ordinal) ? program + " " + command : command).Replace("{0}", "cat").Replace("{1}", program);
        var start = new ProcessStartInfo("bash") { RedirectStandardError = true, RedirectStandardOutput = true };
        start.ArgumentList.Add("-c");
        start.ArgumentList.Add(command);
        using var process = Process.Start(start)!;
        var messages = process.StandardError.ReadToEndAsync();
        process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        Assert.That(process.ExitCode, Is.Zero, messages.Result);
        Assert.That(messages.Result, Does.Not.Contain("   at "));
    }

    private static void Send(string signal, Process process)
        => Process.Start("kill", ["-" + signal, process.Id.ToString(CultureInfo.InvariantCulture)]).WaitForExit();

    // Processes inherit it.
    private static bool IgnoresInterrupts()
    {
        var ignored = File.ReadLines("/proc/self/status").First(l => l.StartsWith("SigIgn:", StringComparison.Ordinal)).Split('\t')[1];
        return (ulong.Parse(ignored, NumberStyles.HexNumber, CultureInfo.InvariantCulture) & 2) != 0;
    }

    private static int Start(string arguments, out string output, out string messages)
    {
        using var process = Process.Start(Info(arguments))!;
        process.StandardInput.Close();
        var errors = process.StandardError.ReadToEndAsync();
        output = process.StandardOutput.ReadToEnd();
        messages = errors.Result;
        process.WaitForExit();
        return process.ExitCode;
    }

    private static ProcessStartInfo Info(string arguments)
        => new("dotnet", "\"" + typeof(App).Assembly.Location + "\" " + arguments) { RedirectStandardInput = true, RedirectStandardOutput = true,
            RedirectStandardError = true, StandardOutputEncoding = System.Text.Encoding.UTF8 };
}

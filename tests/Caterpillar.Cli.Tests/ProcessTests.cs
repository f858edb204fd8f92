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

    [TestCase("INT")]
    [TestCase("TERM")]
    public void A_signal_ends_it_even_while_it_waits_for_input(string signal)
    {
        if (!RuntimeInformation.IsOSPlatform(OSPlatform.Linux)) Assert.Ignore("Signals are sent with kill.");
        if (signal == "INT" && IgnoresInterrupts()) Assert.Ignore("SIGINT is ignored here, as in jobs that a script runs in the background.");
        using var process = Process.Start(Info("slice -"))!;
        // It waits for standard input, which stays open.
        System.Threading.Thread.Sleep(1500);
        Assert.That(process.HasExited, Is.False);
        Send(signal, process);
        Assert.That(process.WaitForExit(20_000), Is.True);
        Assert.That(process.ExitCode, Is.EqualTo(130));
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

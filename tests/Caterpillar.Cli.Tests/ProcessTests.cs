using System;
using System.Diagnostics;
using System.IO;
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
        Assert.That((output, messages), Is.EqualTo(("", "none.stl: there is no such file." + Environment.NewLine)));
        Assert.That(Start("printers generic", out output, out _), Is.Zero);
        Assert.That(output, Does.Contain("220 × 220"));
    }

    [TestCase("INT")]
    [TestCase("TERM")]
    public void A_signal_ends_it_even_while_it_waits_for_input(string signal)
    {
        if (!RuntimeInformation.IsOSPlatform(OSPlatform.Linux)) Assert.Ignore("Signals are sent with kill.");
        using var process = Process.Start(Info("slice -"))!;
        // It waits for standard input, which stays open.
        System.Threading.Thread.Sleep(1500);
        Assert.That(process.HasExited, Is.False);
        Process.Start("kill", ["-" + signal, process.Id.ToString(System.Globalization.CultureInfo.InvariantCulture)]).WaitForExit();
        Assert.That(process.WaitForExit(20_000), Is.True);
        Assert.That(process.ExitCode, Is.EqualTo(130));
        Assert.That(Files(), Is.Empty);
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

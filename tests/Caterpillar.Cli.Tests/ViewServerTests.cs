using System;
using System.IO;
using System.Net;
using System.Net.Http;
using System.Net.Sockets;
using System.Threading;
using System.Threading.Tasks;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

/// <summary><c>view --serve</c>, as a browser sees it.</summary>
public class ViewServerTests : CliFixture
{
    private const string Code = "G28\nM83\nG1 Z0.2 F600\n;LAYER:0\nG1 X10 Y10 F6000\nG1 X60 Y10 E2 F1200\n";

    private static readonly TimeSpan Patience = TimeSpan.FromMinutes(1);

    [TestCase("localhost")]
    [TestCase("127.0.0.1")]
    public async Task A_changed_file_is_shown_and_a_damaged_one_leaves_the_last_good_page(string host)
    {
        File.WriteAllText("a.gcode", Code);
        var port = FreePort();
        using var messages = new Messages();
        using var stop = new CancellationTokenSource();
        var session = new Session(() => Stream.Null, () => Stream.Null, messages) { Cancel = stop.Token };
        var served = Task.Run(() => App.Run(["view", "a.gcode", "--serve", $"{port}"], session));
        async Task<string> Until(Func<Task<string>> get, Func<string, bool> good)
        {
            for (var end = DateTime.UtcNow + Patience; DateTime.UtcNow < end && !served.IsCompleted; await Task.Delay(20))
            {
                var value = await get();
                if (good(value)) return value;
            }
            throw new AssertionException("The page did not change. " + messages);
        }
        using var browser = new HttpClient { BaseAddress = new Uri($"http://{host}:{port}/") };

        var first = await Until(() => Version(browser), version => version.Length > 0);
        Assert.That(await browser.GetStringAsync(""), Does.StartWith("<!DOCTYPE html>").And.Contain(first));
        using (var other = await browser.GetAsync("a.gcode")) Assert.That(other.StatusCode, Is.EqualTo(HttpStatusCode.NotFound));

        Change("a.gcode", Code + "G1 X60 Y60 E2\n", 1);
        var second = await Until(() => Version(browser), version => version != first);
        Assert.That(await browser.GetStringAsync(""), Does.Contain(second).And.Not.Contain(first));

        Change("a.gcode", Box(1, 1, 1), 2);
        await Until(() => Task.FromResult(messages.ToString()), text => text.Contains("gcode.not_gcode"));
        Assert.That(await Version(browser), Is.EqualTo(second));

        Change("a.gcode", Code, 3);
        await Until(() => Version(browser), version => version != second);

        await stop.CancelAsync();
        Assert.That(await served, Is.Zero);
        Assert.That(messages.ToString(), Does.Contain($"Serving a.gcode at http://localhost:{port}/.").And.Contain("a.gcode changed. The page is updated."));
    }

    [Test]
    public void A_port_that_is_in_use_is_refused_with_the_option_for_another()
    {
        File.WriteAllText("a.gcode", Code);
        using var listener = new HttpListener();
        var port = FreePort();
        listener.Prefixes.Add($"http://localhost:{port}/");
        listener.Start();
        var run = Run("view", "a.gcode", "--serve", $"{port}");
        Assert.That(run.Code, Is.EqualTo(1));
        Assert.That(run.Messages, Does.Contain($"Port {port} is not available").And.Contain("--serve PORT"));
    }

    private static int FreePort()
    {
        using var listener = new TcpListener(IPAddress.Loopback, 0);
        listener.Start();
        return ((IPEndPoint)listener.LocalEndpoint).Port;
    }

    // Files are told apart by the time of their last change.
    private static void Change(string file, string text, int seconds)
    {
        File.WriteAllText(file + ".new", text);
        File.SetLastWriteTimeUtc(file + ".new", DateTime.UtcNow.AddSeconds(seconds));
        File.Move(file + ".new", file, overwrite: true);
    }

    private static async Task<string> Version(HttpClient browser)
    {
        try
        {
            return await browser.GetStringAsync("version");
        }
        catch (HttpRequestException)
        {
            return "";
        }
    }

    // Read by the test while the server writes.
    private sealed class Messages : StringWriter
    {
        public override void Write(char value)
        {
            lock (this) base.Write(value);
        }

        public override void Write(string? value)
        {
            lock (this) base.Write(value);
        }

        public override void WriteLine(string? value) => Write(value + "\n");

        public override string ToString()
        {
            lock (this) return base.ToString();
        }
    }
}

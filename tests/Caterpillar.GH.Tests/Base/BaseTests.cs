using System;
using System.Linq;
using System.Threading;
using Caterpillar.GH.Base;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Plugin;
using Caterpillar.GH.Tests.Host;
using GH_IO.Serialization;
using Grasshopper;
using Grasshopper.Kernel;
using NUnit.Framework;
using Rhino.UI;

namespace Caterpillar.GH.Tests.Base;

/// <summary>Long work of a solve, and versions in definitions. Times count: nothing else runs meanwhile.</summary>
[NonParallelizable]
[Category("Host")]
public sealed class BaseTests
{
    [TearDown]
    public void TearDown() => GH_Document.EscapeKey = () => false;

    [Test]
    public void Diagnostics_tell_what_was_found_before_an_input_was_wrong()
    {
        var canvas = new Canvas<NotingComponent>().Feed("Value", -1.0).Solve();
        Assert.That(canvas.Errors.Single(), Does.Contain("Value"));
        Assert.That(canvas.All("Result"), Is.EqualTo(new object?[] { null }));
        Assert.That(canvas.All("Diagnostics").Single(), Does.Contain("test.found"));
    }

    [Test]
    public void Long_work_runs_elsewhere_and_shows_its_progress()
    {
        StatusBar.Log.Clear();
        var here = Thread.CurrentThread.ManagedThreadId;
        // Asked at each step of the wait.
        using var seen = new ManualResetEventSlim();
        GH_Document.EscapeKey = () =>
        {
            if (StatusBar.Log.Contains("at 42")) seen.Set();
            return false;
        };
        var there = LongWork.Run("Testing", (progress, _) =>
        {
            progress.Report(0.42);
            seen.Wait(10_000);
            return Tuple.Create(Thread.CurrentThread.ManagedThreadId);
        });
        Assert.That(there.Item1, Is.Not.EqualTo(here));
        Assert.That(StatusBar.Log, Has.Member("show Testing").And.Member("at 42"));
        Assert.That(StatusBar.Log.Last(), Is.EqualTo("hide"));
    }

    [Test]
    public void Short_work_shows_nothing()
    {
        StatusBar.Log.Clear();
        Assert.That(LongWork.Run("Testing", (_, _) => "done"), Is.EqualTo("done"));
        Assert.That(StatusBar.Log, Is.Empty);
    }

    [Test]
    public void Escape_cancels_long_work()
    {
        var asked = 0;
        GH_Document.EscapeKey = () => ++asked > 2;
        Assert.That(() => LongWork.Run<string>("Testing", (_, cancel) =>
        {
            cancel.WaitHandle.WaitOne(10000);
            cancel.ThrowIfCancellationRequested();
            return "not reached";
        }), Throws.InstanceOf<OperationCanceledException>());
        Assert.That(asked, Is.EqualTo(3));
    }

    [Test]
    public void An_exception_in_long_work_keeps_its_type()
        => Assert.That(() => LongWork.Run<string>("Testing", (_, _) => throw new ArgumentException("wrong")),
            Throws.ArgumentException.With.Message.EqualTo("wrong"));

    [Test]
    public void A_definition_of_a_newer_version_warns_and_one_of_this_version_does_not()
    {
        Assert.That(Reopened(text => text).Warnings, Is.Empty);
        var newer = Reopened(text => System.Text.RegularExpressions.Regex.Replace(text, "(name=\"CaterpillarVersion\"[^>]*>)[0-9.]+", "${1}99.0.0.0"));
        Assert.That(newer.Warnings, Has.One.Contains("saved by Caterpillar 99.0.0.0"));
        Assert.That(newer.Output("Printer").VolatileDataCount, Is.EqualTo(1));
    }

    private static Canvas<PrinterComponent> Reopened(Func<string, string> change)
    {
        Instances.ComponentServer.Load(typeof(PluginInfo).Assembly);
        var archive = new GH_Archive();
        archive.AppendObject(new PrinterComponent(), "Container");
        var read = new GH_Archive();
        read.Deserialize_Xml(change(archive.Serialize_Xml()));
        var canvas = new Canvas<PrinterComponent>();
        Assert.That(read.ExtractObject(canvas.Component, "Container"), Is.True);
        return canvas.Solve();
    }
}

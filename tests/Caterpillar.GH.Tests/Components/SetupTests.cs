using System;
using System.Collections.Concurrent;
using System.IO;
using System.Linq;
using Caterpillar.GH.Components.Setup;
using Caterpillar.GH.Tests.Host;
using Caterpillar.Machines;
using Grasshopper;
using Grasshopper.Kernel;
using NUnit.Framework;
using Rhino;

namespace Caterpillar.GH.Tests.Components;

[Category("Host")]
public sealed class SetupTests
{
    private readonly ConcurrentQueue<Action> _posted = new();
    private string _folder = "";
    private string _settings = "";

    [SetUp]
    public void SetUp()
    {
        while (_posted.TryDequeue(out _))
        {
        }
        _folder = Path.Combine(Path.GetTempPath(), "caterpillar-" + Guid.NewGuid().ToString("N"));
        Directory.CreateDirectory(_folder);
        _settings = Folders.Settings;
        Folders.Settings = _folder;
    }

    [TearDown]
    public void TearDown()
    {
        Folders.Settings = _settings;
        Directory.Delete(_folder, true);
    }

    [Test]
    public void A_printer_comes_by_name_as_item_list_and_tree()
    {
        Assert.That(new Canvas<PrinterComponent>().Solve().One<Printer>("Printer").Name, Is.EqualTo("generic"));
        var list = new Canvas<PrinterComponent>().Feed("Profile", "generic", "ender3").Solve();
        Assert.That(list.All("Printer").Select(p => ((Printer)p!).Name), Is.EqualTo(new[] { "generic", "ender3" }));
        Assert.That(list.Paths("Diagnostics"), Is.EqualTo(new[] { "{0;0}", "{0;1}" }));
        var tree = new Canvas<PrinterComponent>().FeedTree("Profile", ["ender3"], ["generic", "ender3"]).Solve();
        Assert.That(tree.Paths("Printer"), Is.EqualTo(new[] { "{0}", "{1}" }));
        Assert.That(tree.Errors, Is.Empty);
    }

    [Test]
    public void A_wrong_name_is_an_error_with_advice_and_the_rest_continues()
    {
        var canvas = new Canvas<PrinterComponent>().Feed("Profile", "ender33", null, "generic").Solve();
        Assert.That(canvas.All("Printer").Select(p => p is null), Is.EqualTo(new[] { true, true, false }));
        Assert.That(canvas.Errors, Has.One.Contains("Did you mean ender3?"));
        Assert.That(canvas.Errors, Has.Member("{0}[1]: Profile: the connected source gives no valid data."), "Not the printer of the default name.");
    }

    [Test]
    public void The_bed_is_in_document_units()
    {
        using var _ = new InDocument(UnitSystem.Centimeters);
        var canvas = new Canvas<PrinterComponent>().Solve();
        var box = canvas.One<Rg.Curve>("Bed").GetBoundingBox(true);
        Assert.That((box.Max.X, box.Max.Y, box.Max.Z), Is.EqualTo((22.0, 22.0, 0.0)));
        Assert.That(canvas.Notes, Has.One.Contains("centimeters"));
    }

    [Test]
    public void A_file_takes_precedence_over_the_name_and_is_relative_to_the_definition()
    {
        File.WriteAllText(Path.Combine(_folder, "mine.json"), "{\"inherits\": \"generic\", \"title\": \"Mine\", \"build_volume_mm\": [100, 100, 100]}");
        var canvas = new Canvas<PrinterComponent>();
        canvas.Document.FilePath = Path.Combine(_folder, "definition.gh");
        canvas.Feed("Profile", "mine.json").Solve();
        Assert.That(canvas.Errors, Is.Empty);
        Assert.That(canvas.One<Printer>("Printer").Title, Is.EqualTo("Mine"));
        canvas.Feed("Profile", "none.json").Solve();
        Assert.That(canvas.Errors, Has.Some.Contains("none.json"));
        Assert.That(canvas.All("Printer"), Is.EqualTo(new object?[] { null }));
    }

    [Test]
    public void Profiles_of_the_user_override_those_of_the_plug_in_and_are_watched()
    {
        var printers = Path.Combine(_folder, "Caterpillar", "printers");
        Directory.CreateDirectory(printers);
        File.WriteAllText(Path.Combine(printers, "generic.json"), "{\"inherits\": \"generic\", \"title\": \"Changed\"}");
        var canvas = Watched();
        Assert.That(canvas.One<Printer>("Printer").Title, Is.EqualTo("Changed"));
        File.WriteAllText(Path.Combine(printers, "generic.json"), "{\"inherits\": \"generic\", \"title\": \"Again\"}");
        WaitFor(canvas, "Again");
        canvas.Component.DocumentContextChanged(canvas.Document, GH_DocumentContext.Unloaded);
        canvas.Component.DocumentContextChanged(canvas.Document, GH_DocumentContext.Loaded);
        Assert.That(canvas.Document.RunSchedule(), Is.True, "Back from another document it reads the profiles again.");
        File.WriteAllText(Path.Combine(printers, "generic.json"), "{\"inherits\": \"generic\", \"title\": \"Third\"}");
        WaitFor(canvas, "Third");
        canvas.Document.RemoveObject(canvas.Component, false);
    }

    [Test]
    public void A_folder_of_profiles_that_is_made_later_is_watched_too()
    {
        Directory.CreateDirectory(_folder);
        var canvas = Watched();
        var printers = Path.Combine(_folder, "Caterpillar", "printers");
        Directory.CreateDirectory(printers);
        File.WriteAllText(Path.Combine(printers, "generic.json"), "{\"inherits\": \"generic\", \"title\": \"Later\"}");
        WaitFor(canvas, "Later");
        canvas.Document.RemoveObject(canvas.Component, false);
    }

    // What Rhino would run on its UI thread waits for that of the test.
    private Canvas<PrinterComponent> Watched()
    {
        var canvas = new Canvas<PrinterComponent>();
        canvas.Component.Background.Post = _posted.Enqueue;
        return canvas.Solve();
    }

    private void WaitFor(Canvas<PrinterComponent> canvas, string title)
    {
        var (isTold, until) = (false, DateTime.UtcNow.AddSeconds(10));
        while (canvas.One<Printer>("Printer").Title != title && DateTime.UtcNow < until)
        {
            if (_posted.TryDequeue(out var action))
            {
                isTold = true;
                action();
            }
            else if (!canvas.Document.RunSchedule())
            {
                System.Threading.Thread.Sleep(5);
            }
        }
        if (!isTold) Assert.Ignore("This file system does not report changes.");
        Assert.That(canvas.One<Printer>("Printer").Title, Is.EqualTo(title));
    }

    [Test]
    public void A_material_comes_by_name_as_list_and_tree()
    {
        var canvas = new Canvas<MaterialComponent>().FeedTree("Profile", ["pla"], [null, "petg", "plaa"]).Solve();
        Assert.That(canvas.All("Material").Select(m => (m as Material)?.Name), Is.EqualTo(new[] { "pla", null, "petg", null }));
        Assert.That(canvas.Errors, Has.One.StartsWith("{1}[2]: ").And.One.Contains("plaa"));
    }

    [Test]
    public void Settings_take_the_values_given_and_keep_those_of_the_base()
    {
        var canvas = new Canvas<PrintSettingsComponent>().Feed("Profile", "standard").Feed("Layer Height", 0.1, 0.3);
        canvas.Key("wall_count", 4).Solve();
        Assert.That(canvas.Errors, Is.Empty);
        var settings = canvas.All("Settings").Cast<PrintSettings>().ToArray();
        Assert.That(settings.Select(s => s.LayerHeight), Is.EqualTo(new[] { 0.1, 0.3 }));
        Assert.That(settings.Select(s => s.WallCount), Is.EqualTo(new[] { 4, 4 }));
        Assert.That(settings[0].PrintSpeed, Is.EqualTo(new Canvas<PrintSettingsComponent>().Solve().One<PrintSettings>("Settings").PrintSpeed));
    }

    [Test]
    public void Settings_out_of_range_are_errors_of_their_item()
    {
        var canvas = new Canvas<PrintSettingsComponent>().FeedTree("Layer Height", [0.2], [-1, 0.3, double.NaN, "thick"]).Solve();
        Assert.That(canvas.All("Settings").Select(s => (s as PrintSettings)?.LayerHeight), Is.EqualTo(new double?[] { 0.2, null, 0.3, null, null }));
        Assert.That(canvas.Errors, Has.One.StartsWith("{1}[0]: ").And.One.StartsWith("{1}[2]: ").And.One.EqualTo("Data conversion failed from Text to Number"));
    }

    [Test]
    public void An_unknown_base_is_answered_with_the_profiles()
    {
        var errors = new Canvas<PrintSettingsComponent>().Feed("Profile", "no such settings").Solve().Errors;
        Assert.That(errors, Has.One.Matches<string>(e => e.StartsWith("Profile: ") && e.Contains("\"no such settings\"") && e.Contains("fine, pen, standard")));
        Assert.That(errors, Has.Member("{0}[0]: Profile: the connected source gives no valid data."));
    }
}

using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Machines;
using NUnit.Framework;

namespace Caterpillar.Tests.Machines;

/// <summary>Sizes of extrusions that nobody gave follow from the nozzle.</summary>
public class NozzleSizeTests
{
    [TestCase(0.4, 0.45, 0.2)]
    [TestCase(0.2, 0.225, 0.1)]
    [TestCase(0.8, 0.9, 0.4)]
    [TestCase(6, 6.75, 3)]
    public void Widths_and_heights_are_shares_of_the_nozzle(double nozzle, double width, double height)
    {
        var setup = new ProfileLibrary().Setup(values: ["nozzle_diameter_mm=" + NumberFormatter.Shortest(nozzle)]).OrThrow();
        Assert.That((setup.Settings.LineWidth, setup.Settings.LayerHeight, setup.Settings.FirstLayerHeight), Is.EqualTo((width, height, height)));
        var made = new PrintSetup() with { Printer = new Printer { NozzleDiameter = nozzle } };
        Assert.That((made.Settings.LineWidth, made.Settings.LayerHeight), Is.EqualTo((width, height)));
        Assert.That((made with { Settings = new PrintSettings() }).Settings.LineWidth, Is.EqualTo(width));
    }

    [Test]
    public void The_usual_nozzle_gives_the_usual_sizes_exactly()
    {
        var settings = new PrintSettings();
        Assert.That(new[] { settings.LineWidth, settings.LayerHeight, settings.FirstLayerHeight, settings.AdaptiveMinHeight, settings.AdaptiveMaxHeight,
            settings.RaftLayerHeight }, Is.EqualTo(new[] { 0.45, 0.2, 0.2, 0.08, 0.28, 0.3 }));
    }

    [Test]
    public void What_a_profile_or_a_user_gives_stays()
    {
        var library = new ProfileLibrary();
        var setup = library.Setup("lutum", values: ["nozzle_diameter_mm=5"]).OrThrow();
        Assert.That((setup.Settings.LineWidth, setup.Settings.LayerHeight), Is.EqualTo((3.4, 1.5)), "the profile clay");
        setup = library.Setup(settings: "fine", values: ["line_width_mm=0.5", "nozzle_diameter_mm=0.6"]).OrThrow();
        Assert.That((setup.Settings.LineWidth, setup.Settings.LayerHeight, setup.Settings.FirstLayerHeight), Is.EqualTo((0.5, 0.1, 0.3)));
        setup = setup.With("line_width_mm=0").OrThrow();
        Assert.That(setup.Settings.LineWidth, Is.EqualTo(0.675), "0 gives it back to the nozzle");
    }

    [TestCase("line_width_mm=110%", "nozzle_diameter_mm=0.8")]
    [TestCase("nozzle_diameter_mm=0.8", "line_width_mm=110%")]
    public void Percents_are_of_the_new_nozzle_in_any_order(string first, string second)
        => Assert.That(new PrintSetup().With(first, second).OrThrow().Settings.LineWidth, Is.EqualTo(0.88).Within(1e-12));

    [Test]
    public void A_note_tells_what_follows_from_the_nozzle()
    {
        var library = new ProfileLibrary();
        Assert.That(library.Setup().Diagnostics, Is.Empty, "the usual nozzle");
        var note = library.Setup(values: ["nozzle_diameter_mm=0.8", "layer_height_mm=0.3"]).Diagnostics.Single();
        Assert.That((note.Severity, note.Code), Is.EqualTo((Severity.Note, "setup.from_nozzle")));
        Assert.That(note.Message, Is.EqualTo("The nozzle of 0.8 mm sets line_width_mm=0.9, first_layer_height_mm=0.4."));
        Assert.That(library.Setup("lutum").Diagnostics, Is.Empty, "the profile clay gives all of them");
    }

    [Test]
    public void A_written_profile_still_follows_the_nozzle()
    {
        var setup = new PrintSetup(new Printer { NozzleDiameter = 0.8 }, new Material(), new PrintSettings());
        var again = ProfileReader.Read<PrintSettings>(ProfileWriter.Write(setup.Settings), "again.json", "standard").OrThrow();
        Assert.That(again, Is.EqualTo(new PrintSettings()));
        Assert.That((setup with { Settings = again, Printer = new Printer { NozzleDiameter = 1.2 } }).Settings.LineWidth, Is.EqualTo(1.35));
    }

    [Test]
    public void Templates_get_the_sizes_themselves()
    {
        var setup = new PrintSetup(new Printer { NozzleDiameter = 0.8 }, new Material(), new PrintSettings());
        var template = PrintTemplate.Parse(["M117 {line_width_mm} {layer_height_mm}"]).OrThrow();
        Assert.That(template.Render(PrintValues.Of(setup)).OrThrow().Single(), Is.EqualTo("M117 0.9 0.4"));
    }
}

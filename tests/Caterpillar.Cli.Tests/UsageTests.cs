using System;
using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class UsageTests : CliFixture
{
    [Test]
    public void Without_a_verb_the_usage_is_wrong()
    {
        var run = Run();
        Assert.That((run.Code, run.Text), Is.EqualTo((2, "")));
        Assert.That(run.Messages, Does.Contain("The command is missing.").And.Contain("caterpillar --help"));
    }

    [TestCase("slic", "part.stl")]
    [TestCase("slice")]
    [TestCase("slice", "part.stl", "--no-such")]
    [TestCase("slice", "part.stl", "--threads", "0")]
    [TestCase("slice", "part.stl", "--threads", "many")]
    [TestCase("slice", "part.stl", "--output", "")]
    [TestCase("decode", "part.gcode", "--rule", "falling")]
    [TestCase("decode", "part.gcode", "--flavor", "marlin3")]
    [TestCase("decode", "part.gcode", "--json", "--csv")]
    [TestCase("decode", "part.gcode", "--filament-diameter", "-1")]
    [TestCase("view", "-", "--serve")]
    [TestCase("view", "part.stl", "--serve", "-o", "a.html")]
    [TestCase("view", "part.stl", "--open", "-o", "a.js")]
    [TestCase("view", "part.stl", "--open", "-o", "-")]
    [TestCase("printers", "ender4")]
    [TestCase("printers", "a", "b")]
    [TestCase("slice", "part.stl", "--printer", "ender4")]
    [TestCase("slice", "part.stl", "--material", "plastic")]
    [TestCase("slice", "part.stl", "--set", "layer_height=0.2")]
    [TestCase("slice", "part.stl", "--set", "layer_height_mm")]
    [TestCase("slice", "part.stl", "--set", "layer_height_mm=thin")]
    [TestCase("slice", "part.stl", "--set", "line_width_mm=0.1")]
    public void Wrong_usage_is_reported_and_does_nothing(params string[] words)
    {
        File.WriteAllText("part.stl", Box(10, 10, 2));
        File.WriteAllText("part.gcode", "G1 X1\n");
        var run = Run(words);
        Assert.That(run.Code, Is.EqualTo(2), run.Messages);
        Assert.That(run.Messages, Is.Not.Empty);
        Assert.That(run.Text, Is.Empty);
        Assert.That(Files(), Is.EqualTo(new[] { "part.gcode", "part.stl" }));
    }

    [TestCase("--help")]
    [TestCase("slice", "--help")]
    [TestCase("--version")]
    public void Help_is_not_an_error(params string[] words)
    {
        var run = Run(words);
        Assert.That((run.Code, run.Messages), Is.EqualTo((0, "")));
        Assert.That(run.Text, Is.Not.Empty);
    }

    [Test]
    public void Every_verb_explains_itself()
    {
        foreach (var verb in Verbs.All())
        {
            Assert.That(verb.Description, Does.EndWith("."), verb.Name);
            foreach (var option in verb.Options) Assert.That(option.Description, Is.Not.Null.And.Not.Empty, verb.Name + " " + option.Name);
            foreach (var argument in verb.Arguments) Assert.That(argument.Description, Is.Not.Null.And.Not.Empty, verb.Name + " " + argument.Name);
        }
    }

    [Test]
    public void Printers_lists_all_profiles()
    {
        Directory.CreateDirectory("profiles");
        File.WriteAllText("profiles/mine.json", """{ "title": "My own" }""");
        var run = Run("printers");
        Assert.That((run.Code, run.Messages), Is.EqualTo((0, "")));
        foreach (var name in new[] { "generic", "ender3", "potter_super", "petg", "fine", "mine", "My own" }) Assert.That(run.Text, Does.Contain(name));
        var settings = run.Text.Split('\n').SkipWhile(l => !l.StartsWith("SETTINGS", StringComparison.Ordinal));
        string Line(string name) => settings.Single(l => l.StartsWith(name + " ", StringComparison.Ordinal));
        Assert.That(Line("standard"), Does.Contain("0.2, 0.45 mm for a 0.4 mm nozzle"), "They follow from the nozzle.");
        Assert.That(Line("clay"), Does.Contain("1.5, 3.4 mm").And.Not.Contain("nozzle"));
    }

    [Test]
    public void A_bad_profile_of_the_user_does_not_hide_the_others()
    {
        Directory.CreateDirectory("profiles");
        File.WriteAllText("profiles/bad.json", """{ "nozzle_diameter_cm": 0.04 }""");
        var run = Run("printers");
        Assert.That(run.Code, Is.EqualTo(1));
        Assert.That(run.Messages, Does.Contain("bad.json:1:3: nozzle_diameter_cm").And.Contain("nozzle_diameter_mm"));
        Assert.That(run.Text, Does.Contain("generic"));
    }

    [Test]
    public void Printers_shows_a_profile_that_can_be_reused()
    {
        File.WriteAllBytes("copy.json", Run("printers", "ender3").Output);
        Assert.That(Run("printers", "./copy.json").Output, Is.EqualTo(Run("printers", "ender3").Output));
        Assert.That(Run("printers", "settings/clay").Text, Does.Contain("layer_height_mm"));
        Assert.That(Run("printers", "clay").Text, Does.Contain("filament_diameter_mm"));
        Assert.That(Run("printers", "--keys").Text, Does.Contain("print_speed_mm_s").And.Contain("nozzle_diameter_mm").And.Contain("density_g_cm3"));
    }

    [Test]
    public void A_bad_profile_is_bad_input_and_named_with_its_key()
    {
        File.WriteAllText("p.json", "{\n  \"layer_height_cm\": 0.02\n}");
        File.WriteAllText("part.stl", Box(10, 10, 2));
        var run = Run("slice", "part.stl", "--settings", "p.json");
        Assert.That(run.Code, Is.EqualTo(1));
        Assert.That(run.Messages, Does.Contain("p.json:2:3: layer_height_cm").And.Contain("layer_height_mm"));
    }

    [Test]
    public void An_internal_error_is_reported_as_one()
    {
        var run = Run([], ["printers"], output: () => throw new System.InvalidOperationException("broken inside"));
        Assert.That(run.Code, Is.EqualTo(70));
        Assert.That(run.Messages, Does.Contain("broken inside"));
    }
}

using System.IO;
using System.Linq;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class CurvedSliceTests : CliFixture
{
    [Test]
    public void A_model_is_sliced_along_a_formula_and_its_moves_change_Z()
    {
        File.WriteAllText("part.stl", Box(20, 10, 3));
        var run = Run("slice", "part.stl", "--surface", "0.1 * x", "--set", "layer_height_mm=0.3");
        Assert.That(run.Code, Is.Zero, run.Messages);
        var prints = File.ReadAllLines("part.gcode").Where(l => l.StartsWith("G1 ") && l.Contains(" X") && l.Contains(" Z") && l.Contains(" E"));
        Assert.That(prints.Count(), Is.GreaterThan(200));
    }

    [Test]
    public void Options_that_do_not_go_together_are_wrong_usage()
    {
        File.WriteAllText("part.stl", Box(20, 10, 3));
        Assert.That(Run("slice", "part.stl", "--field", "vertical").Code, Is.EqualTo(2));
        Assert.That(Run("slice", "part.stl", "--surface", "x", "--deform", "cone=20").Code, Is.EqualTo(2));
        Assert.That(Run("slice", "part.stl", "--field", "z", "--blend", "3").Code, Is.EqualTo(2));
        Assert.That(Run("slice", "part.stl", "--surface", "0.1 * x", "--copies", "2").Code, Is.EqualTo(2));
        Assert.That(Run("slice", "part.stl", "--field", "z +").Code, Is.EqualTo(2));
    }

    [Test]
    public void Layers_too_steep_for_the_head_are_refused_and_nothing_is_written()
    {
        File.WriteAllText("part.stl", Box(20, 10, 3));
        var run = Run("slice", "part.stl", "--surface", "2 * x");
        Assert.That(run.Code, Is.EqualTo(1));
        Assert.That(run.Messages, Does.Contain("curved.too_steep"));
        Assert.That(Files(), Is.EqualTo(new[] { "part.stl" }));
    }

    [Test]
    public void On_an_object_the_head_rises_before_it_goes_there_and_prints_above_its_surface()
    {
        File.WriteAllText("plate.stl", Box(10, 6, 0.4));
        File.WriteAllText("scan.stl", Box(20, 10, 8));
        var run = Run("slice", "plate.stl", "--onto", "scan.stl", "--partial");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(run.Messages, Does.Contain("curved.object_place"));
        var text = File.ReadAllText("plate.gcode");
        Assert.That(text, Does.Contain("G0 Z8.6 F600"));
        Assert.That(text, Does.Contain(" Z8.2").And.Contain(" Z8.4"));
    }
}

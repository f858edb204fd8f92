using System.IO;
using NUnit.Framework;

namespace Caterpillar.Cli.Tests;

public class SectionsTests : CliFixture
{
    [SetUp]
    public void MakeModel() => File.WriteAllText("box.stl", Box(10, 20, 2));

    [Test]
    public void A_box_has_the_same_outline_and_area_at_each_height()
    {
        var run = Run("sections", "box.stl", "--heights", "0.5,1.5");
        Assert.That(run.Code, Is.Zero, run.Messages);
        Assert.That(run.Text, Does.Match(@"(?m)^0\.5 +60 +200 +1 +0 +0\r?$").And.Match(@"(?m)^1\.5 +60 +200 +1 +0 +0\r?$"));
    }

    [Test]
    public void Planes_at_a_distance_lie_in_the_middle_of_layers()
    {
        var run = Run("sections", "box.stl", "--every", "1", "--json");
        Assert.That(run.Text, Does.Contain("{\"z\": 0.5, \"length\": 60, \"area\": 200, \"outer\": 1, \"holes\": 0, \"open\": 0}").And.Contain("\"z\": 1.5,"));
        Assert.That(run.Text, Does.Not.Contain("\"z\": 2"));
    }

    [Test]
    public void Planes_have_to_be_given_in_one_of_the_two_forms()
    {
        Assert.That(Run("sections", "box.stl").Code, Is.EqualTo(2));
        Assert.That(Run("sections", "box.stl", "--heights", "1", "--every", "1").Code, Is.EqualTo(2));
        Assert.That(Run("sections", "box.stl", "--every", "0").Code, Is.EqualTo(2));
    }
}

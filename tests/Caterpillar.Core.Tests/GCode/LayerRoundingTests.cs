using System.Linq;
using System.Text;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Rounding that merges layers is an error.</summary>
public class LayerRoundingTests
{
    [TestCase(0, 0.2, "layer 1 at Z 0.4 mm would be printed into the layer below")]
    [TestCase(1, 0.25, null)]
    [TestCase(1, 0.12, "layer 2 at Z 0.36 mm would be 0.2 mm high instead of 0.12 mm")]
    [TestCase(2, 0.125, null)]
    [TestCase(0, 1.0, null)]
    [TestCase(3, 0.05, null)]
    public void Decimals_that_are_too_few_for_the_layers_are_refused(int decimals, double height, string? message)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        for (var i = 0; i < 5; i++)
        {
            var layer = builder.AddLayer(new Layer(i, (i + 1) * height, height));
            builder.Add(new Vec3(10 * (i % 2), 0, (i + 1) * height), 1, 1, 20, MoveKind.Print, Role.OuterWall, layer, 0, 0);
        }
        var toolpath = builder.Build([new ToolpathTool(2.4)]);
        var format = SetupFormat.Of(new PrintSetup(new Printer { DecimalsXyz = decimals }, new Material(), new PrintSettings()), toolpath);
        Assert.That(format.Value is null, Is.EqualTo(message is not null));
        if (message is null) return;
        var error = format.Diagnostics.Single(d => d.Code == "gcode.layers_rounded");
        Assert.That(error.Message, Does.Contain(message));
        Assert.That(error.Source!.Key, Is.EqualTo("decimals_xyz"));
    }

    [Test]
    public void Conversions_are_refused_too()
    {
        var decoded = GCodeDecoder.Decode(Encoding.ASCII.GetBytes("M83\n;LAYER:0\nG1 X1 Z0.2 E1\n;LAYER:1\nG1 Z0.4\nG1 X9 E1\n;LAYER:2\nG1 Z.6\nG1 X1 E1\n"))
            .Value!;
        Assert.That(GCodeConverter.ToDocument(decoded, new ConvertOptions { DecimalsXyz = 0 }).Diagnostics.Select(d => d.Code),
            Does.Contain("gcode.layers_rounded"));
        Assert.That(GCodeConverter.ToDocument(decoded, new ConvertOptions { DecimalsXyz = 1 }).Value, Is.Not.Null);
    }
}

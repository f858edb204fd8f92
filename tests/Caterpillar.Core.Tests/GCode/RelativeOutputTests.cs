using System;
using System.Linq;
using Caterpillar.Flavors;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Relative output (G91): differences of rounded positions.</summary>
public class RelativeOutputTests
{
    [Test]
    public void Moves_are_differences_after_an_absolute_first_one()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
        builder.Add(new Vec3(10, 20, 0.2), 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(10.3333, 20, 0.2), 1, 1, 20, MoveKind.Print, Role.OuterWall, -1, 0, 0);
        builder.Add(new Vec3(10.6666, 20, 0.2), 1, 1, 20, MoveKind.Print, Role.OuterWall, -1, 0, 0);
        builder.Add(new Vec3(11, 19, 0.2), 1, 1, 20, MoveKind.Print, Role.OuterWall, -1, 0, 0);
        var format = new GCodeFormat(NewFile.Machine with { RelativeXyz = true }) { End = ["G1 X0"] };
        Assert.That(NewFile.Plain(builder.Build([new ToolpathTool(2.4)]), format), Is.EqualTo(
            "G90\nM83\nG0 X10 Y20 Z0.2 F6000\nG91\nM83\nG1 X0.333 E1 F1200\nG1 X0.334 E1\nG1 X0.333 Y-1 E1\nG90\nM83\nG1 X0\n"));
    }

    [Test]
    [Category("Arithmetic")]
    public void What_is_read_back_is_what_absolute_output_gives([Values(2, 3)] int decimals, [Values] bool arcs)
    {
        var random = new Random(5);
        foreach (var flavor in new[] { "marlin2", "klipper", "reprapfirmware", "smoothie", "cnc" }.Select(name => FlavorTable.Find(name)!))
        {
            var builder = new ToolpathBuilder(MoveSource.Steps, Vec3.Zero);
            var at = new Vec3(50, 50, 0.2);
            for (var i = 0; i < 5000; i++)
            {
                var to = new Vec3(50 + 40 * random.NextDouble(), 50 + 40 * random.NextDouble(), 0.2 + i * 0.0001);
                if (i % 50 == 0) builder.Add(to, 0, 0, 100, MoveKind.Travel, Role.Unspecified, -1, 0, i);
                else if (arcs && i % 7 == 0)
                    builder.Add(to.WithZ(at.Z), 0.1, 0.1, 20, MoveKind.Print, Role.OuterWall, -1, 0, i, new Arc(((at + to) / 2).WithZ(at.Z), 180));
                else builder.Add(to, 0.0333333, 0.0333333, 20, MoveKind.Print, Role.OuterWall, -1, 0, i);
                if (i == 2500) builder.AddEvent(new RawEvent("G28 X"));
                at = builder.Position;
            }
            var toolpath = builder.Build([new ToolpathTool(2.4)]);
            var format = new GCodeFormat(NewFile.Machine with { Flavor = arcs ? flavor : NewFile.WithoutArcs(flavor), DecimalsXyz = decimals });
            var absolute = Read(toolpath, format);
            var relative = Read(toolpath, format with { Printer = format.Printer with { RelativeXyz = true } });
            if (!arcs || flavor.ArcsInRelativeMode) Assert.That(relative.Count, Is.EqualTo(absolute.Count), flavor.Name);
            var (last, other) = (absolute[absolute.Count - 1], relative[relative.Count - 1]);
            Assert.That(last.End.DistanceTo(other.End), Is.LessThan(1e-9), flavor.Name);
            Assert.That(relative.Moves().Sum(m => m.E), Is.EqualTo(absolute.Moves().Sum(m => m.E)).Within(2e-5), flavor.Name);
            if (arcs) continue;
            var far = absolute.Moves().Zip(relative.Moves(), (a, b) => a.End.DistanceTo(b.End)).Max();
            Assert.That(far, Is.LessThan(1e-9), "nothing adds up: " + flavor.Name);
        }
    }

    private static Toolpath Read(Toolpath toolpath, GCodeFormat format)
        => GCodeDecoder.Decode(NewFile.Of(toolpath, format), new DecodeOptions { Flavor = format.Flavor }).Value!.Toolpath;
}

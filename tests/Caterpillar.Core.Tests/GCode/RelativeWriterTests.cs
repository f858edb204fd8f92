using System;
using System.Linq;
using System.Text;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;
using Decoder = Caterpillar.GCode.Decoder;

namespace Caterpillar.Tests.GCode;

internal sealed class RelativeWriterTests
{
    private static readonly ToolpathTool[] Filament = [new(Math.PI / 4 * 1.75 * 1.75)];

    [Test]
    public void Increments_begin_behind_the_first_place_and_end_before_the_end_code()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        builder.Add(new Vec3(10, 20, 0.2), 0, 0, 150, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(20, 19.5, 0.2), 0.5, 0.5, 30, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        builder.AddEvent(new RawEvent("G28 X"));
        builder.Add(new Vec3(20, 30, 0.2), 0.25, 0.25, 30, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(22, 30, 0.2), 0.1, 0.1, 30, MoveKind.Print, Role.Unspecified, -1, 0, 0, new Arc(new Vec3(21, 30), -180));
        var text = Encoding.ASCII.GetString(GCodeWriter.ToBytes(builder.Build(Filament), new GCodeFormat { RelativeXyz = true, RelativeE = false, End = ["M84"] }));
        Assert.That(text, Is.EqualTo(
            "G90\nM83\nG0 X10 Y20 Z0.2 F9000\nG91\nM83\nG1 X10 Y-0.5 E0.5 F1800\nG28 X\nG90\nM83\nG1 X20 Y30 Z0.2 E0.25 F1800\nG91\nM83\nG2 X2 I1 J0 E0.1\nG90\nM83\nM84\n"));
    }

    [Test]
    public void Increments_do_not_drift()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        var random = new Random(2);
        for (var i = 0; i < 3000; i++)
            builder.Add(new Vec3(100 + i * 0.0004, 100 + random.NextDouble(), 0.3), 0.01, 0.01, 20, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        var toolpath = builder.Build(Filament);
        Toolpath Read(bool relative) => Decoder.Decode(GCodeWriter.ToBytes(toolpath, new GCodeFormat { RelativeXyz = relative })).Value!.Toolpath;
        var (plain, increments) = (Read(false).Moves().ToArray(), Read(true).Moves().ToArray());
        Assert.That(increments, Has.Length.EqualTo(plain.Length));
        Assert.That(increments.Zip(plain, (a, b) => a.End.DistanceTo(b.End)).Max(), Is.LessThan(1e-9));
    }
}

using System;
using System.Linq;
using System.Text;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Toolpaths;

public class AxisMappingTests
{
    [Test]
    public void A_coordinate_turns_the_platform_and_the_time_stays()
    {
        var mapping = AxisMapping.Drum(PathAxis.X, OutputAxis.A, 40, hold: 5);
        var drawn = Toolpath();
        var mapped = mapping.Apply(drawn);
        var around = 20 / (40 * Math.PI) * 360;
        Assert.That(mapped.Blocks[0].Columns.A, Is.Not.Null);
        Assert.That(mapped.Blocks[0].Columns.A![1], Is.EqualTo(around).Within(1e-12));
        Assert.That(mapped[1].End, Is.EqualTo(new Vec3(5, 0, 1)));
        // Only the platform turns: degrees per second over the same two seconds.
        Assert.That(mapped[1].Speed, Is.EqualTo(around / 2).Within(1e-12));
        // Along Y and around: the remaining motion is along Y.
        Assert.That(mapped[2].Start.DistanceTo(mapped[2].End) / mapped[2].Speed, Is.EqualTo(5 / 10.0).Within(1e-12));
        Assert.That(mapped.Moves().Sum(m => m.E), Is.EqualTo(drawn.Moves().Sum(m => m.E)).Within(1e-12));
        Assert.That(mapped.Events, Has.Count.EqualTo(2));
        Assert.That(mapped.Events[0].Move, Is.EqualTo(1));
    }

    [Test]
    public void Rotary_words_are_written_where_they_change()
    {
        var text = Encoding.ASCII.GetString(GCodeWriter.ToBytes(new AxisMapping(PathAxis.X, OutputAxis.B, 2).Apply(Toolpath()),
            new GCodeFormat { Comments = false }));
        var lines = text.Split('\n').Where(l => l.StartsWith("G0", StringComparison.Ordinal) || l.StartsWith("G1", StringComparison.Ordinal)).ToArray();
        Assert.That(lines, Is.EqualTo(new[] { "G0 X0 Y0 Z1 F1800", "G1 B40 E1 F1200", "G1 Y4 B46 E.25 F480".Replace(" E.", " E0.") }));
    }

    [Test]
    public void A_linear_word_is_scaled_and_arcs_become_chords()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(5, 0));
        builder.Add(new Vec3(-5, 0), 2, 2, 10, MoveKind.Print, Role.Unspecified, -1, 0, 0, new Arc(Vec3.Zero, 180));
        var mapped = new AxisMapping(PathAxis.Y, OutputAxis.Y, 0.5).Apply(builder.Build([new ToolpathTool(1)]));
        Assert.That(mapped.Count, Is.GreaterThan(10));
        Assert.That(mapped.Moves().Max(m => m.End.Y), Is.EqualTo(2.5).Within(0.01));
        Assert.That(mapped.Moves().Sum(m => m.E), Is.EqualTo(2).Within(1e-12));
        Assert.That(mapped.Blocks[0].Columns.A, Is.Null);
    }

    [Test]
    public void Invalid_mappings_are_rejected()
    {
        Assert.That(() => new AxisMapping(PathAxis.X, OutputAxis.A, 0).Apply(Toolpath()), Throws.InvalidOperationException);
        Assert.That(() => new AxisMapping(PathAxis.X, OutputAxis.Y, 1).Apply(Toolpath()), Throws.InvalidOperationException);
        Assert.That(() => AxisMapping.Drum(PathAxis.X, OutputAxis.A, 0), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    private static Toolpath Toolpath()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, null);
        builder.Add(new Vec3(0, 0, 1), 0, 0, 30, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.AddEvent(new FanEvent(1));
        builder.Add(new Vec3(20, 0, 1), 1, 1, 10, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(23, 4, 1), 0.25, 0.25, 10, MoveKind.Print, Role.Unspecified, -1, 0, 0);
        builder.AddEvent(new FanEvent(0));
        return builder.Build([new ToolpathTool(1)]);
    }
}

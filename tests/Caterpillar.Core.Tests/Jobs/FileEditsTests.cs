using System.Linq;
using System.Text;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Jobs;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Jobs;

public class FileEditsTests
{
    private static readonly MoveFilter Prints = new() { Kinds = [MoveKind.Print] };

    // Extrusions from (10, 20) to (30, 20) to (30, 30): their center is (20, 25).
    private static Toolpath Corner() => GCodeDecoder.Decode(GCodeDocument.FromBytes(
        Encoding.ASCII.GetBytes("G90\nM83\nG1 X10 Y20 Z0.2 F3000\nG1 X30 Y20 E1\nG1 X30 Y30 E1\n"), "corner.gcode")).Value!.Toolpath;

    private static double[] BoundsOf(FileEdits edits)
    {
        var box = Prints.BoundsIn(edits.Apply(Corner()).OrThrow());
        return new[] { box.Min.X, box.Max.X, box.Min.Y, box.Max.Y };
    }

    [Test]
    public void Scaling_and_turning_keep_the_center_of_the_print()
    {
        Assert.That(BoundsOf(new FileEdits { Scale = new Vec3(2, 1, 1) }), Is.EqualTo(new[] { 0.0, 40, 20, 30 }).Within(1e-9));
        Assert.That(BoundsOf(new FileEdits { Rotate = 90 }), Is.EqualTo(new[] { 15.0, 25, 15, 35 }).Within(1e-9));
        Assert.That(BoundsOf(new FileEdits { Scale = new Vec3(2, 1, 1), Rotate = 90 }), Is.EqualTo(new[] { 15.0, 25, 5, 45 }).Within(1e-9));
    }

    [Test]
    public void Moving_is_the_last_of_them()
    {
        Assert.That(BoundsOf(new FileEdits { Move = new Vec3(1, 2) }), Is.EqualTo(new[] { 11.0, 31, 22, 32 }).Within(1e-9));
        Assert.That(BoundsOf(new FileEdits { Rotate = 90, Move = new Vec3(1, 2) }), Is.EqualTo(new[] { 16.0, 26, 17, 37 }).Within(1e-9));
    }

    [Test]
    public void A_print_that_hangs_already_is_no_news()
    {
        var text = "G90\nM83\n;LAYER:0\nG1 X10 Y20 Z9 F3000\nG1 X30 Y20 E1\n;LAYER:1\nG1 X10 Y20 Z9.2\nG1 X30 Y20 E1\n";
        var hanging = GCodeDecoder.Decode(GCodeDocument.FromBytes(Encoding.ASCII.GetBytes(text), "hanging.gcode")).Value!.Toolpath;
        Assert.That(new FileEdits { Move = new Vec3(1, 0) }.Apply(hanging).Diagnostics.Select(d => d.Code), Has.None.EqualTo("edit.in_the_air"));
    }
}

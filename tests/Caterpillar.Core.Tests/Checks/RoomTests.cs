using System;
using System.Linq;
using Caterpillar.Basics;
using Caterpillar.Checks;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Checks;

/// <summary>Extrusions need their height above the bed, the object and what is printed; beside them there may be room.</summary>
public class RoomTests
{
    private static readonly PrintSetup Setup = SmallPrint.Setup();

    // Parts of the height of 0.2 mm, and the worst that is said of them.
    private static readonly (double Part, Severity? Worst)[] Parts =
        [(0, Severity.Error), (0.05, Severity.Error), (0.25, Severity.Error), (0.5, Severity.Warning), (0.75, null), (1, null)];

    [Test]
    public void Extrusions_need_their_height_above_the_bed([ValueSource(nameof(Parts))] (double Part, Severity? Worst) gap, [Values] bool isLayered)
    {
        var z = 0.2 * gap.Part;
        var print = new SmallPrint(50, 50, 9).Go(50, 50, z);
        if (isLayered) print.InLayer(new Layer(0, z, 0.2));
        Expect(print.Print(70, 50, z), Setup, gap.Worst, "bed");
    }

    [Test]
    public void Extrusions_need_their_height_above_the_object([ValueSource(nameof(Parts))] (double Part, Severity? Worst) gap)
    {
        var plate = TriMesh.Create([new Vec3(40, 40, 5), new Vec3(80, 40, 5), new Vec3(80, 80, 5), new Vec3(40, 80, 5)], [0, 1, 2, 0, 2, 3]);
        var z = 5 + 0.2 * gap.Part;
        Expect(new SmallPrint(50, 50, 9).Go(50, 50, z).Print(70, 50, z), Setup with { PrintedOn = plate }, gap.Worst, "bed or the object");
    }

    // Along the extrusion below, across many side by side, and on a wall of several layers.
    [Test]
    public void Extrusions_need_their_height_above_earlier_layers(
        [ValueSource(nameof(Parts))] (double Part, Severity? Worst) gap, [Values("along", "across", "wall")] string on, [Values] bool isLayered)
    {
        var print = new SmallPrint(50, 50, 9);
        var top = on == "wall" ? 1.0 : 0.2;
        for (var (k, z) = (0, 0.2); z < top + 0.01; k++, z += 0.2)
        {
            if (isLayered) print.InLayer(new Layer(k, z, 0.2));
            for (var i = 0; i < (on == "across" ? 30 : 1); i++)
            {
                var (from, to) = on == "across" ? (new Vec3(52 + 0.4 * i, 40), new Vec3(52 + 0.4 * i, 60)) : (new Vec3(50, 50), new Vec3(70, 50));
                print.Over(from.X, from.Y, z).Print(to.X, to.Y, z);
            }
        }
        top += 0.2 * gap.Part;
        if (isLayered) print.InLayer(new Layer(9, top, 0.2));
        // Without layers, what is as high as a path belongs to it.
        var worst = isLayered || gap.Part > 0 ? gap.Worst : null;
        Expect(print.Over(50, 50, top).Print(70, 50, top), Setup, worst, "earlier extrusion (");
    }

    // Extrusions side by side, each a little higher than the one before: a leaning wall, and strings that lie almost flat.
    [TestCase(0.2, 0.2)]
    [TestCase(0.2, 0.1)]
    [TestCase(0.4, 0.05)]
    [TestCase(0.4, 0.01)]
    public void Leaning_walls_have_room_beside_what_is_below_them(double aside, double up)
    {
        var print = new SmallPrint(50, 50, 9);
        for (var k = 0; k < 20; k++) print.Over(50, 50 + aside * k, 0.2 + up * k).Print(90, 50 + aside * k, 0.2 + up * k);
        Assert.That(Found(print, Setup).Where(d => d.Code is CheckCodes.TooLow or CheckCodes.Width), Is.Empty);
    }

    // So much of the width lies on the wall below.
    [TestCase(0.33, 0)]
    [TestCase(0.15, 0)]
    [TestCase(0.13, 1)]
    [TestCase(0.05, 1)]
    public void A_wall_rests_on_a_seventh_of_its_width(double overlap, int found)
    {
        var print = new SmallPrint(50, 50, 9);
        for (var k = 0; k < 10; k++) print.InLayer(new Layer(k, 0.2 + 0.2 * k, 0.2)).Over(50, 50, 0.2 + 0.2 * k).Print(90, 50, 0.2 + 0.2 * k);
        // 0.08 mm² in a layer of 0.2 mm, with round sides: 0.4 mm + 0.2 mm (1 − π / 4).
        var y = 50 + 0.443 * (1 - overlap);
        print.InLayer(new Layer(10, 2.2, 0.2)).Over(50, y, 2.2).Print(90, y, 2.2).Over(50, 90, 9);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.Unsupported), Has.Length.EqualTo(found));
    }

    [TestCase(0.4, 0)]
    [TestCase(0.55, 1)]
    [TestCase(5, 1)]
    public void A_print_that_begins_in_the_air_is_refused(double z, int found)
    {
        var print = new SmallPrint(50, 50, 9).Go(50, 50, z).Print(70, 50, z).Print(70, 70, z).Over(50, 50, 9);
        Assert.That(SmallPrint.Find(print.Build(), Setup, CheckCodes.InAir), Has.Length.EqualTo(found));
        var later = new SmallPrint(50, 50, 9).Go(50, 50, 0.2).Print(70, 50, 0.2).Go(70, 50, 5).Print(70, 70, 5).Over(50, 50, 9);
        Assert.That(SmallPrint.Find(later.Build(), Setup, CheckCodes.InAir), Is.Empty);
    }

    // A line of the start code, 0.3 mm high, under 20 lines that cross it.
    [TestCase(0.2, 1)]
    [TestCase(0.5, 0)]
    public void What_the_start_code_has_printed_is_there(double z, int found)
    {
        var print = new SmallPrint(5, 20, 9).Go(5, 20, 0.3).Print(5, 120, 0.3, 0.24, Role.Purge).InLayer(new Layer(0, z, 0.2));
        for (var k = 0; k < 20; k++) print.Over(3, 50 + k, z).Print(40, 50 + k, z);
        var low = SmallPrint.Find(print.Over(0, 0, 9).Build(), Setup, CheckCodes.TooLow);
        Assert.That(low, Has.Length.EqualTo(found));
        if (found > 0) Assert.That(low[0].Message, Does.Contain("earlier extrusion of the start G-code").And.Contain("Move the model, or move the prime line"));
    }

    // 5 mm³ between the walls of a well 2 mm wide and 4 mm high do not fit under the nozzle; without walls they do.
    [TestCase(true, 0.2, 1)]
    [TestCase(false, 0.2, 0)]
    [TestCase(true, 4, 0)]
    public void A_blob_has_the_room_around_it(bool walls, double z, int found)
    {
        var print = new SmallPrint(50, 50, 9);
        for (var k = 0; walls && k < 20; k++)
        {
            var top = 0.2 + 0.2 * k;
            for (var ring = 1.0; ring < 4.5; ring += 0.4)
                print.Over(60 - ring, 60 - ring, top).Print(60 + ring, 60 - ring, top).Print(60 + ring, 60 + ring, top)
                    .Print(60 - ring, 60 + ring, top).Print(60 - ring, 60 - ring, top);
        }
        if (!walls) print.Over(20, 20, 0.2).Print(40, 20, 0.2);
        var blob = SmallPrint.Find(print.Over(60, 60, z).Prime(5).Build(), Setup, CheckCodes.Blob);
        Assert.That(blob, Has.Length.EqualTo(found));
    }

    [Test]
    public void A_refused_blob_is_not_warned_of_too()
    {
        var print = new SmallPrint(50, 50, 9).Go(50, 50, 0.2).Print(70, 50, 0.2).Go(100, 100, 0.2).Prime(30);
        Assert.That(Found(print, Setup).Select(d => d.Code), Is.EqualTo(new[] { CheckCodes.Blob }));
    }

    private static Diagnostic[] Found(SmallPrint print, PrintSetup setup)
        => [.. SmallPrint.Find(print.Build(), setup, "").Where(d => d.Code is CheckCodes.TooLow or CheckCodes.Squeezed or CheckCodes.Blob or CheckCodes.Width)];

    // In the toolpath, and in the file that is read back.
    private static void Expect(SmallPrint print, PrintSetup setup, Severity? worst, string above)
    {
        var toolpath = print.Over(0, 0, 9).Build();
        var (file, _, _) = SmallPrint.Written(toolpath, setup);
        foreach (var found in new[] { Found(print, setup), [.. PrintCheck.Run(file, setup)] })
        {
            var near = found.Where(d => d.Code is CheckCodes.TooLow or CheckCodes.Squeezed).ToArray();
            Assert.That(near.Select(d => (Severity?)d.Severity), worst is null ? Is.Empty : Is.EqualTo(new[] { worst }));
            Assert.That(near.Select(d => d.Message), Is.All.Contain("mm above the " + above).And.All.Contain("Raise the path by"));
        }
    }
}

using System;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Threading;
using Caterpillar.Display;
using Caterpillar.Files;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Display;

public class ImageTests
{
    [Test]
    public void An_extrusion_is_drawn_where_it_was_printed()
    {
        // 10 mm along X seen from above: the middle row is covered over 92 % of the width, the corners are background.
        var image = ToolpathImage.Draw(Line(Vec3.Zero, new Vec3(10, 0, 0)), new ToolpathImageOptions { Width = 200, Height = 100, View = View.Top });
        Assert.That((image.Width, image.Height), Is.EqualTo((200, 100)));
        var background = ToolpathImage.Background;
        Assert.That(image[100, 50], Is.Not.EqualTo(background));
        Assert.That(image[12, 50], Is.Not.EqualTo(background));
        Assert.That(image[100, 10], Is.EqualTo(background));
        // 1 mm² is a round extrusion of 1.13 mm: 10 mm fill 184 pixels, so the extrusion covers about 21 rows.
        var rows = Enumerable.Range(0, 100).Count(y => image[100, y] != background);
        Assert.That(rows, Is.InRange(20, 22));
    }

    [Test]
    public void Beads_of_a_layer_are_as_wide_and_high_as_they_are()
    {
        // 0.4 mm² in a layer 0.5 mm high: 0.8 + 0.5 · (1 − π / 4) = 0.907 mm wide. 10 mm fill 184 of 200 pixels.
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(0, 0, 0.5));
        builder.AddLayer(new Layer(0, 0.5, 0.5));
        builder.Add(new Vec3(10, 0, 0.5), 4, 4, 20, MoveKind.Print, Role.OuterWall, 0, 0, 0);
        var toolpath = builder.Build([new ToolpathTool(1)]);
        foreach (var (view, rows) in new[] { (View.Top, 0.907 * 18.4), (View.Front, 0.5 * 18.4), (new View(-90, 30), 11.56) })
        {
            // From 30°: √((0.907 · sin)² + (0.5 · cos)²) = 0.628 mm.
            var image = ToolpathImage.Draw(toolpath, new ToolpathImageOptions { Width = 200, Height = 100, View = view });
            Assert.That(Covered(image, 100), Is.InRange(rows - 0.5, rows + 2), "with rows that it covers in part");
        }
    }

    [Test]
    public void The_usual_image_is_four_to_three()
    {
        var image = ToolpathImage.Draw(Line(Vec3.Zero, new Vec3(10, 0, 0)));
        Assert.That((image.Width, image.Height), Is.EqualTo((960, 720)));
    }

    [Test]
    public void From_the_front_and_from_above_two_axes_are_those_of_the_image()
    {
        var point = new Vec3(1, 2, 3);
        Assert.That(View.Front.Project(point).DistanceTo(new Vec3(1, 3, -2)), Is.LessThan(1e-12));
        Assert.That(View.Top.Project(point).DistanceTo(new Vec3(1, 2, 3)), Is.LessThan(1e-12));
    }

    [Test]
    public void A_region_fills_the_image()
    {
        // 2 mm of 10 mm fill 184 of 200 pixels, so a bead 1.13 mm wide takes 104 rows.
        var options = new ToolpathImageOptions { Width = 200, Height = 200, View = View.Top, Region = new Bounds(new Vec3(8.5, -1), new Vec3(10.5, 1)) };
        var image = ToolpathImage.Draw(Line(Vec3.Zero, new Vec3(10, 0, 0)), options);
        Assert.That(Covered(image, 60), Is.EqualTo(104).Within(2));
        Assert.That(image[0, 100], Is.Not.EqualTo(ToolpathImage.Background), "the line goes on to the left");
        Assert.That(image[199, 100], Is.EqualTo(ToolpathImage.Background), "and ends at X 10.57");
    }

    private static int Covered(RasterImage image, int x)
        => Enumerable.Range(0, image.Height).Count(y => image[x, y] != ToolpathImage.Background);

    // A dot alone fills the height of the image; seen from the side a disc is flat.
    [Test]
    public void Dots_are_drawn_as_large_as_they_are()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(0, 0, 1));
        builder.Add(new Vec3(0, 0, 1), 30, 30, 2, MoveKind.Prime, Role.Unspecified, -1, 0, 0);
        var toolpath = builder.Build([new ToolpathTool(1)]);
        foreach (var (view, height) in new[] { (View.Top, 92), (View.Front, 15) })
        {
            var image = ToolpathImage.Draw(toolpath, new ToolpathImageOptions { Width = 100, Height = 100, View = view });
            Assert.That(Enumerable.Range(0, 100).Count(y => image[50, y] != ToolpathImage.Background), Is.InRange(height - 2, height + 2));
        }
    }

    [Test]
    public void Near_extrusions_cover_far_ones()
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(0, 0, 1));
        builder.Add(new Vec3(10, 0, 1), 10, 10, 20, MoveKind.Print, Role.OuterWall, -1, 0, 0);
        builder.Add(new Vec3(10, -5, 0), 0, 0, 20, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(5, -5, 0), 0, 0, 20, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        builder.Add(new Vec3(5, 5, 0), 10, 10, 20, MoveKind.Print, Role.Infill, -1, 0, 0);
        var image = ToolpathImage.Draw(builder.Build([new ToolpathTool(1)]), new ToolpathImageOptions { Width = 100, Height = 100, View = View.Top });
        var crossing = image[50, 50];
        // Orange wall above the red infill.
        Assert.That(crossing.G, Is.GreaterThan(crossing.B + 30));
        Assert.That(image[50, 20].G, Is.LessThan(100));
    }

    [Test]
    public void A_toolpath_that_prints_nothing_gives_an_empty_image()
    {
        var image = ToolpathImage.Draw(new ToolpathBuilder(MoveSource.Steps, null).Build([]), new ToolpathImageOptions { Width = 10, Height = 10 });
        Assert.That(image[5, 5], Is.EqualTo(ToolpathImage.Background));
    }

    [Test]
    public void A_png_file_unpacks_to_its_pixels()
    {
        var image = new RasterImage(3, 2, new Rgb(1, 2, 3));
        image[2, 1] = new Rgb(200, 100, 50);
        var file = PngWriter.ToBytes(image);
        Assert.That(file.Take(8), Is.EqualTo(new byte[] { 0x89, 0x50, 0x4E, 0x47, 13, 10, 26, 10 }));
        // IHDR takes 25 bytes after the signature; then length and name of IDAT and two bytes of zlib header.
        var length = (file[33] << 24) | (file[34] << 16) | (file[35] << 8) | file[36];
        using var inflate = new DeflateStream(new MemoryStream(file, 33 + 8 + 2, length - 6), CompressionMode.Decompress);
        using var rows = new MemoryStream();
        inflate.CopyTo(rows);
        var data = rows.ToArray();
        Assert.That(data.Length, Is.EqualTo(2 * 10));
        Assert.That(data.Take(10), Is.EqualTo(new byte[] { 2, 1, 2, 3, 1, 2, 3, 1, 2, 3 }));
        Assert.That(data.Skip(17), Is.EqualTo(new byte[] { 199, 98, 47 }));
    }

    [Test]
    public void Invalid_sizes_are_rejected()
        => Assert.That(() => new RasterImage(0, 10, default), Throws.InstanceOf<ArgumentOutOfRangeException>());

    [Test]
    public void Drawing_can_be_canceled()
        => Assert.That(() => ToolpathImage.Draw(Line(Vec3.Zero, Vec3.UnitX), new ToolpathImageOptions(), cancel: new CancellationToken(true)),
            Throws.InstanceOf<OperationCanceledException>());

    private static Toolpath Line(Vec3 from, Vec3 to)
    {
        var builder = new ToolpathBuilder(MoveSource.Steps, from);
        builder.Add(to, from.DistanceTo(to), from.DistanceTo(to), 20, MoveKind.Print, Role.OuterWall, -1, 0, 0);
        return builder.Build([new ToolpathTool(1)]);
    }

    [Test]
    public void A_dip_below_the_strokes_of_a_pen_does_not_hide_them()
    {
        // A stroke along X at 1 mm, and a way down to 0 and up again with nothing level there.
        var builder = new ToolpathBuilder(MoveSource.Steps, new Vec3(0, 0, 5));
        foreach (var to in new[] { new Vec3(0, 0, 1), new Vec3(10, 0, 1), new Vec3(11, 0, 0), new Vec3(12, 0, 5) })
            builder.Add(to, 0, 0, 20, MoveKind.Travel, Role.Unspecified, -1, 0, 0);
        var image = ToolpathImage.Draw(builder.Build([new ToolpathTool(1)]),
            new ToolpathImageOptions { Width = 100, Height = 100, View = View.Top, Strokes = true });
        Assert.That(image[50, 50], Is.Not.EqualTo(ToolpathImage.Background));
    }
}

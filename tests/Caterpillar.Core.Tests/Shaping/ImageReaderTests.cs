using System;
using System.Linq;
using System.Text;
using Caterpillar.Display;
using Caterpillar.Files;
using Caterpillar.Shaping;
using NUnit.Framework;

namespace Caterpillar.Tests.Shaping;

public class ImageReaderTests
{
    [Test]
    public void A_png_that_was_written_is_read_back()
    {
        var written = new RasterImage(5, 4, new Rgb(255, 255, 255));
        written[1, 2] = new Rgb(51, 51, 51);
        written[4, 3] = new Rgb(255, 0, 0);
        var image = ImageReader.Read(PngWriter.ToBytes(written), "a.png").Value!;
        Assert.That((image.Width, image.Height), Is.EqualTo((5, 4)));
        Assert.That(image[0, 0], Is.EqualTo(1));
        Assert.That(image[1, 2], Is.EqualTo(0.2).Within(1e-12));
        Assert.That(image[4, 3], Is.EqualTo(0.2126).Within(1e-12));
    }

    [Test]
    public void What_follows_the_end_of_a_png_is_not_read()
    {
        var image = ImageReader.Read([.. PngWriter.ToBytes(new RasterImage(5, 4, new Rgb(255, 255, 255))), .. Enumerable.Repeat((byte)'x', 40)], "a.png");
        Assert.That(image.Diagnostics, Is.Empty);
        Assert.That((image.Value!.Width, image.Value[4, 3]), Is.EqualTo((5, 1.0)));
    }

    [TestCaseSource(nameof(ForeignImages))]
    public void Images_of_other_writers_are_read(string base64, double[] expected)
    {
        var image = ImageReader.Read(Convert.FromBase64String(base64), "foreign.png");
        Assert.That(image.Diagnostics, Is.Empty);
        Assert.That(Enumerable.Range(0, expected.Length).Select(i => image.Value![i % 3, i / 3]), Is.EqualTo(expected).Within(1e-9));
    }

    [Test]
    public void Damaged_images_give_errors_and_never_exceptions()
    {
        var png = PngWriter.ToBytes(new RasterImage(20, 20, new Rgb(9, 9, 9)));
        for (var length = 0; length < png.Length - 12; length++)
            Assert.That(ImageReader.Read(png.Take(length).ToArray(), "a.png").Diagnostics, Has.Count.EqualTo(1), $"{length} bytes");
        var random = new Random(1);
        for (var round = 0; round < 3000; round++)
        {
            var broken = (byte[])png.Clone();
            for (var i = 0; i < 3; i++) broken[8 + random.Next(broken.Length - 8)] = (byte)random.Next(256);
            Assert.That(() => ImageReader.Read(broken, "a.png"), Throws.Nothing);
        }
        foreach (var text in new[] { "GIF89a", "P2 1 1 1 0" })
            Assert.That(ImageReader.Read(Encoding.ASCII.GetBytes(text + new string(' ', 40)), "a.png").Value, Is.Null, text);
    }

    [Test]
    public void An_image_repeats_from_left_to_right()
    {
        var image = new GrayImage(4, 1, [0, 0.1, 0.2, 0.3]);
        Assert.That(new[] { 0.3, 1.3, -0.2, -1.7 }.Select(u => image.Nearest(u, 0.5)), Is.EqualTo(new[] { 0.1, 0.1, 0.3, 0.1 }));
    }

    [Test]
    public void An_image_has_at_least_one_pixel()
    {
        Assert.That(() => new GrayImage(0, 1, []), Throws.ArgumentException);
        Assert.That(() => new GrayImage(1, 0, []), Throws.ArgumentException);
        Assert.That(() => new GrayImage(2, 1, [0.5]), Throws.ArgumentException);
    }

    private static readonly object[] ForeignImages =
    [
        // 4-bit gray, interlaced
        new object[] { "iVBORw0KGgoAAAANSUhEUgAAAAMAAAADBAAAAAHBtDf0AAAAFUlEQVR4nGNgYFBgyGcQYChgMAkAAAedAZT+slCVAAAAAElFTkSuQmCC",
            new double[] { 0.0, 0.06666666666666667, 0.13333333333333333, 0.2, 0.26666666666666666, 0.3333333333333333, 0.4, 0.4666666666666667, 1.0 } },
        // palette of 2 bits with transparency
        new object[]
        {
            "iVBORw0KGgoAAAANSUhEUgAAAAMAAAACAgMAAADgGo6JAAAADFBMVEUAAAD/////AAAAAAAsH9zHAAAABHRSTlP///8AQCqp9AAAAAxJREFUeJ"
                + "xjkGA4AgABEADdEeUPIgAAAABJRU5ErkJggg==",
            new double[] { 0, 1, 0.2126, 1, 0, 1 },
        },
        // 16-bit gray with alpha and the filters sub, up, average and Paeth
        new object[]
        {
            "iVBORw0KGgoAAAANSUhEUgAAAAMAAAAEEAQAAACxtJHPAAAAOklEQVR4nGNkYPgPBAwMjYwMDEzMLxgYOC4yMHTvYGRkfvmmocF7BwOD6Z6GBh"
                + "YxaQYGxgygEl8GBgCzXw5EU5IOAgAAAABJRU5ErkJggg==",
            new double[] { 0.0, 1.0, 0.500007629511, 0.015259021897, 0.030518043793, 1.0,
                0.915541313802, 0.762951094835, 0.610360875868, 0.001876859693, 0.006958113985, 0.012039368276 },
        },
    ];

    [Test]
    public void Every_filter_works_in_the_first_row_and_below_it()
    {
        // 3 × 2 gray pixels of 8 bits: 51, 102, 153 over 204, 153, 102, each row as its filter writes it.
        byte[] top = [51, 102, 153], low = [204, 153, 102];
        for (var filter = 0; filter <= 4; filter++)
        {
            var image = ImageReader.Read(Png(3, 2, [.. Filtered(top, new byte[3], filter), .. Filtered(low, top, filter)]), "a.png").OrThrow();
            var read = Enumerable.Range(0, 6).Select(i => Math.Round(image[i % 3, i / 3] * 255)).ToArray();
            Assert.That(read, Is.EqualTo(new double[] { 51, 102, 153, 204, 153, 102 }), "filter " + filter);
        }
    }

    [Test]
    public void Pixels_of_a_palette_have_the_brightness_of_their_color()
    {
        // Black, white, red, gray; a transparent last one is white.
        byte[] colors = [0, 0, 0, 255, 255, 255, 255, 0, 0, 51, 51, 51, 0, 0, 0];
        var image = ImageReader.Read(Png(5, 1, [0, 0, 1, 2, 3, 4], 3, [.. Chunk("PLTE", colors), .. Chunk("tRNS", [255, 255, 255, 255, 0])]), "a.png")
            .OrThrow();
        Assert.That(Enumerable.Range(0, 5).Select(i => image[i, 0]), Is.EqualTo(new[] { 0, 1, 0.2126, 0.2, 1 }).Within(1e-9));
        Assert.That(ImageReader.Read(Png(1, 1, [0, 5], 3, Chunk("PLTE", colors)), "a.png").Value, Is.Null, "a color beyond the palette");
    }

    // By the standard: what is written is the difference from the left, from above, from the mean of both, or from the nearest of three.
    private static byte[] Filtered(byte[] row, byte[] above, int filter)
    {
        var result = new byte[row.Length + 1];
        result[0] = (byte)filter;
        for (var i = 0; i < row.Length; i++)
        {
            int left = i > 0 ? row[i - 1] : 0, up = above[i], corner = i > 0 ? above[i - 1] : 0, guess = left + up - corner;
            int[] candidates = [left, up, corner];
            var nearest = candidates.OrderBy(c => Math.Abs(guess - c)).First();
            result[i + 1] = (byte)(row[i] - new[] { 0, left, up, (left + up) / 2, nearest }[filter]);
        }
        return result;
    }

    private static byte[] Png(int width, int height, byte[] rows, byte kind = 0, byte[]? before = null)
    {
        using var packed = new System.IO.MemoryStream();
        packed.Write([0x78, 0x9C], 0, 2);
        using (var deflate = new System.IO.Compression.DeflateStream(packed, System.IO.Compression.CompressionMode.Compress, true)) deflate.Write(rows, 0,
            rows.Length);
        uint a = 1, b = 0;
        foreach (var value in rows)
        {
            a = (a + value) % 65521;
            b = (b + a) % 65521;
        }
        packed.Write(Number(b << 16 | a), 0, 4);
        return
        [
            0x89, 0x50, 0x4E, 0x47, 13, 10, 26, 10, .. Chunk("IHDR", [.. Number((uint)width), .. Number((uint)height), 8, kind, 0, 0, 0]), .. before ?? [],
            .. Chunk("IDAT", packed.ToArray()), .. Chunk("IEND", []),
        ];
    }

    private static byte[] Chunk(string name, byte[] data)
    {
        byte[] named = [.. Encoding.ASCII.GetBytes(name), .. data];
        return [.. Number((uint)data.Length), .. named, .. Number(Crc32.Of(named, 0, named.Length))];
    }

    private static byte[] Number(uint value) => [(byte)(value >> 24), (byte)(value >> 16), (byte)(value >> 8), (byte)value];
}

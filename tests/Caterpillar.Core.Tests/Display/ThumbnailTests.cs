using System;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using Caterpillar.Checks;
using Caterpillar.Files;
using Caterpillar.GCode;
using Caterpillar.Machines;
using Caterpillar.Tests.Checks;
using Caterpillar.Toolpaths;
using NUnit.Framework;

namespace Caterpillar.Tests.Display;

public class ThumbnailTests
{
    [Test]
    public void A_file_has_images_of_the_sizes_that_the_printer_asks_for()
    {
        var setup = SmallPrint.Setup(p => p with { Thumbnails = new([new(32, 24, 0), new(100, 80, 0)]) });
        var text = SafeWriter.ToDocument(new SmallPrint().Print(60, 10, 0.2).Print(60, 60, 0.2).Build(), setup).OrThrow();
        var lines = Encoding.UTF8.GetString(text.ToBytes()).Split('\n');
        Assert.That(GCodeDecoder.Decode(text).Value!.Report.Thumbnails,
            Is.EqualTo(new[] { new Thumbnail(32, 24, "PNG"), new Thumbnail(100, 80, "PNG") }));
        var begin = Array.FindIndex(lines, l => l.StartsWith("; thumbnail begin 100x80 ", StringComparison.Ordinal));
        var base64 = string.Concat(lines.Skip(begin + 1).TakeWhile(l => l != "; thumbnail end").Select(l => l.Substring(2)));
        Assert.That(lines[begin], Is.EqualTo("; thumbnail begin 100x80 " + base64.Length));
        Assert.That(lines.Take(begin).Any(l => l.StartsWith("G1", StringComparison.Ordinal)), Is.False, "OctoPrint reads those before the first extrusion.");
        var image = ImageReader.Read(Convert.FromBase64String(base64), "a.png").Value!;
        Assert.That((image.Width, image.Height), Is.EqualTo((100, 80)));
    }

    [Test]
    public void Findings_name_the_lines_of_the_file_with_its_images()
    {
        var setup = SmallPrint.Setup(p => p with { Thumbnails = new([new(100, 100, 0)]) });
        var toolpath = new SmallPrint().Print(60, 10, 0.2).Over(500, 10, 0.2).Build();
        var reason = SafeWriter.ToDocument(toolpath, setup, "a test");
        var outside = reason.Diagnostics.First(d => d.Code == CheckCodes.Outside);
        Assert.That(reason.Value!.Line(outside.Source!.Line!.Value), Does.Contain("X500"));
    }

    [Test]
    public void Packed_bytes_are_the_same_everywhere_and_unpack_to_what_they_were()
    {
        // One block, fixed codes: "a", then 9 bytes from 1 byte before, the end.
        Assert.That(DeflateWriter.Pack(Encoding.ASCII.GetBytes("aaaaaaaaaa")), Is.EqualTo(new byte[] { 0x4B, 0x84, 0x03, 0x00 }));
        Assert.That(DeflateWriter.Pack([]), Is.EqualTo(new byte[] { 0x03, 0x00 }));
        var random = new Random(7);
        for (var round = 0; round < Rounds.Of(20, 60); round++)
        {
            var data = new byte[random.Next(1, 80_000)];
            var range = random.Next(1, 257);
            for (var i = 0; i < data.Length; i++) data[i] = (byte)(random.Next(20) < 10 && i > 700 ? data[i - random.Next(1, 700)] : random.Next(range));
            if (round % 3 == 0) Array.Clear(data, 0, data.Length / 2);
            using var inflate = new DeflateStream(new MemoryStream(DeflateWriter.Pack(data)), CompressionMode.Decompress);
            using var back = new MemoryStream();
            inflate.CopyTo(back);
            Assert.That(back.ToArray(), SameBytes.As(data));
        }
    }
}

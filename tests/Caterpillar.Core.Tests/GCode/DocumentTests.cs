using System;
using System.IO;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Files;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using NUnit.Framework;

namespace Caterpillar.Tests.GCode;

/// <summary>Lines and words of a document, and every byte of it.</summary>
public class DocumentTests
{
    private static readonly Encoding Latin1 = Encoding.GetEncoding(28591);

    [TestCase("", 0)]
    [TestCase("\n", 1)]
    [TestCase("G28", 1)]
    [TestCase("G28\n", 1)]
    [TestCase("G28\r\nG1\rG2\n\r\nM1", 5)]
    [TestCase("\r\r\n\n\r", 4)]
    [TestCase("a\n\rb", 3)]
    public void Line_ends_may_be_of_every_kind(string text, int lines)
    {
        var document = GCodeDocument.FromText(text);
        Assert.That(document.LineCount, Is.EqualTo(lines));
        Assert.That(Latin1.GetString(document.ToBytes()), Is.EqualTo(text));
        var plain = text.Replace("\r\n", "\n").Replace('\r', '\n').Split('\n').Take(lines).ToArray();
        Assert.That(document.Lines(1, 100), Is.EqualTo(plain));
        Assert.That(() => document.Line(0), Throws.InstanceOf<ArgumentOutOfRangeException>());
        Assert.That(() => document.Line(lines + 1), Throws.InstanceOf<ArgumentOutOfRangeException>());
    }

    [Test]
    public void A_folder_is_no_file()
    {
        var folder = TestContext.CurrentContext.TestDirectory;
        Assert.That(() => GCodeDecoder.DecodeFile(folder), Throws.InstanceOf<IOException>().With.Message.Contains("is a folder"));
        Assert.That(() => GCodeDocument.ReadFile(folder), Throws.InstanceOf<IOException>().With.Message.Contains("is a folder"));
    }

    [Test]
    public void Lines_are_found_over_the_edges_of_chunks_and_buffers()
    {
        var random = new Random(11);
        var text = new StringBuilder();
        string[] ends = ["\n", "\r\n", "\r"];
        var lines = 0;
        for (; text.Length < 1_500_000; lines++) text.Append(lines).Append(random.Next(2000) == 0 ? new string('x', 300_000) : "").Append(ends[random.Next(3)])
            .Append(random.Next(50) == 0 ? " " : "#");
        var bytes = Encoding.ASCII.GetBytes(text.ToString());
        foreach (var document in new[] { GCodeDocument.FromBytes(bytes), GCodeDocument.Read(new MemoryStream(bytes)).Value!,
            GCodeDocument.FromBytes(Gzip.Packed(bytes)) })
        {
            Assert.That(document.ToBytes(), SameBytes.As(bytes));
            Assert.That(document.LineCount, Is.EqualTo(lines + 1));
            for (var number = 2; number <= lines; number += 997) Assert.That(document.Line(number).TrimEnd('x').TrimStart(' ', '#'),
                Is.EqualTo(NumberFormatter.Format(number - 1)));
        }
    }

    [Test]
    public void A_byte_order_mark_belongs_to_the_first_line_and_not_to_its_text()
    {
        byte[] bytes = [0xEF, 0xBB, 0xBF, .. Encoding.ASCII.GetBytes("G1 X5 E1\nG1 X6 E2\n")];
        var document = GCodeDocument.FromBytes(bytes);
        Assert.That(document.Line(1), Is.EqualTo("G1 X5 E1"));
        Assert.That(document.ToBytes(), Is.EqualTo(bytes));
        var decoding = GCodeDecoder.Decode(document).Value!;
        Assert.That(decoding.Report.ByteOrderMark, Is.True);
        Assert.That(decoding.Toolpath[0].End.X, Is.EqualTo(5));
        // Only at the beginning.
        Assert.That(GCodeDocument.FromText("G1\n\u00ef\u00bb\u00bfG1\n").Line(2), Has.Length.EqualTo(5));
    }

    [Test]
    public void Bytes_of_zero_are_bytes_like_others()
    {
        var text = "G1 X1\0 Y2\n\0\nG1\0X3 E1\nG1 X4 E2\0\n\0\0";
        var document = GCodeDocument.FromText(text);
        Assert.That(document.LineCount, Is.EqualTo(5));
        Assert.That(Latin1.GetString(document.ToBytes()), Is.EqualTo(text));
        Assert.That(GCodeDecoder.Decode(document).Value!.Toolpath[GCodeDecoder.Decode(document).Value!.Toolpath.Count - 1].End.X, Is.EqualTo(4));
    }

    [Test]
    public void What_is_no_code_is_none()
    {
        foreach (var line in new[] { "%", "% G1 X9", "@pause G1 X9", "<G1 X9/>", "; G1 X9", "(G1 X9)", "M117 G1 X9", "START_PRINT X=9", "", "   \t" })
        {
            Assert.That(Ends("G1 X1 E1\n" + line + "\nG1 Y1 E2\n"), Is.EqualTo(new[] { new Vec3(1, 0, 0), new Vec3(1, 1, 0) }), line);
        }
    }

    [Test]
    public void Numbers_checksums_and_block_delete_are_read_past()
    {
        Assert.That(Ends("N1 G1 X1 E1*99\nN2G1Y1E2 *12\n/G1 X2 E3\n/N3 G1 Y2 E4 ; *\n"),
            Is.EqualTo(new[] { new Vec3(1, 0, 0), new Vec3(1, 1, 0), new Vec3(2, 1, 0), new Vec3(2, 2, 0) }));
    }

    [TestCase("g1x10y-5e1", 10, -5, 1)]
    [TestCase("G01X+10.Y-5.E1.0", 10, -5, 1)]
    [TestCase("G1 X1e+01 Y-5 E1", 10, -5, 1)]
    [TestCase("G1 X1.0E+01 Y-5 E1", 10, -5, 1)]
    [TestCase("G1 X100e-01 Y-50e-01 E10e-01", 10, -5, 1)]
    [TestCase("g1x10e1y-5", 10, -5, 1)]
    [TestCase("G 1 X 10 Y -5 E 1", 10, -5, 1)]
    [TestCase("\tG1\tX00010.000\tY-5\tE.1e+01\t", 10, -5, 1)]
    [TestCase("G1 X9 X10 Y-5 E1", 10, -5, 1)]
    public void Numbers_may_be_written_in_every_way(string line, double x, double y, double e)
    {
        foreach (var end in new[] { "\n", "\r", "\r\n", "" })
        {
            var moves = GCodeDecoder.Decode(Encoding.ASCII.GetBytes("M83\n" + line + end)).Value!.Toolpath;
            Assert.That(moves.Count, Is.EqualTo(1));
            Assert.That((moves[0].End.X, moves[0].End.Y, moves[0].E), Is.EqualTo((x, y, e)));
        }
    }

    [Test]
    public void A_stream_may_give_its_bytes_in_any_pieces()
    {
        var text = Encoding.ASCII.GetBytes("\u00ef\u00bb\u00bfG1 X1 E1\r\nG1 X2 E2\r\n".Substring(3));
        foreach (var bytes in new[] { text, Gzip.Packed(text), new BinaryFile().Code(2, 2, "G1 X1 E1\nG1 X2 E2\n").ToArray() })
            Assert.That(GCodeDecoder.DecodeStream(new Trickle(bytes)).Value!.Report.EUsed, Is.EqualTo(2));
    }

    [Test]
    public void A_line_that_no_memory_should_hold_is_an_error()
    {
        const int Longest = 200_000;
        Assert.That(Read(Longest), Is.EqualTo(Longest));
        Assert.That(() => Read(Longest + 1), Throws.InstanceOf<InvalidDataException>().With.Message.Contains("longer than 200000 bytes"));
        Assert.That(() => Read(1L << 40), Throws.InstanceOf<InvalidDataException>());

        static long Read(long length) => ChunkReader.Read(new Endless(length), 1000, default, Longest).Sum(c => (long)c.Length);
    }

    [Test]
    public void More_lines_than_a_number_can_count_are_an_error()
        => Assert.That(() => GCodeDocument.AddLines(int.MaxValue - 5, 6), Throws.InstanceOf<InvalidDataException>());

    private static Vec3[] Ends(string text) => GCodeDecoder.Decode(Encoding.ASCII.GetBytes(text)).Value!.Toolpath.Moves().Select(m => m.End).ToArray();

    private sealed class Trickle(byte[] bytes) : ReadStream
    {
        private int _at;

        public override int Read(byte[] buffer, int offset, int count)
        {
            if (_at == bytes.Length || count == 0) return 0;
            buffer[offset] = bytes[_at++];
            return 1;
        }
    }

    // Letters without a line end.
    private sealed class Endless(long length) : ReadStream
    {
        private long _left = length;

        public override int Read(byte[] buffer, int offset, int count)
        {
            var part = (int)Math.Min(count, _left);
            for (var i = 0; i < part; i++) buffer[offset + i] = (byte)'a';
            _left -= part;
            return part;
        }
    }
}

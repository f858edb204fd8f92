using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;
using Caterpillar.Basics;
using Caterpillar.Files;
using NUnit.Framework;

namespace Caterpillar.Tests.Basics;

/// <summary>One decompressor for every reader: its result is complete, or it is an error.</summary>
public class GzipTests
{
    private static readonly byte[] Empty = [];

    [Test]
    public void Checksums_are_those_of_the_standard()
    {
        Assert.That(Crc32.Of(Encoding.ASCII.GetBytes("123456789"), 0, 9), Is.EqualTo(0xCBF43926u));
        var bytes = Noise(1, 1000);
        for (var cut = 0; cut < 100; cut++) Assert.That(Crc32.Of(bytes, cut, 900 - cut, Crc32.Of(bytes, 0, cut)),
            Is.EqualTo(GCode.BinaryFile.Crc(bytes.Take(900))));
    }

    [Test]
    public void Members_follow_each_other_and_zeros_are_padding()
    {
        var a = Noise(1, 70_000);
        var b = Encoding.ASCII.GetBytes("G1 X1\n");
        var parts = new[] { Gzip.Packed(a), Gzip.Packed(b), Gzip.Stored(Empty), Gzip.Stored(a), Gzip.Packed(Empty), Flushed(), new byte[3], Gzip.Packed(b),
            new byte[700] };
        Assert.That(Unpacked(Join(parts), out var trailing), SameBytes.As(Join(a, b, a, b)));
        Assert.That(trailing, Is.False);
    }

    [Test]
    public void Garbage_after_the_end_is_ignored_and_reported()
    {
        foreach (var garbage in new byte[][] { [65], [0, 0, 65], [0x1F, 0x20], Noise(3, 30_000) })
        {
            Assert.That(Unpacked(Join(Gzip.Packed([1, 2, 3]), garbage), out var trailing), Is.EqualTo(new byte[] { 1, 2, 3 }));
            Assert.That(trailing, Is.True);
        }
    }

    [Test]
    public void Every_field_of_the_header_is_skipped()
    {
        var data = Encoding.ASCII.GetBytes("G28\n");
        Assert.That(Unpacked(Gzip.Stored(data, 4, 3, 0, 1, 2, 0), out _), Is.EqualTo(data));
        Assert.That(Unpacked(Gzip.Stored(data, 8, 65, 66, 0), out _), Is.EqualTo(data));
        Assert.That(Unpacked(Gzip.Stored(data, 4 + 8 + 16 + 2, 1, 0, 9, 65, 0, 66, 67, 0, 1, 2), out _), Is.EqualTo(data));
    }

    [Test]
    public void Bytes_of_any_size_come_back()
    {
        var random = new Random(4);
        foreach (var size in new[] { 0, 1, 7, 8, 8191, 8192, 8193, 16_384, 65_535, 81_920, 200_001 })
        {
            foreach (var data in new[] { Noise(size, size), Enumerable.Repeat((byte)65, size).ToArray() })
            {
                // Some runtimes compress no bytes to no bytes at all.
                foreach (var packed in new[] { Gzip.Packed(data), Gzip.Stored(data) }.Where(p => p.Length > 0))
                {
                    Assert.That(Unpacked(Join(packed, packed), out _), SameBytes.As(Join(data, data)));
                    // A stream that returns any number of bytes, and readers that ask for few.
                    using var slow = new GzipReader(new Slow(packed, random));
                    using var memory = new MemoryStream();
                    var block = new byte[5000];
                    for (int read; (read = slow.Read(block, 0, random.Next(1, block.Length))) > 0;) memory.Write(block, 0, read);
                    Assert.That(memory.ToArray(), SameBytes.As(data));
                }
            }
        }
    }

    [Test]
    public void A_file_that_is_cut_off_anywhere_is_an_error()
    {
        var text = Encoding.ASCII.GetBytes(string.Concat(Enumerable.Range(0, 20).Select(i => $"G1 X{i * 7 % 50} Y{i} E.{i}\n")));
        foreach (var packed in new[] { Gzip.Packed(text), Gzip.Stored(text), Gzip.Packed(Empty), Gzip.Stored(Empty),
            Join(Gzip.Packed(text), Gzip.Packed(text)) })
        {
            var first = Gzip.Packed(text).Length;
            for (var length = 2; length < packed.Length; length++)
            {
                // Between two members nothing is missing.
                if (length == first && packed.Length == 2 * first) continue;
                Assert.That(() => Unpacked(packed.Take(length).ToArray(), out _), Throws.InstanceOf<InvalidDataException>().With.Message.Contains("cut off"),
                    $"{length} of {packed.Length}");
            }
        }
    }

    [Test]
    public void A_changed_byte_is_an_error_or_changes_nothing()
    {
        var data = Join(Noise(5, 60), new byte[100]);
        foreach (var packed in new[] { Gzip.Packed(data), Gzip.Stored(data) })
        {
            for (var at = 2; at < packed.Length; at++)
            {
                for (var bit = 0; bit < 8; bit++)
                {
                    var copy = (byte[])packed.Clone();
                    copy[at] ^= (byte)(1 << bit);
                    try
                    {
                        Assert.That(Unpacked(copy, out _), SameBytes.As(data), () => $"byte {at}");
                        Assert.That(at, Is.LessThan(packed.Length - 8), "Checksum and length are checked.");
                    }
                    catch (InvalidDataException)
                    {
                    }
                }
            }
        }
    }

    [Test]
    public void Bombs_are_refused()
    {
        // 80 MB of zeros in 80 KB.
        using var memory = new MemoryStream();
        using (var packed = new GZipStream(memory, CompressionMode.Compress, true))
        {
            var block = new byte[1 << 20];
            for (var k = 0; k < 80; k++) packed.Write(block, 0, block.Length);
        }
        using var stream = new GzipReader(new MemoryStream(memory.ToArray()));
        var buffer = new byte[1 << 20];
        long count = 0;
        Assert.That(() => Drain(), Throws.InstanceOf<InvalidDataException>().With.Message.Contains("250 times"));
        Assert.That(count, Is.LessThan(70L << 20));

        void Drain()
        {
            for (int read; (read = stream.Read(buffer, 0, buffer.Length)) > 0;) count += read;
        }
    }

    [Test]
    public void An_error_of_the_disk_stays_one()
    {
        using var stream = new GzipReader(new Failing(Gzip.Packed(Noise(6, 200_000))));
        Assert.That(() => stream.CopyTo(Stream.Null), Throws.InstanceOf<IOException>().With.Message.EqualTo("The disk is gone."));
    }

    [Test]
    public void What_is_not_packed_is_passed_on()
    {
        foreach (var bytes in new byte[][] { [], [0x1F], [65, 66, 67], [0x1F, 0x1F, 0x8B] })
        {
            foreach (var source in new Stream[] { new MemoryStream(bytes), new Slow(bytes, new Random(7)) })
            {
                using var memory = new MemoryStream();
                using var open = GzipReader.Open(source);
                open.CopyTo(memory);
                Assert.That(memory.ToArray(), Is.EqualTo(bytes));
            }
        }
    }

    [Test]
    public void A_stream_that_is_closed_closes_what_it_reads()
    {
        foreach (var bytes in new byte[][] { [65, 66, 67], [0x1F, 0x8B, 8, 0] })
        {
            foreach (var source in new MemoryStream[] { new(bytes), new Unseekable(bytes) })
            {
                GzipReader.Open(source).Dispose();
                Assert.That(source.CanRead, Is.False);
            }
        }
    }

    // An empty member that is flushed twice.
    private static byte[] Flushed() => Join([0x1F, 0x8B, 8, 0, 0, 0, 0, 0, 0, 255, 0, 0, 0, 0xFF, 0xFF, 0, 0, 0, 0xFF, 0xFF, 3, 0], new byte[8]);

    private static byte[] Unpacked(byte[] packed, out bool trailing)
    {
        using var stream = new GzipReader(new MemoryStream(packed));
        using var memory = new MemoryStream();
        stream.CopyTo(memory);
        trailing = stream.HasTrailingBytes;
        return memory.ToArray();
    }

    private static byte[] Noise(int seed, int count)
    {
        var bytes = new byte[count];
        new Random(seed).NextBytes(bytes);
        return bytes;
    }

    private static byte[] Join(params IEnumerable<byte>[] parts) => parts.SelectMany(p => p).ToArray();

    private sealed class Unseekable(byte[] bytes) : MemoryStream(bytes)
    {
        public override bool CanSeek => false;
    }

    private sealed class Slow(byte[] bytes, Random random) : ReadStream
    {
        private int _at;

        public override int Read(byte[] buffer, int offset, int count)
        {
            var part = Math.Min(Math.Min(count, random.Next(1, 3000)), bytes.Length - _at);
            Buffer.BlockCopy(bytes, _at, buffer, offset, part);
            _at += part;
            return part;
        }
    }

    private sealed class Failing(byte[] bytes) : ReadStream
    {
        private int _at;

        public override int Read(byte[] buffer, int offset, int count)
        {
            if (_at > 100_000) throw new IOException("The disk is gone.");
            var part = Math.Min(count, bytes.Length - _at);
            Buffer.BlockCopy(bytes, _at, buffer, offset, part);
            _at += part;
            return part;
        }
    }

    [Test]
    public void Packed_data_may_grow_250_times_and_to_64_MB_in_any_case()
    {
        Assert.That(GzipReader.Limit(1), Is.EqualTo(64L << 20));
        Assert.That(GzipReader.Limit(1L << 30), Is.EqualTo(250L << 30));
    }
}

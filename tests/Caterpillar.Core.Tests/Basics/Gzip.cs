using System.Collections.Generic;
using System.IO;
using System.IO.Compression;

namespace Caterpillar.Tests;

/// <summary>Compresses bytes with gzip.</summary>
internal static class Gzip
{
    public static byte[] Packed(byte[] bytes)
    {
        using var memory = new MemoryStream();
        using (var packed = new GZipStream(memory, CompressionMode.Compress, true)) packed.Write(bytes, 0, bytes.Length);
        return memory.ToArray();
    }

    /// <summary>A member by hand: its header with these flags and fields, stored blocks without compression, checksum and length.</summary>
    public static byte[] Stored(byte[] bytes, int flags = 0, params byte[] fields)
    {
        var file = new List<byte> { 0x1F, 0x8B, 8, (byte)flags, 1, 2, 3, 4, 0, 255 };
        file.AddRange(fields);
        for (var at = 0; at == 0 || at < bytes.Length;)
        {
            var count = System.Math.Min(60_000, bytes.Length - at);
            file.Add((byte)(at + count >= bytes.Length ? 1 : 0));
            file.AddRange([(byte)count, (byte)(count >> 8), (byte)~count, (byte)(~count >> 8)]);
            for (var i = 0; i < count; i++) file.Add(bytes[at + i]);
            at += System.Math.Max(count, 1);
        }
        var sum = GCode.BinaryFile.Crc(bytes);
        foreach (var value in new[] { sum, (uint)bytes.Length })
        {
            for (var k = 0; k < 4; k++) file.Add((byte)(value >> (8 * k)));
        }
        return file.ToArray();
    }
}

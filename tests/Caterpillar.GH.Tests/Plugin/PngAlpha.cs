using System;
using System.IO;
using System.IO.Compression;
using System.Text;

namespace Caterpillar.GH.Tests.Plugin;

/// <summary>Size and alpha of a PNG of 8-bit RGBA without filters, as the icon tool writes them: a bitmap can't be made on every platform.</summary>
internal static class PngAlpha
{
    public static (int Width, int Height, byte[] Alpha) Read(Stream stream)
    {
        using var memory = new MemoryStream();
        stream.CopyTo(memory);
        var bytes = memory.ToArray();
        int width = Number(bytes, 16), height = Number(bytes, 20);
        if (bytes[24] != 8 || bytes[25] != 6) throw new InvalidDataException("Not 8-bit RGBA.");
        using var packed = new MemoryStream();
        for (var at = 8; at < bytes.Length; at += Number(bytes, at) + 12)
        {
            if (Encoding.ASCII.GetString(bytes, at + 4, 4) == "IDAT") packed.Write(bytes, at + 8, Number(bytes, at));
        }
        // After the two bytes of the zlib header.
        packed.Position = 2;
        using var rows = new MemoryStream();
        using (var deflate = new DeflateStream(packed, CompressionMode.Decompress)) deflate.CopyTo(rows);
        var raw = rows.ToArray();
        var alpha = new byte[width * height];
        for (var i = 0; i < alpha.Length; i++)
        {
            var row = i / width * (4 * width + 1);
            if (raw[row] != 0) throw new InvalidDataException("A filtered row.");
            alpha[i] = raw[row + 4 + 4 * (i % width)];
        }
        return (width, height, alpha);
    }

    private static int Number(byte[] bytes, int at) => bytes[at] << 24 | bytes[at + 1] << 16 | bytes[at + 2] << 8 | bytes[at + 3];
}

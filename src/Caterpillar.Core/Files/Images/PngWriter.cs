namespace Caterpillar.Files;

/// <summary>Writes images as PNG (8 bits per channel, no alpha): the same bytes on every runtime.</summary>
public static class PngWriter
{
    /// <summary>The bytes of a PNG file. Pixels of the <paramref name="clear"/> color are transparent; null = none.</summary>
    public static byte[] ToBytes(RasterImage image, Rgb? clear = null)
    {
        if (image is null) throw new ArgumentNullException(nameof(image));
        using var file = new MemoryStream();
        file.Write([0x89, (byte)'P', (byte)'N', (byte)'G', 13, 10, 26, 10], 0, 8);
        var header = new byte[13];
        BigEndian(header, 0, (uint)image.Width);
        BigEndian(header, 4, (uint)image.Height);
        header[8] = 8;
        header[9] = 2;
        Chunk(file, "IHDR", header);
        if (clear is { } color) Chunk(file, "tRNS", [0, color.R, 0, color.G, 0, color.B]);
        Chunk(file, "IDAT", Compressed(Filtered(image)));
        Chunk(file, "IEND", []);
        return file.ToArray();
    }

    // Filter "up": each byte minus the one above it.
    private static byte[] Filtered(RasterImage image)
    {
        var row = image.Width * 3;
        var data = new byte[(row + 1) * image.Height];
        for (var y = 0; y < image.Height; y++)
        {
            var to = y * (row + 1);
            data[to++] = 2;
            for (var x = 0; x < row; x++)
                data[to + x] = (byte)(image.Bytes[y * row + x] - (y > 0 ? image.Bytes[(y - 1) * row + x] : 0));
        }
        return data;
    }

    private static byte[] Compressed(byte[] data)
    {
        using var memory = new MemoryStream();
        memory.WriteByte(0x78);
        memory.WriteByte(0x9C);
        var packed = DeflateWriter.Pack(data);
        memory.Write(packed, 0, packed.Length);
        var sum = new byte[4];
        BigEndian(sum, 0, Adler32.Of(data));
        memory.Write(sum, 0, 4);
        return memory.ToArray();
    }

    private static void Chunk(Stream file, string name, byte[] data)
    {
        var bytes = new byte[data.Length + 12];
        BigEndian(bytes, 0, (uint)data.Length);
        for (var i = 0; i < 4; i++) bytes[4 + i] = (byte)name[i];
        Array.Copy(data, 0, bytes, 8, data.Length);
        BigEndian(bytes, bytes.Length - 4, Crc32.Of(bytes, 4, bytes.Length - 8));
        file.Write(bytes, 0, bytes.Length);
    }

    private static void BigEndian(byte[] bytes, int at, uint value)
    {
        for (var i = 0; i < 4; i++) bytes[at + i] = (byte)(value >> (24 - 8 * i));
    }
}

namespace Caterpillar.Files;

/// <summary>Netpbm graymaps (P2, P5) and bitmaps (P1, P4).</summary>
internal static class PgmReader
{
    public static bool IsPgm(byte[] bytes)
        => bytes.Length > 2 && bytes[0] == 'P' && bytes[1] is (byte)'1' or (byte)'2' or (byte)'4' or (byte)'5' && bytes[2] <= ' ';

    /// <exception cref="InvalidDataException">The file is damaged.</exception>
    public static GrayImage Read(byte[] bytes)
    {
        var kind = bytes[1] - '0';
        var bits = kind is 1 or 4;
        var at = 2;
        var width = Number(bytes, ref at);
        var height = Number(bytes, ref at);
        var maximum = bits ? 1 : Number(bytes, ref at);
        if (maximum is < 1 or > 65535) throw new InvalidDataException("The maximum gray value must be 1 to 65535.");
        var pixels = new double[Size(bytes, width, height, kind)];
        if (kind is 4 or 5) at++;
        if (kind == 4) ReadBits(bytes, at, width, height, pixels);
        else if (kind == 5) ReadRaw(bytes, at, maximum, pixels);
        else ReadPlain(bytes, at, maximum, bits, pixels);
        return new GrayImage(width, height, pixels);
    }

    private static int Size(byte[] bytes, int width, int height, int kind)
    {
        var count = ImageReader.Pixels(width, height);
        // At least this many bytes must follow; a declared size beyond the file is not allocated.
        var least = kind switch { 4 => (width + 7) / 8 * (long)height, _ => count };
        return least <= bytes.Length ? count : throw new InvalidDataException("The file ends before its last pixel.");
    }

    private static void ReadPlain(byte[] bytes, int at, int maximum, bool bits, double[] pixels)
    {
        for (var i = 0; i < pixels.Length; i++)
        {
            var value = bits ? Bit(bytes, ref at) : Number(bytes, ref at);
            if (value > maximum) throw new InvalidDataException("A pixel is brighter than the maximum gray value.");
            pixels[i] = bits ? 1 - value : (double)value / maximum;
        }
    }

    private static void ReadRaw(byte[] bytes, int at, int maximum, double[] pixels)
    {
        var size = maximum > 255 ? 2 : 1;
        if (bytes.Length - at < (long)pixels.Length * size) throw new InvalidDataException("The file ends before its last pixel.");
        for (var i = 0; i < pixels.Length; i++)
        {
            var value = size == 1 ? bytes[at + i] : (bytes[at + 2 * i] << 8) | bytes[at + 2 * i + 1];
            pixels[i] = Math.Min(1, (double)value / maximum);
        }
    }

    private static void ReadBits(byte[] bytes, int at, int width, int height, double[] pixels)
    {
        var row = (width + 7) / 8;
        if (bytes.Length - at < (long)row * height) throw new InvalidDataException("The file ends before its last pixel.");
        for (var i = 0; i < pixels.Length; i++)
        {
            int x = i % width, y = i / width;
            pixels[i] = (bytes[at + y * row + x / 8] >> (7 - x % 8) & 1) == 0 ? 1 : 0;
        }
    }

    private static int Bit(byte[] bytes, ref int at)
    {
        Skip(bytes, ref at);
        if (at >= bytes.Length || bytes[at] is not ((byte)'0' or (byte)'1')) throw new InvalidDataException("A pixel of a bitmap must be 0 or 1.");
        return bytes[at++] - '0';
    }

    private static int Number(byte[] bytes, ref int at)
    {
        Skip(bytes, ref at);
        if (at >= bytes.Length || bytes[at] is < (byte)'0' or > (byte)'9') throw new InvalidDataException("A number is missing.");
        var number = 0;
        for (; at < bytes.Length && bytes[at] is >= (byte)'0' and <= (byte)'9'; at++)
        {
            number = number * 10 + bytes[at] - '0';
            if (number > 100_000_000) throw new InvalidDataException("A number is too large.");
        }
        return number;
    }

    private static void Skip(byte[] bytes, ref int at)
    {
        while (at < bytes.Length && (bytes[at] <= ' ' || bytes[at] == '#'))
        {
            if (bytes[at] == '#')
            {
                while (at < bytes.Length && bytes[at] != '\n') at++;
            }
            else
            {
                at++;
            }
        }
    }
}

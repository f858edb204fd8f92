using System.IO;

namespace Caterpillar.GCode;

/// <summary>The LZSS compression of heatshrink (Atomic Object): a bit 1 and a byte, or a bit 0, a distance and a length.</summary>
internal static class Heatshrink
{
    /// <summary>Unpacks <paramref name="plain"/> bytes.</summary>
    /// <param name="bytes">Packed.</param>
    /// <param name="plain">Length of the result.</param>
    /// <param name="window">Bits of a distance.</param>
    /// <param name="lookahead">Bits of a length.</param>
    /// <exception cref="InvalidDataException">There are fewer.</exception>
    public static byte[] Unpack(byte[] bytes, int plain, int window, int lookahead)
    {
        var data = new byte[plain];
        var count = 0;
        var at = 0;
        var held = 0;
        ulong bits = 0;
        var literalBits = 9;
        var repeatBits = 1 + window + lookahead;
        var windowMask = (1 << window) - 1;
        var lengthMask = (1 << lookahead) - 1;
        while (count < plain)
        {
            while (held <= 24 && at < bytes.Length)
            {
                bits = bits << 8 | bytes[at++];
                held += 8;
            }
            if (held > 0 && (bits >> held - 1 & 1) != 0)
            {
                if (held < literalBits) throw new InvalidDataException(BinaryBlock.CutOff);
                held -= literalBits;
                data[count++] = (byte)(bits >> held);
                continue;
            }
            if (held < repeatBits) throw new InvalidDataException(BinaryBlock.CutOff);
            held -= repeatBits;
            var back = ((int)(bits >> held + lookahead) & windowMask) + 1;
            var end = System.Math.Min(plain, count + ((int)(bits >> held) & lengthMask) + 1);
            // What lies before the beginning is zero.
            for (; count < end; count++) data[count] = back <= count ? data[count - back] : (byte)0;
        }
        return data;
    }
}

namespace Caterpillar.GCode;

/// <summary>The LZSS compression of heatshrink (Atomic Object): a bit 1 and a byte, or a bit 0, a distance and a length.</summary>
internal static class Heatshrink
{
    /// <summary>Unpacks <paramref name="plain"/> bytes.</summary>
    /// <param name="bytes">Packed bytes.</param>
    /// <param name="plain">Length of the result.</param>
    /// <param name="window">Bits of a distance.</param>
    /// <param name="lookahead">Bits of a length.</param>
    /// <exception cref="InvalidDataException">The data is too short.</exception>
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

    /// <summary>Packs bytes. Tries the nearest 32 earlier positions with the same three bytes.</summary>
    public static byte[] Pack(byte[] data, int window, int lookahead)
    {
        var bits = new BitBuffer(data.Length);
        foreach (var (at, length, back) in RepeatFinder.Pieces(data, 1 << window, 1 << lookahead, 32))
        {
            if (back == 0) bits.Add(0x100 | data[at], 9);
            else bits.Add((back - 1) << lookahead | (length - 1), 1 + window + lookahead);
        }
        return bits.ToArray();
    }

    private sealed class BitBuffer(int size)
    {
        private byte[] _bytes = new byte[size + 16];
        private int _count;
        private ulong _held;
        private int _heldBits;

        public void Add(int value, int count)
        {
            _held = _held << count | (uint)value;
            _heldBits += count;
            if (_count + 8 > _bytes.Length) System.Array.Resize(ref _bytes, _bytes.Length * 2);
            for (; _heldBits >= 8; _heldBits -= 8) _bytes[_count++] = (byte)(_held >> _heldBits - 8);
        }

        public byte[] ToArray()
        {
            if (_heldBits > 0) Add(0, 8 - _heldBits);
            System.Array.Resize(ref _bytes, _count);
            return _bytes;
        }
    }
}

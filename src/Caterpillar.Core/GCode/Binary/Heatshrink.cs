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
        const int Tries = 32, Shortest = 3;
        var longest = 1 << lookahead;
        var farthest = 1 << window;
        var head = new int[1 << 14];
        var before = new int[data.Length];
        var bits = new BitBuffer(data.Length);
        for (var i = 0; i < head.Length; i++) head[i] = -1;
        for (var at = 0; at < data.Length;)
        {
            int best = 0, back = 0;
            if (at + Shortest <= data.Length)
            {
                var most = System.Math.Min(longest, data.Length - at);
                var tries = Tries;
                for (var from = head[Hash(data, at)]; from >= 0 && at - from <= farthest && tries-- > 0 && best < most; from = before[from])
                {
                    var length = 0;
                    while (length < most && data[from + length] == data[at + length]) length++;
                    if (length <= best) continue;
                    best = length;
                    back = at - from;
                }
            }
            var step = 1;
            if (best < Shortest)
            {
                bits.Add(0x100 | data[at], 9);
            }
            else
            {
                bits.Add((back - 1) << lookahead | (best - 1), 1 + window + lookahead);
                step = best;
            }
            for (var end = at + step; at < end; at++)
            {
                if (at + Shortest > data.Length) continue;
                ref var slot = ref head[Hash(data, at)];
                before[at] = slot;
                slot = at;
            }
        }
        return bits.ToArray();
    }

    private static int Hash(byte[] data, int at) => (int)((uint)(data[at] | data[at + 1] << 8 | data[at + 2] << 16) * 2654435761u >> 18);

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

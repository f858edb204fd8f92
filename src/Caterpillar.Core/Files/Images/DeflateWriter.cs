namespace Caterpillar.Files;

/// <summary>
/// Compresses with deflate (RFC 1951) in one block with fixed Huffman codes. Unlike the deflate of the runtime, its bytes are the same everywhere.
/// </summary>
internal sealed class DeflateWriter
{
    private const int Window = 32768;
    private const int Shortest = 3;
    private const int Longest = 258;
    private const int MostTries = 64;
    private const int HashSize = 1 << 15;
    private const int EndOfBlock = 256;

    // The least length and distance of each code, and the bits that follow it: RFC 1951, 3.2.5.
    private static readonly int[] Lengths
        = [3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258];

    private static readonly int[] Distances = [1, 2, 3, 4, 5, 7, 9, 13, 17, 25, 33, 49, 65, 97, 129, 193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097,
        6145, 8193, 12289, 16385, 24577];

    private readonly MemoryStream _out = new();
    private uint _bits;
    private int _count;

    /// <summary>The compressed bytes.</summary>
    public static byte[] Pack(byte[] data) => new DeflateWriter().Run(data);

    private byte[] Run(byte[] data)
    {
        // The last place of each hash of three bytes, and the place before each place with the same hash.
        var last = Enumerable.Repeat(-1, HashSize).ToArray();
        var before = new int[data.Length];
        // The only block, with fixed codes.
        Bits(3, 3);
        for (var at = 0; at < data.Length;)
        {
            var (length, distance) = Match(data, at, last, before);
            if (length < Shortest) Symbol(data[at]);
            else Copy(length, distance);
            for (var end = at + Math.Max(length, 1); at < end; at++)
            {
                if (at + Shortest > data.Length) continue;
                var hash = Hash(data, at);
                before[at] = last[hash];
                last[hash] = at;
            }
        }
        Symbol(EndOfBlock);
        Bits(0, 7);
        return _out.ToArray();
    }

    private static (int Length, int Distance) Match(byte[] data, int at, int[] last, int[] before)
    {
        var best = (Length: 0, Distance: 0);
        if (at + Shortest > data.Length) return best;
        var limit = Math.Min(Longest, data.Length - at);
        var from = last[Hash(data, at)];
        for (var tries = 0; from >= 0 && at - from <= Window && tries < MostTries && best.Length < limit; tries++, from = before[from])
        {
            var length = 0;
            while (length < limit && data[from + length] == data[at + length]) length++;
            if (length > best.Length) best = (length, at - from);
        }
        return best;
    }

    private static int Hash(byte[] data, int at) => ((data[at] << 10) ^ (data[at + 1] << 5) ^ data[at + 2]) & (HashSize - 1);

    private void Copy(int length, int distance)
    {
        var code = CodeOf(Lengths, length);
        Symbol(257 + code);
        Bits((uint)(length - Lengths[code]), code is < 8 or 28 ? 0 : code / 4 - 1);
        code = CodeOf(Distances, distance);
        Code((uint)code, 5);
        Bits((uint)(distance - Distances[code]), code < 4 ? 0 : code / 2 - 1);
    }

    private static int CodeOf(int[] least, int value)
    {
        var found = Array.BinarySearch(least, value);
        return found < 0 ? ~found - 1 : found;
    }

    // The fixed codes: RFC 1951, 3.2.6.
    private void Symbol(int symbol)
    {
        if (symbol < 144) Code((uint)(0x30 + symbol), 8);
        else if (symbol < 256) Code((uint)(0x190 + symbol - 144), 9);
        else if (symbol < 280) Code((uint)(symbol - 256), 7);
        else Code((uint)(0xC0 + symbol - 280), 8);
    }

    // Codes begin with their highest bit, other numbers with their lowest.
    private void Code(uint code, int length)
    {
        for (var bit = length - 1; bit >= 0; bit--) Bits((code >> bit) & 1, 1);
    }

    private void Bits(uint value, int length)
    {
        _bits |= value << _count;
        _count += length;
        for (; _count >= 8; _count -= 8, _bits >>= 8) _out.WriteByte((byte)_bits);
    }
}

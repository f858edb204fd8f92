namespace Caterpillar.Files;

/// <summary>
/// Compresses with deflate (RFC 1951) in one block with fixed Huffman codes. Unlike the deflate of the runtime, its bytes are the same everywhere.
/// </summary>
internal sealed class DeflateWriter
{
    private const int EndOfBlock = 256;

    // The least length and distance of each code, and the bits that follow it: RFC 1951, 3.2.5.
    private static readonly int[] Lengths
        = [3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163, 195, 227, 258];

    private static readonly int[] Distances = [1, 2, 3, 4, 5, 7, 9, 13, 17, 25, 33, 49, 65, 97, 129, 193, 257, 385, 513, 769, 1025, 1537, 2049, 3073, 4097,
        6145, 8193, 12289, 16385, 24577];

    private readonly List<byte> _out = [];
    private uint _bits;
    private int _count;

    /// <summary>The compressed bytes.</summary>
    public static byte[] Pack(byte[] data) => new DeflateWriter().Run(data);

    private byte[] Run(byte[] data)
    {
        // The only block, with fixed codes.
        Bits(3, 3);
        foreach (var (at, length, back) in RepeatFinder.Pieces(data, 32768, 258, 64))
        {
            if (back == 0) Symbol(data[at]);
            else Copy(length, back);
        }
        Symbol(EndOfBlock);
        Bits(0, 7);
        return _out.ToArray();
    }

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
        for (; _count >= 8; _count -= 8, _bits >>= 8) _out.Add((byte)_bits);
    }
}

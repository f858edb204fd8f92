namespace Caterpillar.GCode;

internal enum BinaryBlockKind
{
    File,
    GCode,
    Slicer,
    Printer,
    Print,
    Thumbnail,
}

/// <summary>A block of binary G-code: its type, parameters (encoding, or format, width and height of a thumbnail) and unpacked data.</summary>
internal sealed class BinaryBlock
{
    public const string CutOff = "A block is cut off.";

    // Real blocks have 64 KB.
    private const int Largest = 1 << 30;

    public BinaryBlockKind Kind { get; private init; }

    /// <summary>Encoding, or format of a thumbnail.</summary>
    public int Encoding { get; private init; }

    public int Width { get; private init; }

    public int Height { get; private init; }

    public byte[] Data { get; private init; } = [];

    /// <summary>Bytes of the block in the file.</summary>
    public long Size { get; private init; }

    /// <summary>Reads the next block, or null at the end of the file.</summary>
    /// <param name="file">The file, at the beginning of the block.</param>
    /// <param name="summed">True if blocks end with a CRC-32.</param>
    /// <param name="limit">Maximum unpacked size for a packed size, bytes.</param>
    /// <exception cref="InvalidDataException">The block is broken or has an unknown type.</exception>
    public static BinaryBlock? Read(Stream file, bool summed, Func<long, long> limit)
    {
        var head = new byte[18];
        var have = ReadStream.Fill(file, head, 0, 8);
        if (have == 0) return null;
        if (have < 8) throw new InvalidDataException(CutOff);
        var type = UInt16(head, 0);
        var compression = UInt16(head, 2);
        if (type > (int)BinaryBlockKind.Thumbnail) throw new InvalidDataException("A block has an unknown type.");
        if (compression > 3) throw new InvalidDataException("A block has an unknown compression.");
        var parameters = type == (int)BinaryBlockKind.Thumbnail ? 6 : 2;
        var header = (compression == 0 ? 8 : 12) + parameters;
        if (ReadStream.Fill(file, head, have, header) < header) throw new InvalidDataException(CutOff);
        long plain = UInt32(head, 4);
        var size = compression == 0 ? plain : UInt32(head, 8);
        if (size > Largest || plain > Largest) throw new InvalidDataException("A block is too large.");
        var data = Take(file, (int)size);
        if (summed)
        {
            var sum = new byte[4];
            if (ReadStream.Fill(file, sum, 0, 4) < 4) throw new InvalidDataException(CutOff);
            if (Crc32.Of(data, 0, data.Length, Crc32.Of(head, 0, header)) != UInt32(sum, 0))
                throw new InvalidDataException("The checksum of a block is wrong.");
        }
        if (compression != 0 && plain > limit(size)) throw new InvalidDataException("A block states an unpacked size that it cannot have.");
        var at = header - parameters;
        return new BinaryBlock
        {
            Kind = (BinaryBlockKind)type,
            Encoding = UInt16(head, at),
            Width = parameters > 2 ? UInt16(head, at + 2) : 0,
            Height = parameters > 2 ? UInt16(head, at + 4) : 0,
            Data = compression switch
            {
                0 => data,
                1 => Inflate(data, (int)plain),
                2 => Shrunk(data, (int)plain, 11),
                _ => Shrunk(data, (int)plain, 12),
            },
            Size = header + size + (summed ? 4 : 0),
        };
    }

    public static int UInt16(byte[] bytes, int at) => bytes[at] | bytes[at + 1] << 8;

    public static uint UInt32(byte[] bytes, int at) => (uint)UInt16(bytes, at) | (uint)UInt16(bytes, at + 2) << 16;

    // Grows with what is there: a false size costs nothing.
    private static byte[] Take(Stream file, int size)
    {
        var data = new byte[Math.Min(size, 1 << 20)];
        for (var have = 0; ;)
        {
            have = ReadStream.Fill(file, data, have, data.Length);
            if (have < data.Length) throw new InvalidDataException(CutOff);
            if (have == size) return data;
            Array.Resize(ref data, (int)Math.Min(size, 2L * data.Length));
        }
    }

    // 17 bits give at most 16 bytes.
    private static byte[] Shrunk(byte[] data, int plain, int window)
        => plain <= 8L * data.Length ? Heatshrink.Unpack(data, plain, window, 4) : throw new InvalidDataException(CutOff);

    // zlib: two bytes of header, deflate, and a checksum (Adler-32).
    private static byte[] Inflate(byte[] packed, int plain)
    {
        // An empty block has no stream at all.
        if (packed.Length == 0 && plain == 0) return packed;
        if (packed.Length < 8 || (packed[0] & 15) != 8 || (packed[0] << 8 | packed[1]) % 31 != 0 || (packed[1] & 32) != 0)
            throw new InvalidDataException("The deflate data of a block is damaged.");
        // Deflate grows at most 1032 times.
        if (plain > 1040L * packed.Length) throw new InvalidDataException("A block states an unpacked size that it cannot have.");
        using var stream = new DeflateStream(new MemoryStream(packed, 2, packed.Length - 2, false), CompressionMode.Decompress);
        var data = new byte[plain];
        try
        {
            if (ReadStream.Fill(stream, data, 0, plain) < plain) throw new InvalidDataException(CutOff);
            if (stream.ReadByte() >= 0) throw new InvalidDataException("A block unpacks to more than its stated size.");
        }
        catch (IOException)
        {
            // Mono throws this for damaged data.
            throw new InvalidDataException("The deflate data of a block is damaged.");
        }
        var end = packed.Length - 4;
        if (Adler32.Of(data) != (uint)(packed[end] << 24 | packed[end + 1] << 16 | packed[end + 2] << 8 | packed[end + 3]))
            throw new InvalidDataException("The deflate data of a block is damaged or cut off.");
        return data;
    }
}

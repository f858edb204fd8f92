namespace Caterpillar.Files;

/// <summary>The checksum CRC-32 of gzip, PNG and binary G-code (polynomial EDB88320), eight bytes per step.</summary>
internal static class Crc32
{
    private static readonly uint[] Table = MakeTable();

    /// <summary>The checksum of bytes. <paramref name="before"/> is the checksum of the bytes before them.</summary>
    public static uint Of(byte[] bytes, int start, int count, uint before = 0)
    {
        var table = Table;
        var crc = ~before;
        var at = start;
        var end = start + count;
        for (; end - at >= 8; at += 8)
        {
            crc ^= (uint)(bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16 | bytes[at + 3] << 24);
            crc = table[0x700 | (crc & 0xFF)] ^ table[0x600 | (crc >> 8 & 0xFF)] ^ table[0x500 | (crc >> 16 & 0xFF)] ^ table[0x400 | crc >> 24]
                ^ table[0x300 | bytes[at + 4]] ^ table[0x200 | bytes[at + 5]] ^ table[0x100 | bytes[at + 6]] ^ table[bytes[at + 7]];
        }
        for (; at < end; at++) crc = table[(crc ^ bytes[at]) & 0xFF] ^ crc >> 8;
        return ~crc;
    }

    // Row k: a byte followed by k others.
    private static uint[] MakeTable()
    {
        var table = new uint[8 * 256];
        for (uint n = 0; n < 256; n++)
        {
            var value = n;
            for (var k = 0; k < 8; k++) value = (value & 1) != 0 ? 0xEDB88320u ^ value >> 1 : value >> 1;
            table[n] = value;
        }
        for (var n = 256; n < table.Length; n++) table[n] = table[n - 256] >> 8 ^ table[table[n - 256] & 0xFF];
        return table;
    }
}

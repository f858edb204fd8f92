using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Linq;
using System.Text;

namespace Caterpillar.Tests.GCode;

/// <summary>Packs binary G-code by hand after the specification, with nothing of the reader: the tests' own encoders, checksums bit by bit.</summary>
internal sealed class BinaryFile(bool checksums = true)
{
    public const int FileData = 0, GCode = 1, Slicer = 2, Printer = 3, Print = 4, Thumbnail = 5;

    private readonly List<byte> _bytes = [(byte)'G', (byte)'C', (byte)'D', (byte)'E', 1, 0, 0, 0, (byte)(checksums ? 1 : 0), 0];

    /// <summary>Where blocks begin, and the end.</summary>
    public List<int> Starts { get; } = [10];

    public byte[] ToArray() => _bytes.ToArray();

    public BinaryFile Table(int type, int compression, string text) => Block(type, compression, Encoding.UTF8.GetBytes(text), 0);

    public BinaryFile Code(int compression, int encoding, string text)
        => Block(GCode, compression, encoding == 0 ? Encoding.ASCII.GetBytes(text) : MeatPacked(text, encoding == 2), encoding);

    public BinaryFile ToolpathImage(int format, int width, int height, byte[] data) => Block(Thumbnail, 0, data, format, width, height);

    /// <summary>A block with its 16-bit parameters.</summary>
    public BinaryFile Block(int type, int compression, byte[] data, params int[] parameters)
    {
        var packed = compression switch { 0 => data, 1 => Zlib(data), 2 => Shrunk(data, 11), _ => Shrunk(data, 12) };
        return Raw(type, compression, data.Length, packed, parameters);
    }

    /// <summary>A block that says what it likes about its size.</summary>
    public BinaryFile Raw(int type, int compression, long plain, byte[] packed, params int[] parameters)
    {
        var block = new List<byte>();
        void Number(long value, int bytes)
        {
            for (var k = 0; k < bytes; k++) block.Add((byte)(value >> (8 * k)));
        }
        Number(type, 2);
        Number(compression, 2);
        Number(plain, 4);
        if (compression != 0) Number(packed.Length, 4);
        foreach (var parameter in parameters) Number(parameter, 2);
        block.AddRange(packed);
        if (checksums) Number(Crc(block), 4);
        _bytes.AddRange(block);
        Starts.Add(_bytes.Count);
        return this;
    }

    /// <summary>CRC-32, a bit at a time.</summary>
    public static uint Crc(IEnumerable<byte> bytes)
    {
        var crc = 0xFFFFFFFFu;
        foreach (var value in bytes)
        {
            crc ^= value;
            for (var k = 0; k < 8; k++) crc = (crc & 1) != 0 ? crc >> 1 ^ 0xEDB88320u : crc >> 1;
        }
        return ~crc;
    }

    /// <summary>zlib: header, deflate, Adler-32.</summary>
    public static byte[] Zlib(byte[] data)
    {
        using var memory = new MemoryStream();
        memory.WriteByte(0x78);
        memory.WriteByte(0x9C);
        using (var deflate = new DeflateStream(memory, CompressionMode.Compress, true)) deflate.Write(data, 0, data.Length);
        long a = 1, b = 0;
        foreach (var value in data)
        {
            a = (a + value) % 65521;
            b = (b + a) % 65521;
        }
        memory.Write([(byte)(b >> 8), (byte)b, (byte)(a >> 8), (byte)a], 0, 4);
        return memory.ToArray();
    }

    /// <summary>Heatshrink, greedy and as short as it can be.</summary>
    public static byte[] Shrunk(byte[] data, int window)
    {
        var bits = new StringBuilder();
        for (var i = 0; i < data.Length;)
        {
            int best = 0, distance = 0;
            for (var back = 1; back <= Math.Min(i, 1 << window); back++)
            {
                var length = 0;
                while (length < 16 && i + length < data.Length && data[i + length - back] == data[i + length]) length++;
                if (length <= best) continue;
                best = length;
                distance = back;
            }
            if (best < 3)
            {
                bits.Append('1').Append(Convert.ToString(data[i++], 2).PadLeft(8, '0'));
                continue;
            }
            bits.Append('0').Append(Convert.ToString(distance - 1, 2).PadLeft(window, '0')).Append(Convert.ToString(best - 1, 2).PadLeft(4, '0'));
            i += best;
        }
        return Bits(bits.ToString());
    }

    public static byte[] Bits(string bits)
    {
        var bytes = new byte[(bits.Length + 7) / 8];
        for (var i = 0; i < bits.Length; i++)
        {
            if (bits[i] == '1') bytes[i / 8] |= (byte)(128 >> (i % 8));
        }
        return bytes;
    }

    /// <summary>
    /// MeatPack as slicers use it: G lines lose their spaces; comments are dropped, or with <paramref name="comments"/> whole lines of them are kept unpacked.
    /// </summary>
    public static byte[] MeatPacked(string text, bool comments)
    {
        const string Known = "0123456789.E\nGX";
        var packed = new List<byte> { 0xFF, 0xFF, 0xFB, 0xFF, 0xFF, 0xF7 };
        var on = true;
        void Switch(bool to)
        {
            if (on != to) packed.AddRange([0xFF, 0xFF, (byte)(to ? 0xFB : 0xFA)]);
            on = to;
        }
        foreach (var line in text.TrimEnd('\n').Split('\n'))
        {
            if (line.StartsWith(";", StringComparison.Ordinal))
            {
                if (!comments) continue;
                Switch(false);
                packed.AddRange((line + "\n").Select(c => (byte)c));
                continue;
            }
            var code = line.Split(';')[0].Trim();
            if (code.Length == 0) continue;
            if (code[0] == 'G') code = code.Replace(" ", "");
            code += "\n";
            Switch(true);
            for (var i = 0; i < code.Length; i += 2)
            {
                var first = Known.IndexOf(code[i]);
                var second = i + 1 < code.Length ? Known.IndexOf(code[i + 1]) : 12;
                packed.Add((byte)((first < 0 ? 15 : first) | (second < 0 ? 15 : second) << 4));
                if (first < 0) packed.Add((byte)code[i]);
                if (second < 0) packed.Add((byte)code[i + 1]);
            }
        }
        if (!comments) packed.AddRange([0xFF, 0xFF, 0xF9]);
        return packed.ToArray();
    }
}

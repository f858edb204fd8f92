using System;
using System.Collections.Generic;
using System.IO;
using System.IO.Compression;
using System.Text;
using System.Threading;

namespace Caterpillar.GCode;

/// <summary>
/// Prusa's binary G-code (.bgcode, specification of libbgcode version 1): a header, then blocks with their own compression, encoding and checksum. It becomes the text that the slicer would have written:
/// the G-code, and the settings as comments. Pictures are left out.
/// </summary>
internal static class BinaryGCode
{
    private const int FileHeader = 10;
    private const int GCodeBlock = 1;
    private const int ThumbnailBlock = 5;
    private static readonly uint[] CrcTable = MakeCrcTable();

    public static bool IsBinary(byte[] bytes, int count) => count >= 4 && bytes[0] == 'G' && bytes[1] == 'C' && bytes[2] == 'D' && bytes[3] == 'E';

    /// <exception cref="InvalidDataException">The file is broken or of an unknown kind.</exception>
    public static byte[] Unpack(byte[] file, CancellationToken cancel = default)
    {
        if (file.Length < FileHeader) throw new InvalidDataException("The header is cut off.");
        var version = UInt32(file, 4);
        if (version != 1) throw new InvalidDataException("This version of binary G-code is not known.");
        var checksum = UInt16(file, 8);
        if (checksum > 1) throw new InvalidDataException("This kind of checksum is not known.");
        using var text = new MemoryStream();
        var settings = new StringBuilder();
        for (var at = FileHeader; at < file.Length;)
        {
            cancel.ThrowIfCancellationRequested();
            at = Block(file, at, checksum == 1, text, settings);
        }
        var tail = TextEncoding.Encode(settings.ToString());
        text.Write(tail, 0, tail.Length);
        return text.ToArray();
    }

    private static int Block(byte[] file, int at, bool checksum, MemoryStream text, StringBuilder settings)
    {
        Need(file, at, 8);
        var start = at;
        var type = UInt16(file, at);
        var compression = UInt16(file, at + 2);
        long plain = UInt32(file, at + 4);
        long size = plain;
        at += 8;
        if (compression != 0)
        {
            Need(file, at, 4);
            size = UInt32(file, at);
            at += 4;
        }
        var parameters = type == ThumbnailBlock ? 6 : 2;
        Need(file, at, parameters + size + (checksum ? 4 : 0));
        var encoding = UInt16(file, at);
        at += parameters;
        var end = at + (int)size;
        if (checksum && Crc(file, start, end) != UInt32(file, end)) throw new InvalidDataException("The checksum of a block is wrong.");
        if (type == GCodeBlock)
        {
            var data = Data(file, at, (int)size, plain, compression);
            var code = encoding switch
            {
                0 => data,
                1 or 2 => MeatPack.Unpack(data),
                _ => throw new InvalidDataException("This encoding of G-code is not known."),
            };
            text.Write(code, 0, code.Length);
        }
        else if (type < ThumbnailBlock)
        {
            Settings(Data(file, at, (int)size, plain, compression), settings);
        }
        return end + (checksum ? 4 : 0);
    }

    private static byte[] Data(byte[] file, int at, int size, long plain, int compression)
    {
        // No packed block grows more than this; larger claims are made up.
        if (plain > 1100L * size + 1024) throw new InvalidDataException("The size of a block is impossible.");
        switch (compression)
        {
            case 0:
                var copy = new byte[size];
                Buffer.BlockCopy(file, at, copy, 0, size);
                return copy;
            case 1:
                return Inflate(file, at, size, (int)plain);
            case 2:
                return Heatshrink.Unpack(file, at, at + size, (int)plain, 11, 4);
            case 3:
                return Heatshrink.Unpack(file, at, at + size, (int)plain, 12, 4);
            default:
                throw new InvalidDataException("This compression is not known.");
        }
    }

    // zlib: two bytes of header, then deflate.
    private static byte[] Inflate(byte[] file, int at, int size, int plain)
    {
        if (size < 2) throw new InvalidDataException("A block is cut off.");
        using var stream = new DeflateStream(new MemoryStream(file, at + 2, size - 2), CompressionMode.Decompress);
        var data = new byte[plain];
        var count = 0;
        try
        {
            for (int read; count < plain && (read = stream.Read(data, count, plain - count)) > 0;) count += read;
        }
        catch (IOException)
        {
            // Mono's word for it.
            throw new InvalidDataException("A block is damaged.");
        }
        return count == plain ? data : throw new InvalidDataException("A block is cut off.");
    }

    // Lines "key=value" become comments as in a text file.
    private static void Settings(byte[] data, StringBuilder settings)
    {
        foreach (var line in Encoding.UTF8.GetString(data).Split('\n'))
        {
            var equals = line.IndexOf("=", StringComparison.Ordinal);
            if (equals <= 0) continue;
            var key = line.Substring(0, equals).Trim();
            settings.Append("; ").Append(key == "Producer" ? "generated by" : key).Append(key == "Producer" ? " " : " = ").Append(line.Substring(equals + 1).Trim()).Append('\n');
        }
    }

    private static void Need(byte[] file, int at, long count)
    {
        if (count > file.Length - at) throw new InvalidDataException("A block is cut off.");
    }

    private static ushort UInt16(byte[] file, int at) => (ushort)(file[at] | file[at + 1] << 8);

    private static uint UInt32(byte[] file, int at) => (uint)UInt16(file, at) | (uint)UInt16(file, at + 2) << 16;

    internal static uint Crc(byte[] bytes, int start, int end)
    {
        var crc = 0xFFFFFFFFu;
        for (var i = start; i < end; i++) crc = CrcTable[(crc ^ bytes[i]) & 0xFF] ^ crc >> 8;
        return ~crc;
    }

    private static uint[] MakeCrcTable()
    {
        var table = new uint[256];
        for (uint n = 0; n < 256; n++)
        {
            var value = n;
            for (var k = 0; k < 8; k++) value = (value & 1) != 0 ? 0xEDB88320u ^ value >> 1 : value >> 1;
            table[n] = value;
        }
        return table;
    }
}

/// <summary>The LZSS compression of heatshrink: a bit 1 and a byte, or a bit 0, a distance and a length.</summary>
internal static class Heatshrink
{
    public static byte[] Unpack(byte[] bytes, int start, int end, int plain, int window, int lookahead)
    {
        var data = new byte[plain];
        var count = 0;
        var at = (long)start * 8;
        var stop = (long)end * 8;
        while (count < plain)
        {
            if (Bits(bytes, ref at, stop, 1) != 0)
            {
                data[count++] = (byte)Bits(bytes, ref at, stop, 8);
                continue;
            }
            var back = Bits(bytes, ref at, stop, window) + 1;
            var length = Bits(bytes, ref at, stop, lookahead) + 1;
            for (var k = 0; k < length && count < plain; k++, count++) data[count] = back <= count ? data[count - back] : (byte)0;
        }
        return data;
    }

    private static int Bits(byte[] bytes, ref long at, long stop, int count)
    {
        if (at + count > stop) throw new InvalidDataException("A block is cut off.");
        var value = 0;
        for (var k = 0; k < count; k++, at++) value = value << 1 | bytes[at >> 3] >> (int)(7 - (at & 7)) & 1;
        return value;
    }
}

/// <summary>MeatPack (Scott Mudge): the fifteen most frequent characters of G-code in four bits each.</summary>
internal static class MeatPack
{
    private const string Characters = "0123456789. \nGX";
    private const int Signal = 0xFF;

    public static byte[] Unpack(byte[] data)
    {
        var reader = new Reader(data.Length);
        foreach (var c in data) reader.Take(c);
        return reader.ToArray();
    }

    private sealed class Reader(int size)
    {
        private readonly List<byte> _out = new(size * 2);
        private bool _packed;
        private bool _noSpaces;
        private int _signals;
        private bool _command;
        private int _whole;
        private int _pending = -1;
        private bool _code;
        private bool _lineStart = true;

        public byte[] ToArray() => _out.ToArray();

        public void Take(byte c)
        {
            if (_command)
            {
                _command = false;
                Command(c);
            }
            else if (c == Signal && _signals > 0)
            {
                _signals = 0;
                _command = true;
            }
            else if (c == Signal)
            {
                _signals = 1;
            }
            else
            {
                if (_signals > 0)
                {
                    _signals = 0;
                    Data(Signal);
                }
                Data(c);
            }
        }

        private void Command(byte c)
        {
            switch (c)
            {
                case 251:
                    _packed = true;
                    break;
                case 250:
                    _packed = false;
                    break;
                case 249:
                    _packed = _noSpaces = false;
                    break;
                case 247:
                    _noSpaces = true;
                    break;
                case 246:
                    _noSpaces = false;
                    break;
            }
        }

        private void Data(int c)
        {
            if (!_packed)
            {
                Put((byte)c);
                return;
            }
            if (_whole > 0)
            {
                _whole--;
                Put((byte)c);
                if (_pending >= 0) Put((byte)_pending);
                _pending = -1;
                return;
            }
            int first = c & 15, second = c >> 4;
            if (first == 15)
            {
                _whole = second == 15 ? 2 : 1;
                if (second != 15) _pending = Character(second);
                return;
            }
            Put(Character(first));
            // Behind a line end the second half only fills the byte.
            if (Characters[first] == '\n') return;
            if (second == 15) _whole = 1;
            else Put(Character(second));
        }

        private byte Character(int code) => _noSpaces && code == 11 ? (byte)'E' : (byte)Characters[code];

        // Without blanks the words of a G line get theirs back.
        private void Put(byte c)
        {
            if (_lineStart) _code = c == 'G';
            else if (c == ';') _code = false;
            else if (_noSpaces && _code && c is >= (byte)'A' and <= (byte)'Z' && _out[_out.Count - 1] != ' ') _out.Add((byte)' ');
            _out.Add(c);
            _lineStart = c == '\n';
        }
    }
}

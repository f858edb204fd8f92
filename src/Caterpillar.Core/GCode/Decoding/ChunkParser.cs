using System;
using System.Runtime.CompilerServices;
using Caterpillar.Basics;

namespace Caterpillar.GCode;

/// <summary>
/// First half of decoding, without any state: cuts a chunk into lines and reads the words of motions in the usual notation (<c>G1 X1.5 Y2 E.03 F1800 ;
/// text</c>). Everything else is left to <see cref="ParsedLine"/>. Chunks can be parsed in parallel.
/// </summary>
/// <param name="extruder">The letter of E, or 0.</param>
/// <param name="places">True to find out where numbers are, for those who change them.</param>
internal sealed class ChunkParser(byte extruder, bool places = false)
{
    public const byte Comment = 2;
    public const byte Other = 3;
    public const byte HasX = 1;
    public const byte HasY = 2;
    public const byte HasZ = 4;
    public const byte HasE = 8;
    public const byte HasF = 16;

    private static readonly double[] PowersOfTen =
        [1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

    private const int NoWord = 255;
    private const int Unknown = 6;
    private readonly byte[] _slots = Slots(extruder);

    public LineRecord[] Records { get; private set; } = new LineRecord[64];

    /// <summary>Where the words of each record are; none where they are not asked for.</summary>
    public WordPlaces[] Places { get; private set; } = new WordPlaces[places ? 64 : 0];

    public int Count { get; private set; }

    /// <summary>Number of lines, of lines that end with CRLF, and of motions with a <c>;</c> comment.</summary>
    public int Lines { get; private set; }

    public int CrLf { get; private set; }

    public int Comments { get; private set; }

    public GCodeChunk? Chunk { get; private set; }

    // AggressiveOptimization (512): the loop runs a few times only, each for a whole chunk.
    [MethodImpl((MethodImplOptions)512)]
    public void Parse(GCodeChunk chunk, int start)
    {
        Chunk = chunk;
        var text = chunk.Text;
        var end = chunk.End;
        // Up to here every scan meets a LF before the text ends.
        var safe = end;
        while (safe > start && text[safe - 1] != '\n') safe--;
        var records = Records;
        var slots = _slots;
        var powers = PowersOfTen;
        var words = Places;
        var keeps = words.Length > 0;
        int count = 0, crlf = 0, comments = 0, at = start;
        while (at < safe)
        {
            if (count == records.Length)
            {
                Array.Resize(ref records, count * 2);
                Records = records;
                if (keeps) Array.Resize(ref words, count * 2);
                Places = words;
            }
            if (keeps) words[count] = default;
            ref var record = ref records[count];
            record.Start = at;
            record.Line = count;
            count++;
            var p = at;
            if (text[p] == 'G' && (text[p + 1] | 1) == '1' && text[p + 2] == ' ')
            {
                record.Op = (byte)(text[p + 1] - '0');
                record.Aux = -1;
                var mask = 0;
                var line = default(WordPlaces);
                p += 3;
                var fast = true;
                while (true)
                {
                    int c = text[p];
                    int slot = slots[c];
                    if (slot < 5)
                    {
                        // The number: at most 15 digits here, so that the quotient is correctly rounded.
                        c = text[++p];
                        var negative = c == '-';
                        if (negative) c = text[++p];
                        var digits = p;
                        long mantissa = 0;
                        var d = c - '0';
                        while ((uint)d <= 9)
                        {
                            mantissa = mantissa * 10 + d;
                            d = text[++p] - '0';
                        }
                        var scale = 0;
                        var length = p - digits;
                        if (d == '.' - '0')
                        {
                            var point = p;
                            d = text[++p] - '0';
                            while ((uint)d <= 9)
                            {
                                mantissa = mantissa * 10 + d;
                                d = text[++p] - '0';
                            }
                            scale = p - point - 1;
                            length += scale;
                        }
                        if ((uint)(length - 1) > 14)
                        {
                            fast = false;
                            break;
                        }
                        var value = mantissa / powers[scale];
                        if (negative) value = -value;
                        if (keeps)
                        {
                            if ((mask & (1 << slot)) != 0 || p - at > 255) line.Count = Unknown;
                            if (line.Count < Unknown) line.Add(slot, digits - at - (negative ? 1 : 0), p - at, scale);
                        }
                        mask |= 1 << slot;
                        switch (slot)
                        {
                            case 0: record.X = value; break;
                            case 1: record.Y = value; break;
                            case 2: record.Z = value; break;
                            case 3: record.E = value; break;
                            default: record.F = value; break;
                        }
                        c = text[p];
                        if (c == ' ')
                        {
                            p++;
                            continue;
                        }
                        if (c == '\n')
                        {
                            p++;
                            break;
                        }
                    }
                    c = text[p];
                    if (c == '\n')
                    {
                        p++;
                        break;
                    }
                    if (c == '\r' && text[p + 1] == '\n')
                    {
                        crlf++;
                        p += 2;
                        break;
                    }
                    if (c == ' ')
                    {
                        p++;
                        continue;
                    }
                    if (c == ';')
                    {
                        comments++;
                        record.Aux = p;
                        p = LineEnds.Find(text, p, end);
                        if (text[p] == '\r' && text[p + 1] == '\n') crlf++;
                        p = LineEnds.Skip(text, p, end);
                        break;
                    }
                    fast = false;
                    break;
                }
                if (fast)
                {
                    record.Mask = (byte)mask;
                    if (keeps && line.Count < Unknown) words[count - 1] = line;
                    at = p;
                    continue;
                }
                if (record.Aux >= 0) comments--;
                p = at;
            }
            record.Op = text[at] == ';' ? Comment : Other;
            p = LineEnds.Find(text, p, end);
            record.Aux = p;
            if (text[p] == '\r' && text[p + 1] == '\n') crlf++;
            at = LineEnds.Skip(text, p, end);
        }
        Count = count;
        CrLf = crlf;
        Comments = comments;
        Rest(text, at, end);
        Lines = Count;
    }

    // What follows the last LF: the last line of a file, or lines that end with CR.
    private void Rest(byte[] text, int at, int end)
    {
        while (at < end)
        {
            if (Count == Records.Length)
            {
                var records = Records;
                Array.Resize(ref records, Count * 2);
                Records = records;
                if (Places.Length > 0) Places = Longer(Places);
            }
            var stop = LineEnds.Find(text, at, end);
            if (Places.Length > 0) Places[Count] = default;
            Records[Count] = new LineRecord { Start = at, Aux = stop, Line = Count, Op = text[at] == ';' ? Comment : Other };
            Count++;
            at = LineEnds.Skip(text, stop, end);
        }
    }

    private static WordPlaces[] Longer(WordPlaces[] places)
    {
        Array.Resize(ref places, places.Length * 2);
        return places;
    }

    private static byte[] Slots(byte extruder)
    {
        var slots = new byte[256];
        for (var i = 0; i < slots.Length; i++) slots[i] = NoWord;
        slots['X'] = 0;
        slots['Y'] = 1;
        slots['Z'] = 2;
        if (extruder != 0) slots[extruder] = 3;
        slots['F'] = 4;
        return slots;
    }
}

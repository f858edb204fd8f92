using System.Runtime.CompilerServices;

namespace Caterpillar.GCode;

/// <summary>
/// Reads a straight move in the usual notation (<c>G1 X1.5 Y2 E.03 F1800 ; text</c>) with each word once, numbers of at most 15 digits, and single spaces.
/// Reused from line to line.
/// </summary>
internal sealed class PlainLine(byte extruder)
{
    public const int X = 0;
    public const int Y = 1;
    public const int Z = 2;
    public const int E = 3;
    public const int F = 4;
    public const int Slots = 5;

    private static readonly double[] PowersOfTen =
        [1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

    // By slot: the number, its decimals, and where it is in the text.
    public readonly double[] Values = new double[Slots];
    public readonly int[] Decimals = new int[Slots];
    public readonly int[] NumberAt = new int[Slots];
    public readonly int[] NumberEnd = new int[Slots];

    // The slots of the words in their order.
    public readonly int[] Order = new int[Slots];

    public int Count { get; private set; }

    /// <summary>The words that are there, one bit for each slot.</summary>
    public int Mask { get; private set; }

    /// <summary>0 or 1.</summary>
    public int Command { get; private set; }

    /// <summary>Where the next line begins.</summary>
    public int Next { get; private set; }

    public bool Has(int slot) => (Mask & (1 << slot)) != 0;

    /// <summary>Reads the line that begins here; false where it is no such move, or not ended by LF.</summary>
    [MethodImpl((MethodImplOptions)512)]
    public bool Read(byte[] text, int at, int end)
    {
        // Every scan stops at a LF: the last byte of what is read.
        if (end - at < 5 || text[end - 1] != '\n' || text[at] != 'G' || (text[at + 1] | 1) != '1' || text[at + 2] != ' ') return false;
        Command = text[at + 1] - '0';
        var mask = 0;
        var count = 0;
        var p = at + 3;
        while (true)
        {
            int c = text[p];
            int slot = c switch { 'X' => X, 'Y' => Y, 'Z' => Z, 'F' => F, _ => c == extruder ? E : -1 };
            if (slot < 0 || (mask & (1 << slot)) != 0) return false;
            mask |= 1 << slot;
            Order[count++] = slot;
            NumberAt[slot] = ++p;
            var negative = text[p] == '-';
            if (negative) p++;
            var first = p;
            long mantissa = 0;
            var d = text[p] - '0';
            while ((uint)d <= 9)
            {
                mantissa = mantissa * 10 + d;
                d = text[++p] - '0';
            }
            var length = p - first;
            var scale = 0;
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
            if ((uint)(length - 1) > 14) return false;
            var value = mantissa / PowersOfTen[scale];
            Values[slot] = negative ? -value : value;
            Decimals[slot] = scale;
            NumberEnd[slot] = p;
            c = text[p];
            if (c == '\n' || (c == '\r' && text[p + 1] == '\n')) break;
            if (c == ' ') c = text[++p];
            else if (c != ';') return false;
            if (c != ';') continue;
            p = LineEnds.Find(text, p, end);
            if (p == end || (text[p] == '\r' && text[p + 1] != '\n')) return false;
            break;
        }
        Count = count;
        Mask = mask;
        Next = text[p] == '\r' ? p + 2 : p + 1;
        return true;
    }
}

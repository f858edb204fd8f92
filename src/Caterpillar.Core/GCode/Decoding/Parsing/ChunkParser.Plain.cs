namespace Caterpillar.GCode;

/// <content>Motions in the usual notation, by far the most lines. Separate from all others, so that the loop stays in registers.</content>
internal sealed partial class ChunkParser
{
    private const int LongestNumber = 15;
    private const int LongestLine = 255;
    private const int Unknown = 6;

    private static readonly double[] PowersOfTen =
        [1, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15];

    // Reads lines until one is something else, or the records are full; returns where that is. Not inlined, as then others'
    // variables would take the registers.
    [MethodImpl(Compile.Optimized | MethodImplOptions.NoInlining)]
    private int Plain(byte[] text, int at, int safe, int end)
    {
        var (records, places) = (Records, Places);
        var powers = PowersOfTen;
        var letter = extruder == 0 ? -1 : extruder;
        var (count, crlf, comments) = (Count, CrLf, Comments);
        while (at < safe && count < records.Length && text[at] == 'G' && (text[at + 1] | 1) == '1' && text[at + 2] == ' ')
        {
            ref var record = ref records[count];
            var words = default(WordPlaces);
            var comment = -1;
            var mask = 0;
            var p = at + 3;
            int c = text[p];
            while (true)
            {
                var slot = c - 'X';
                if ((uint)slot > 2) slot = c == letter ? 3 : c == 'F' ? 4 : -1;
                if (slot < 0)
                {
                    if (c != ' ') break;
                    c = text[++p];
                    continue;
                }
                var digit = text[++p] - '0';
                var negative = digit == '-' - '0';
                if (negative) digit = text[++p] - '0';
                var begin = p;
                ulong units = 0;
                while ((uint)digit <= 9)
                {
                    units = units * 10 + (uint)digit;
                    digit = text[++p] - '0';
                }
                var length = p - begin;
                var decimals = 0;
                if (digit == '.' - '0')
                {
                    var point = p;
                    digit = text[++p] - '0';
                    while ((uint)digit <= 9)
                    {
                        units = units * 10 + (uint)digit;
                        digit = text[++p] - '0';
                    }
                    decimals = p - point - 1;
                    length += decimals;
                }
                // So that the quotient is correctly rounded.
                if ((uint)(length - 1) >= LongestNumber) break;
                var value = (long)units / powers[decimals];
                if (negative) value = -value;
                // Of repeated words, and in very long lines, places are unknown.
                if ((mask & (1 << slot)) != 0 || p - at > LongestLine) words.Count = Unknown;
                if (words.Count < Unknown) words.Add(slot, begin - at - (negative ? 1 : 0), p - at, decimals);
                mask |= 1 << slot;
                if (slot == 0) record.X = value;
                else if (slot == 1) record.Y = value;
                else if (slot == 3) record.E = value;
                else if (slot == 2) record.Z = value;
                else record.F = value;
                c = digit + '0';
                if (c != ' ') break;
                c = text[++p];
            }
            if (c == ';')
            {
                comment = p;
                p = LineEnds.Find(text, p, end);
                c = text[p];
            }
            if (c == '\n') p++;
            else if (c == '\r' && (comment >= 0 || text[p + 1] == '\n'))
            {
                if (text[p + 1] == '\n') crlf++;
                p = LineEnds.Skip(text, p, end);
            }
            else break;
            if (comment >= 0) comments++;
            places[count] = words.Count < Unknown ? words : default;
            record.Start = at;
            count++;
            record.Op = (byte)(text[at + 1] & 1);
            record.Aux = comment;
            record.Mask = (byte)mask;
            at = p;
        }
        (Count, CrLf, Comments) = (count, crlf, comments);
        return at;
    }
}

namespace Caterpillar.GCode;

/// <summary>The words of a file that extrude.</summary>
internal sealed class ExtrusionAxis
{
    public static readonly ExtrusionAxis E = new("E");
    public static readonly ExtrusionAxis A = new("A");
    public static readonly ExtrusionAxis B = new("B");
    public static readonly ExtrusionAxis Both = new("A+B");
    public static readonly ExtrusionAxis Switched = new("M101");
    public static readonly ExtrusionAxis None = new("none");

    private ExtrusionAxis(string name) => Name = name;

    /// <summary>Name in reports: E, A, B, A+B, M101 or none.</summary>
    public string Name { get; }

    /// <summary>The letter of the fast path, or 0.</summary>
    public byte Letter => Name.Length == 1 ? (byte)Name[0] : (byte)0;

    /// <summary>True if the file has E values.</summary>
    public bool HasAmounts => this != Switched && this != None;

    /// <summary>The letter of the E values (the first of two), or 0.</summary>
    public byte FirstLetter => this == Both ? (byte)'A' : Letter;

    /// <summary>The axis with this letter, or <see cref="None"/>.</summary>
    public static ExtrusionAxis Of(char letter) => letter switch { 'E' => E, 'A' => A, 'B' => B, _ => None };

    /// <summary>
    /// The axis in a flavor. If A and B are not extruders, they turn axes. Without E values, the switch of the extruder may be left, or nothing.
    /// </summary>
    public ExtrusionAxis In(FlavorRules rules)
        => HasAmounts && rules.ExtruderLetters.Length == 0 ? rules.SwitchedExtruder ? Switched : None
            : this == Switched && !rules.SwitchedExtruder
                ? rules.PrintsWithoutE || rules.ExtruderLetters.IndexOf("E", StringComparison.Ordinal) < 0 ? None : E
            : this == A && rules.ExtruderLetters.IndexOf("A", StringComparison.Ordinal) < 0 || this == B
                && rules.ExtruderLetters.IndexOf("B", StringComparison.Ordinal) < 0
            || this == Both && rules.ExtruderLetters.IndexOf("A", StringComparison.Ordinal) < 0 ? None : this;

    public bool Is(byte letter) => Letter == letter || (this == Both && (letter == 'A' || letter == 'B'));

    // A G0 to G3, or words without any G, which repeat the last one.
    private static bool Moves(ParsedLine line, ref double motion)
    {
        var other = false;
        for (var i = 0; i < line.Count; i++)
        {
            if (line.Letters[i] != 'G' || !line.HasValue[i]) continue;
            if (line.Values[i] is >= 0 and <= 3)
            {
                motion = line.Values[i];
                return true;
            }
            other = true;
        }
        return !other && motion >= 0;
    }

    /// <summary>
    /// E if a G0 to G3 with an X or Y word has an E word. Otherwise A, B or A+B by the same test, then the switch if the file has M101 or M103, then E if any
    /// G0 to G3 has an E word. Reads chunks until the first is found.
    /// </summary>
    public static ExtrusionAxis Detect(IEnumerable<GCodeChunk> chunks)
    {
        var parser = new ChunkParser((byte)'E');
        var line = new ParsedLine();
        bool a = false, b = false, e = false, switched = false;
        double motion = -1;
        var first = true;
        foreach (var chunk in chunks)
        {
            parser.Parse(chunk, chunk.Start + (first ? TextEncoding.MarkLength(chunk) : 0));
            first = false;
            for (var i = 0; i < parser.Count; i++)
            {
                ref var record = ref parser.Records[i];
                if (record.Op <= 1)
                {
                    motion = record.Op;
                    if ((record.Mask & ChunkParser.HasE) == 0) continue;
                    if ((record.Mask & (ChunkParser.HasX | ChunkParser.HasY)) != 0) return E;
                    e = true;
                    continue;
                }
                if (record.Op != ChunkParser.Other) continue;
                line.Scan(chunk.Text, record.Start, record.Aux);
                if (line.Shape != LineShape.Code) continue;
                if (line.Letters[0] == 'M')
                {
                    if (line.Values[0] is 101 or 103) switched = true;
                    continue;
                }
                if (!Moves(line, ref motion)) continue;
                e |= line.Find('E') >= 0;
                if (line.Find('X') < 0 && line.Find('Y') < 0) continue;
                if (line.Find('E') >= 0) return E;
                if (line.Find('A') >= 0) a = true;
                if (line.Find('B') >= 0) b = true;
            }
        }
        return a && b ? Both : a ? A : b ? B : switched ? Switched : e ? E : None;
    }
}

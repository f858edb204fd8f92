namespace Caterpillar.GCode;

internal enum CommentKind : byte
{
    None,

    /// <summary>A layer with its number (Cura, ideaMaker, Simplify3D).</summary>
    LayerNumber,

    /// <summary>A layer without number (PrusaSlicer and its relatives, KISSlicer).</summary>
    LayerChange,

    /// <summary>Top of the layer, and its thickness.</summary>
    Z,
    Height,
    Role,
    ObjectStart,
    ObjectEnd,

    /// <summary>The beginning of a thumbnail, with its size and format as text.</summary>
    Thumbnail,

    /// <summary>A line of a block of settings: <c>key = value</c>.</summary>
    Setting,
}

/// <summary>Meaning of a comment for the following moves.</summary>
internal struct CommentMeaning
{
    public CommentKind Kind;
    public int Number;
    public double Z;
    public double Height;
    public Role Role;
    public string Text;
    public string Value;
}

/// <summary>
/// Reads the comments that slicers write for viewers: Cura, PrusaSlicer, SuperSlicer, OrcaSlicer, BambuStudio, Slic3r, Simplify3D, ideaMaker, KISSlicer.
/// </summary>
internal static class CommentReader
{
    /// <summary>Reads the comment between <paramref name="start"/> (at the <c>;</c>) and <paramref name="end"/>.</summary>
    public static CommentMeaning Read(byte[] text, int start, int end)
    {
        var at = start + 1;
        while (at < end && text[at] is (byte)' ' or (byte)'\t') at++;
        while (end > at && text[end - 1] <= ' ') end--;
        if (at == end || Begins("WIDTH:") || Begins("WIPE_")) return default;
        if (Begins("TYPE:")) return RoleOf(text, at + 5, end);
        if (Begins("FEATURE:") || (Begins("feature ") && !HasEquals(text, at, end))) return RoleOf(text, at + 8, end);
        if (Begins("HEIGHT:")) return Number(text, at + 7, end, CommentKind.Height);
        if (Begins("LAYER_HEIGHT:")) return Number(text, at + 13, end, CommentKind.Height);
        if (Begins("Z:")) return Number(text, at + 2, end, CommentKind.Z);
        if (Begins("Z_HEIGHT:")) return Number(text, at + 9, end, CommentKind.Z);
        if (Begins("LAYER_CHANGE") || Begins("CHANGE_LAYER")) return new CommentMeaning { Kind = CommentKind.LayerChange };
        if (Begins("LAYER:") || Begins("LAYER ") || Begins("Layer ") || Begins("layer ")) return Layer(text, at + 6, end);
        if (Begins("BEGIN_LAYER_OBJECT")) return Kiss(text, at + 18, end);
        if (Begins("MESH:NONMESH") || Begins("stop printing object")) return new CommentMeaning { Kind = CommentKind.ObjectEnd };
        if (Begins("MESH:")) return Named(text, at + 5, end);
        if (Begins("printing object ")) return Named(text, at + 16, end);
        if (Begins("start printing object, ")) return Named(text, at + 23, end);
        if (Begins("thumbnail") && end - at < 80 && !HasEquals(text, at, end))
            return new CommentMeaning { Kind = CommentKind.Thumbnail, Text = TextEncoding.Decode(text, at, end) };
        return text[at] == '\'' ? Quoted(text, at + 1, end) : Setting(text, at, end);

        bool Begins(string word) => Is(text, at, end, word);
    }

    /// <summary>The role in a whole comment (Simplify3D, and Slic3r after its moves).</summary>
    public static Role? WholeRole(byte[] text, int start, int end)
    {
        var at = start + 1;
        if (end - at > 40) return null;
        return RoleNames.Find(TextEncoding.Decode(text, at, end));
    }

    /// <summary>The layer in Slic3r's <c>; move to next layer (3)</c>, or −1.</summary>
    public static int NextLayer(byte[] text, int start, int end)
    {
        const string Words = " move to next layer (";
        if (!Is(text, start + 1, end, Words)) return -1;
        var at = start + 1 + Words.Length;
        return NumberReader.Scan(text, at, end, false, out var number) > at && number is >= 0 and < 1e9 ? (int)number : -1;
    }

    private static bool Is(byte[] text, int at, int end, string word)
    {
        if (end - at < word.Length) return false;
        for (var i = 0; i < word.Length; i++)
        {
            if (text[at + i] != word[i]) return false;
        }
        return true;
    }

    private static CommentMeaning Number(byte[] text, int at, int end, CommentKind kind)
    {
        while (at < end && text[at] == ' ') at++;
        if (NumberReader.Scan(text, at, end, true, out var value) == at || !(value is > -1e9 and < 1e9)) return default;
        return new CommentMeaning { Kind = kind, Z = value, Height = value };
    }

    // "12", or "12, Z = 0.300"
    private static CommentMeaning Layer(byte[] text, int at, int end)
    {
        var next = NumberReader.Scan(text, at, end, false, out var number);
        if (next == at || !(number is > -1e9 and < 1e9)) return default;
        var meaning = new CommentMeaning { Kind = CommentKind.LayerNumber, Number = (int)number, Z = double.NaN };
        if (!Is(text, next, end, ", Z = ")) return meaning;
        if (NumberReader.Scan(text, next + 6, end, false, out var z) > next + 6 && z is > -1e9 and < 1e9) meaning.Z = z;
        return meaning;
    }

    // "z=0.30 z_thickness=0.30"
    private static CommentMeaning Kiss(byte[] text, int at, int end)
    {
        var meaning = new CommentMeaning { Kind = CommentKind.LayerChange, Number = 1, Z = double.NaN };
        for (; at < end; at++)
        {
            if (Is(text, at, end, " z=") && NumberReader.Scan(text, at + 3, end, false, out var z) > at + 3 && z is > -1e9 and < 1e9) meaning.Z = z;
            if (Is(text, at, end, "z_thickness=") && NumberReader.Scan(text, at + 12, end, false, out var h) > at + 12
                && h is > 0 and < 1e9)
            {
                meaning.Height = h;
            }
        }
        return meaning;
    }

    private static CommentMeaning RoleOf(byte[] text, int at, int end)
    {
        if (end - at > 60) return default;
        var role = RoleNames.Find(TextEncoding.Decode(text, at, end));
        return new CommentMeaning { Kind = CommentKind.Role, Role = role ?? Role.Unspecified };
    }

    private static CommentMeaning Quoted(byte[] text, int at, int end)
    {
        var close = at;
        while (close < end && text[close] != '\'') close++;
        return close < end && close - at < 60 && RoleNames.Find(TextEncoding.Decode(text, at, close)) is { } role
            ? new CommentMeaning { Kind = CommentKind.Role, Role = role }
            : default;
    }

    private static CommentMeaning Named(byte[] text, int at, int end)
        => new() { Kind = CommentKind.ObjectStart, Text = TextEncoding.Decode(text, at, System.Math.Min(end, at + 200)) };

    private static bool HasEquals(byte[] text, int at, int end) => FindEquals(text, at, end) > 0;

    private static int FindEquals(byte[] text, int at, int end)
    {
        var stop = System.Math.Min(end - 1, at + 80);
        for (var p = at + 1; p < stop; p++)
        {
            if (text[p] == '=' && text[p - 1] == ' ') return p;
        }
        return -1;
    }

    private static CommentMeaning Setting(byte[] text, int at, int end)
    {
        var equals = FindEquals(text, at, end);
        if (equals < 0) return default;
        return new CommentMeaning
        {
            Kind = CommentKind.Setting,
            Text = TextEncoding.Decode(text, at, equals - 1).Trim(),
            Value = TextEncoding.Decode(text, equals + 1, System.Math.Min(end, equals + 4096)).Trim(),
        };
    }
}

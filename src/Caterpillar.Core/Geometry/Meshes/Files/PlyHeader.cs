namespace Caterpillar.Geometry;

internal enum PlyFormat
{
    Ascii,
    LittleEndian,
    BigEndian,
}

/// <summary>A property of a PLY element; a list has the type of its length too.</summary>
internal sealed record PlyProperty(string Name, TypeCode Type, TypeCode? LengthType)
{
    /// <summary>Bytes of a value in a binary file; for a list of its length only.</summary>
    public int MinBytes => Size(LengthType ?? Type);

    public static int Size(TypeCode type) => type switch
    {
        TypeCode.SByte or TypeCode.Byte => 1,
        TypeCode.Int16 or TypeCode.UInt16 => 2,
        TypeCode.Double => 8,
        _ => 4,
    };
}

/// <summary>An element of a PLY file: how many rows and what each holds.</summary>
internal sealed record PlyElement(string Name, long Count, int Line)
{
    public List<PlyProperty> Properties { get; } = [];

    public int Find(string name) => Properties.FindIndex(p => p.Name == name);
}

/// <summary>The header of a PLY file.</summary>
internal sealed class PlyHeader
{
    public PlyFormat Format { get; private set; }

    public List<PlyElement> Elements { get; } = [];

    /// <summary>Start of the data.</summary>
    public int DataAt { get; private set; }

    /// <summary>Reads the header. Null with an error if it is unreadable.</summary>
    public static PlyHeader? Read(MeshSource source)
    {
        var header = new PlyHeader();
        var cursor = new TextCursor(source.Bytes, 0, source.Length);
        var format = false;
        for (var line = 1; !cursor.AtEnd; line++)
        {
            var at = cursor.At;
            var text = Line(cursor);
            var words = text.Split([' ', '\t'], System.StringSplitOptions.RemoveEmptyEntries);
            if (words.Length == 0) continue;
            switch (words[0])
            {
                case "ply" or "comment" or "obj_info":
                    break;
                case "format":
                    if (words.Length < 2 || !header.SetFormat(words[1]))
                        return Wrong(source, at, "Unknown PLY format. Use ascii, binary_little_endian or binary_big_endian.");
                    format = true;
                    break;
                case "element":
                    if (words.Length != 3 || !long.TryParse(words[2], NumberStyles.None, CultureInfo.InvariantCulture, out var count))
                        return Wrong(source, at, "An element needs a name and a count.");
                    header.Elements.Add(new PlyElement(words[1], count, line));
                    break;
                case "property":
                    if (!header.AddProperty(words)) return Wrong(source, at, "A property is invalid.");
                    break;
                case "end_header":
                    if (!format) return Wrong(source, at, "The PLY header has no format.");
                    header.DataAt = cursor.At;
                    return header;
                default:
                    return Wrong(source, at, "The PLY header has an unknown line.");
            }
        }
        source.ErrorInText("mesh.truncated", "The file ends inside the PLY header.", source.Length);
        return null;
    }

    // Lines end with LF, CR LF, or in old files CR alone.
    private static string Line(TextCursor cursor)
    {
        var start = cursor.At;
        var p = start;
        while (p < cursor.End && cursor.Bytes[p] != '\n' && cursor.Bytes[p] != '\r') p++;
        var text = Encoding.ASCII.GetString(cursor.Bytes, start, System.Math.Min(p - start, 1000));
        if (p < cursor.End && cursor.Bytes[p] == '\r' && p + 1 < cursor.End && cursor.Bytes[p + 1] == '\n') p++;
        cursor.At = System.Math.Min(p + 1, cursor.End);
        return text;
    }

    private bool SetFormat(string word)
    {
        Format = word switch { "binary_little_endian" => PlyFormat.LittleEndian, "binary_big_endian" => PlyFormat.BigEndian, _ => PlyFormat.Ascii };
        return Format != PlyFormat.Ascii || word == "ascii";
    }

    private bool AddProperty(string[] words)
    {
        if (Elements.Count == 0) return false;
        var list = words.Length > 1 && words[1] == "list";
        if (words.Length != (list ? 5 : 3)) return false;
        if (TypeOf(words[list ? 3 : 1]) is not { } type) return false;
        var length = list ? TypeOf(words[2]) : null;
        if (list && length is null) return false;
        Elements[Elements.Count - 1].Properties.Add(new PlyProperty(words[words.Length - 1], type, length));
        return true;
    }

    private static TypeCode? TypeOf(string word) => word switch
    {
        "char" or "int8" => TypeCode.SByte,
        "uchar" or "uint8" => TypeCode.Byte,
        "short" or "int16" => TypeCode.Int16,
        "ushort" or "uint16" => TypeCode.UInt16,
        "int" or "int32" => TypeCode.Int32,
        "uint" or "uint32" => TypeCode.UInt32,
        "float" or "float32" => TypeCode.Single,
        "double" or "float64" => TypeCode.Double,
        _ => null,
    };

    private static PlyHeader? Wrong(MeshSource source, int at, string message)
    {
        source.ErrorInText("mesh.syntax", message, at);
        return null;
    }
}

namespace Caterpillar.Geometry;

/// <summary>Reads the values of a PLY file one after the other, whatever its format.</summary>
internal sealed class PlyData(MeshSource source, PlyFormat format, int at)
{
    private readonly byte[] _bytes = source.Bytes;
    private readonly byte[] _turned = new byte[8];
    private readonly TextCursor _cursor = new(source.Bytes, at, source.Length);

    private bool IsText => format == PlyFormat.Ascii;

    /// <summary>Offset of the next value.</summary>
    public int At => _cursor.At;

    /// <summary>True if this many rows of these properties fit into the rest of the file.</summary>
    public bool Fits(PlyElement element)
    {
        long row = 0;
        foreach (var property in element.Properties) row += IsText ? 2 : property.MinBytes;
        // The last value of a text file may have no space after it.
        return element.Count * row <= source.Length - At + (IsText ? 1L : 0);
    }

    /// <summary>True if this many values of a list fit into the rest of the file.</summary>
    public bool Fits(double values, TypeCode type) => values * (IsText ? 2 : PlyProperty.Size(type)) <= source.Length - At + (IsText ? 1L : 0);

    /// <summary>The next value; a float is widened exactly. False at the end of the file, or at a word that is not a number.</summary>
    public bool Read(TypeCode type, out double value)
    {
        if (IsText)
        {
            value = 0;
            return _cursor.SkipSpace() && _cursor.ReadNumber(out value);
        }
        var size = PlyProperty.Size(type);
        var at = _cursor.At;
        value = 0;
        if (size > source.Length - at) return false;
        _cursor.At = at + size;
        var bytes = _bytes;
        if (format == PlyFormat.BigEndian && size > 1)
        {
            for (var i = 0; i < size; i++) _turned[size - 1 - i] = bytes[at + i];
            (bytes, at) = (_turned, 0);
        }
        value = type switch
        {
            TypeCode.SByte => (sbyte)bytes[at],
            TypeCode.Byte => bytes[at],
            TypeCode.Int16 => BitConverter.ToInt16(bytes, at),
            TypeCode.UInt16 => BitConverter.ToUInt16(bytes, at),
            TypeCode.Int32 => BitConverter.ToInt32(bytes, at),
            TypeCode.UInt32 => BitConverter.ToUInt32(bytes, at),
            TypeCode.Single => BitConverter.ToSingle(bytes, at),
            _ => BitConverter.ToDouble(bytes, at),
        };
        return true;
    }

    /// <summary>Skips values; in a binary file at once. False if the file ends before.</summary>
    public bool Skip(TypeCode type, long values)
    {
        if (!IsText)
        {
            var bytes = values * PlyProperty.Size(type);
            if (bytes > source.Length - At) return false;
            _cursor.At += (int)bytes;
            return true;
        }
        for (long i = 0; i < values; i++)
        {
            if (!_cursor.SkipSpace()) return false;
            _cursor.SkipWord();
        }
        return true;
    }

    /// <summary>Reports that there is no number at the cursor.</summary>
    public bool Wrong(string what)
    {
        var message = $"The file ends inside {what}.";
        if (!IsText) return source.ErrorInBinary("mesh.truncated", message, At);
        return At < source.Length ? source.ErrorInText("mesh.syntax", $"A value in {what} is not a number.", At)
            : source.ErrorInText("mesh.truncated", message, source.Length);
    }

    /// <summary>Reports an impossible value.</summary>
    public bool Error(string code, string message) => IsText ? source.ErrorInText(code, message, At) : source.ErrorInBinary(code, message, At);
}

namespace Caterpillar.GCode;

/// <summary>Bytes of G-code are Latin-1, one character per byte. A UTF-8 byte order mark is skipped.</summary>
internal static class TextEncoding
{
    private static readonly Encoding Latin1 = Encoding.GetEncoding(28591);
    private static readonly Encoding Utf8 = new UTF8Encoding(false);

    /// <summary>3 if the chunk begins with a byte order mark, otherwise 0.</summary>
    public static int MarkLength(GCodeChunk first) => ByteOrderMark.LengthAt(first.Text, first.Start, first.Start + first.Length);

    public static byte[] Encode(string text)
    {
        foreach (var c in text)
        {
            if (c > 255) return Utf8.GetBytes(text);
        }
        return Latin1.GetBytes(text);
    }

    public static string Decode(byte[] text, int start, int end) => end > start ? Latin1.GetString(text, start, end - start) : "";

    /// <summary>A copy of some bytes.</summary>
    public static byte[] Copy(byte[] text, int start, int end)
    {
        var copy = new byte[end - start];
        Buffer.BlockCopy(text, start, copy, 0, copy.Length);
        return copy;
    }
}

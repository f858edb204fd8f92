namespace Caterpillar.Files;

/// <summary>The mark EF BB BF that some editors write before UTF-8 text.</summary>
internal static class ByteOrderMark
{
    /// <summary>3 if the bytes from <paramref name="start"/> to <paramref name="end"/> begin with the mark, otherwise 0.</summary>
    public static int LengthAt(byte[] bytes, int start, int end)
        => end - start >= 3 && bytes[start] == 0xEF && bytes[start + 1] == 0xBB && bytes[start + 2] == 0xBF ? 3 : 0;

    /// <summary>3 if a file begins with the mark, otherwise 0.</summary>
    public static int Length(byte[] file) => LengthAt(file, 0, file.Length);
}

namespace Caterpillar.GCode;

/// <summary>A line of the file.</summary>
/// <param name="Text">Bytes that contain the line, shared and never changed.</param>
/// <param name="Start">Index of its first byte.</param>
/// <param name="End">Index of its line end.</param>
/// <param name="Next">Index of the next line.</param>
internal readonly record struct FileLine(byte[] Text, int Start, int End, int Next)
{
    /// <summary>Other bytes with the same line end.</summary>
    public FileLine WithText(byte[] bytes)
    {
        var all = new byte[bytes.Length + Next - End];
        Buffer.BlockCopy(bytes, 0, all, 0, bytes.Length);
        Buffer.BlockCopy(Text, End, all, bytes.Length, Next - End);
        return new FileLine(all, 0, bytes.Length, all.Length);
    }
}

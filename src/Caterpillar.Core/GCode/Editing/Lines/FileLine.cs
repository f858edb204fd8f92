namespace Caterpillar.GCode;

/// <summary>A line of the file.</summary>
/// <param name="Text">Bytes of which it is a part; shared and never changed.</param>
/// <param name="Start">Where it begins.</param>
/// <param name="End">Where its line end begins.</param>
/// <param name="Next">Where the next line begins.</param>
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

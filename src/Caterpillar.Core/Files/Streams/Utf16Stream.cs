namespace Caterpillar.Files;

/// <summary>UTF-16 with a byte order mark as one byte per character. Characters beyond Latin-1 become question marks.</summary>
internal sealed class Utf16Stream(Stream wide) : ReadStream
{
    private readonly StreamReader _reader = new(wide, Encoding.Unicode, true, 1 << 16, true);
    private readonly char[] _characters = new char[1 << 16];

    /// <summary>True for the mark of either byte order followed by a character other than NUL.</summary>
    public static bool IsWide(byte[] head, int count)
        => count >= 4 && ((head[0] == 0xFF && head[1] == 0xFE && (head[2] | head[3]) != 0) || (head[0] == 0xFE && head[1] == 0xFF && (head[2] | head[3]) != 0));

    public override int Read(byte[] buffer, int offset, int count)
    {
        var read = _reader.Read(_characters, 0, System.Math.Min(count, _characters.Length));
        for (var i = 0; i < read; i++) buffer[offset + i] = _characters[i] < 256 ? (byte)_characters[i] : (byte)'?';
        return read;
    }

    protected override void Dispose(bool disposing)
    {
        if (disposing) wide.Dispose();
        base.Dispose(disposing);
    }
}

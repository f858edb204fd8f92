namespace Caterpillar.GCode;

/// <summary>Lines of G-code as bytes, in a buffer that grows.</summary>
internal sealed class LineBuffer
{
    private const int LongestWord = 40;
    private static readonly char[] LineFeed = ['\n'];
    private byte[] _bytes = new byte[64 * 1024];
    private int _count;

    public int Count => _count;

    public long Lines { get; private set; }

    public void FlushTo(Stream stream)
    {
        stream.Write(_bytes, 0, _count);
        _count = 0;
    }

    /// <summary>Begins a command: its letter and number.</summary>
    public void Command(byte letter, int number)
    {
        EnsureSpace();
        _bytes[_count++] = letter;
        _count = NumberFormatter.WriteUnits(_bytes, _count, number, 0);
    }

    /// <summary>Adds a word to the command: <paramref name="units"/> of the last decimal.</summary>
    public void Word(byte letter, long units, int decimals)
    {
        EnsureSpace();
        _bytes[_count++] = (byte)' ';
        _bytes[_count++] = letter;
        _count = NumberFormatter.WriteUnits(_bytes, _count, units, decimals);
    }

    public void EndLine()
    {
        EnsureSpace();
        _bytes[_count++] = (byte)'\n';
        Lines++;
    }

    /// <summary>Writes a line unchanged. Line ends in it begin new lines.</summary>
    public void Line(string text)
    {
        // CRLF is one line end, and so is CR alone.
        var lines = text.IndexOfAny(LineFeed) >= 0 ? string.Concat(text.Split('\r')) : text.Replace('\r', '\n');
        foreach (var line in lines.Split('\n'))
        {
            var bytes = TextEncoding.Encode(line);
            EnsureSpace(bytes.Length + LongestWord);
            Buffer.BlockCopy(bytes, 0, _bytes, _count, bytes.Length);
            _count += bytes.Length;
            EndLine();
        }
    }

    /// <summary>Writes a comment. Line ends in it become spaces.</summary>
    public void Comment(string text) => Line(";" + text.Replace('\r', ' ').Replace('\n', ' '));

    private void EnsureSpace(int bytes = LongestWord)
    {
        if (_count + bytes + LongestWord > _bytes.Length) Array.Resize(ref _bytes, Math.Max(_bytes.Length * 2, _count + bytes + LongestWord));
    }
}

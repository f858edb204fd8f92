namespace Caterpillar.GCode;

/// <summary>
/// Packs lines with MeatPack (Scott Mudge) without the spaces of G lines, so that every reader returns the same line. Other lines are not packed.
/// </summary>
internal sealed class MeatPackWriter
{
    private static readonly byte[] Codes = MakeCodes();
    private byte[] _out = new byte[80 * 1024];
    private int _count;
    private int _grown;
    private bool _packed;

    public MeatPackWriter() => Begin();

    /// <summary>Returns the packed lines and begins a new block.</summary>
    public byte[] Take()
    {
        // Prusa's own reader loses a character where a block grows to more than twice its size; commands that change nothing keep it below.
        while (2 * _count <= _grown + 64)
        {
            EnsureSpace(0);
            Command(251);
        }
        var bytes = TextEncoding.Copy(_out, 0, _count);
        Begin();
        return bytes;
    }

    /// <summary>Adds a line, without its end.</summary>
    public void Line(byte[] text, int start, int end)
    {
        EnsureSpace(end - start);
        var plain = end > start && text[start] == 'G';
        var good = end > start && text[start] != ';' && (!plain || Comes(text, start, end));
        if (good != _packed) Switch(good);
        // They also separate the words of a G line that is not packed.
        _grown += (plain && !good ? 2 : 1) * (end - start + 1);
        if (!good)
        {
            Buffer.BlockCopy(text, start, _out, _count, end - start);
            _count += end - start;
            _out[_count++] = (byte)'\n';
            return;
        }
        var first = -1;
        for (var at = start; at <= end; at++)
        {
            var c = at < end ? text[at] : (byte)'\n';
            if (plain && c == ' ') continue;
            if (first < 0)
            {
                first = c;
                continue;
            }
            Pair((byte)first, c);
            first = -1;
        }
        if (first >= 0) Pair((byte)first, (byte)'\n');
    }

    // A G line whose words are separated by single spaces, which readers put back.
    private static bool Comes(byte[] text, int start, int end)
    {
        for (var at = start + 1; at < end; at++)
        {
            var c = text[at];
            var letter = c is >= (byte)'A' and <= (byte)'Z';
            if (c == ' ' ? at + 1 == end || !IsWord(text[at + 1]) : letter ? text[at - 1] != ' '
                : c is not (>= (byte)'0' and <= (byte)'9' or (byte)'.' or (byte)'-'))
            {
                return false;
            }
        }
        return true;
    }

    // Letters before which readers put the spaces of G lines back.
    private static bool IsWord(byte c)
        => c is (byte)'A' or (byte)'C' or >= (byte)'E' and <= (byte)'J' or (byte)'P' or (byte)'R' or (byte)'S' or >= (byte)'W' and <= (byte)'Z';

    private void Pair(byte first, byte second)
    {
        var a = Codes[first];
        var b = Codes[second];
        _out[_count++] = (byte)(a | b << 4);
        if (a == 15) _out[_count++] = first;
        if (b == 15) _out[_count++] = second;
    }

    private void EnsureSpace(int bytes)
    {
        if (_count + 3 * bytes + 16 > _out.Length) Array.Resize(ref _out, Math.Max(_out.Length * 2, _count + 3 * bytes + 16));
    }

    private void Begin()
    {
        _count = _grown = 0;
        Switch(true);
        Command(247);
    }

    private void Switch(bool packed)
    {
        Command((byte)(packed ? 251 : 250));
        _packed = packed;
    }

    private void Command(byte command)
    {
        _out[_count++] = 0xFF;
        _out[_count++] = 0xFF;
        _out[_count++] = command;
    }

    private static byte[] MakeCodes()
    {
        const string Characters = "0123456789.E\nGX";
        var codes = new byte[256];
        for (var c = 0; c < 256; c++) codes[c] = 15;
        for (var code = 0; code < Characters.Length; code++) codes[Characters[code]] = (byte)code;
        return codes;
    }
}

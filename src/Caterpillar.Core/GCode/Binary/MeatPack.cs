namespace Caterpillar.GCode;

/// <summary>MeatPack (Scott Mudge): the fifteen most frequent characters of G-code in four bits each.</summary>
internal sealed class MeatPack
{
    private const string Characters = "0123456789. \nGX";
    private const int Signal = 0xFF;
    private byte[] _out;
    private int _count;
    private bool _packed;
    private bool _noSpaces;
    private int _whole;
    private int _pending = -1;
    private bool _code;
    private bool _lineStart = true;

    private MeatPack(int size) => _out = new byte[size];

    public static byte[] Unpack(byte[] data)
    {
        var reader = new MeatPack(data.Length * 2 + 16);
        var signals = 0;
        foreach (var c in data)
        {
            if (signals == 2)
            {
                signals = 0;
                reader.Command(c);
            }
            else if (c == Signal)
            {
                signals++;
            }
            else
            {
                // A single one is not a signal.
                if (signals == 1) reader.Data(Signal);
                signals = 0;
                reader.Data(c);
            }
        }
        Array.Resize(ref reader._out, reader._count);
        return reader._out;
    }

    private void Command(byte c) => (_packed, _noSpaces) = c switch
    {
        251 => (true, _noSpaces),
        250 => (false, _noSpaces),
        249 => (false, false),
        247 => (_packed, true),
        246 => (_packed, false),
        _ => (_packed, _noSpaces),
    };

    private void Data(int c)
    {
        if (!_packed)
        {
            Put((byte)c);
            return;
        }
        if (_whole > 0)
        {
            _whole--;
            Put((byte)c);
            if (_pending >= 0) Put((byte)_pending);
            _pending = -1;
            return;
        }
        int first = c & 15, second = c >> 4;
        if (first == 15)
        {
            _whole = second == 15 ? 2 : 1;
            if (second != 15) _pending = Character(second);
            return;
        }
        Put(Character(first));
        // After a line end the second half only fills the byte.
        if (first == 12) return;
        if (second == 15) _whole = 1;
        else Put(Character(second));
    }

    private byte Character(int code) => _noSpaces && code == 11 ? (byte)'E' : (byte)Characters[code];

    // The words of a packed G line without spaces get theirs back.
    private void Put(byte c)
    {
        if (_count + 2 > _out.Length) Array.Resize(ref _out, _out.Length * 2);
        if (_lineStart) _code = c == 'G';
        else if (c == ';') _code = false;
        else if (_packed && _noSpaces && _code && c is >= (byte)'A' and <= (byte)'Z' && _out[_count - 1] != ' ') _out[_count++] = (byte)' ';
        _out[_count++] = c;
        _lineStart = c == '\n';
    }
}

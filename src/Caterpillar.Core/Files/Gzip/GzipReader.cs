namespace Caterpillar.Files;

/// <summary>
/// Decompresses gzip (RFC 1952) while reading. The checksum and the length of every member are verified, so that a damaged or cut file is always detected.
/// Zeros after the last member are padding. Other bytes after it are ignored, as gzip does. The output is limited to 250 times the input, or 64 MB. Every
/// problem is an <see cref="InvalidDataException"/>, on .NET and on Mono.
/// </summary>
/// <param name="packed">A stream at the beginning of the first member.</param>
/// <param name="leaveOpen">True to leave it open when this stream is closed.</param>
internal sealed class GzipReader(Stream packed, bool leaveOpen = false) : ReadStream
{
    /// <summary>Maximum growth of compressed data. Meshes and G-code grow 3 to 20 times.</summary>
    private const long MaxFactor = 250;

    /// <summary>Output that is always allowed, bytes.</summary>
    private const long MinLimit = 64L << 20;

    internal const string CutOff = "It is cut off.";
    internal const string TooLarge = "It decompresses to more than 250 times its size.";
    private readonly GzipInput _input = new GzipInput(packed ?? throw new ArgumentNullException(nameof(packed)));
    private DeflateStream? _member;
    private uint _sum;
    private uint _length;
    private long _total;
    private bool _ended;
    private bool _any;

    /// <summary>True at the end if unread bytes follow the last member that are neither zeros nor another member.</summary>
    public bool HasTrailingBytes { get; private set; }

    /// <summary>Maximum decompressed size for this length, bytes.</summary>
    public static long Limit(long packed) => Math.Max(MinLimit, MaxFactor * packed);

    /// <summary>True for the first bytes of a gzip file.</summary>
    public static bool IsPacked(byte[] head, int count) => count >= 2 && head[0] == 0x1F && head[1] == 0x8B;

    /// <summary>The name of a file without <c>.gz</c>.</summary>
    public static string PlainName(string name) => name.EndsWith(".gz", StringComparison.OrdinalIgnoreCase) ? name.Substring(0, name.Length - 3) : name;

    /// <summary>The stream itself, or its decompressed content if it begins like gzip.</summary>
    /// <exception cref="IOException">The stream cannot be read.</exception>
    public static Stream Open(Stream stream, bool leaveOpen = false)
    {
        var head = new byte[2];
        var whole = PeekedStream.Peek(stream ?? throw new ArgumentNullException(nameof(stream)), head, out var count);
        return IsPacked(head, count) ? new GzipReader(whole, leaveOpen) : whole;
    }

    /// <summary>The warning about bytes after the last member.</summary>
    public static Diagnostic TrailingBytes(string code, string name)
        => new(Severity.Warning, code, "The gzip data is followed by other bytes, which were not read.", name.Length > 0
            ? new SourceLocation(name) : null);

    /// <exception cref="InvalidDataException">The data is cut off, damaged, or grows beyond the limit.</exception>
    public override int Read(byte[] buffer, int offset, int count)
    {
        if (count == 0) return 0;
        while (!_ended)
        {
            if (_member is null && !NextMember()) break;
            var read = Inflate(buffer, offset, count);
            if (read > 0)
            {
                _sum = Crc32.Of(buffer, offset, read, _sum);
                _length += (uint)read;
                _total += read;
                if (_total > Limit(_input.Taken)) throw new InvalidDataException(TooLarge);
                return read;
            }
            if (!_input.SkipTrailer(_sum, _length))
                throw new InvalidDataException(_input.RanDry ? CutOff : "It is damaged or cut off: the checksum at its end is missing or wrong.");
            _member!.Dispose();
            _member = null;
        }
        return 0;
    }

    protected override void Dispose(bool disposing)
    {
        if (disposing)
        {
            _member?.Dispose();
            if (!leaveOpen) _input.Source.Dispose();
        }
        base.Dispose(disposing);
    }

    private int Inflate(byte[] buffer, int offset, int count)
    {
        try
        {
            return _member!.Read(buffer, offset, count);
        }
        catch (Exception broken) when (broken is InvalidDataException or IOException && !_input.Failed)
        {
            // Mono throws IOException where .NET throws InvalidDataException.
            throw new InvalidDataException(_input.RanDry ? CutOff : "It is damaged.");
        }
    }

    private bool NextMember()
    {
        if (_any)
        {
            _input.SkipZeros();
            var first = _input.Peek(0);
            if (first < 0 || first != 0x1F || _input.Peek(1) is not (0x8B or -1))
            {
                HasTrailingBytes = first >= 0;
                _ended = true;
                return false;
            }
        }
        _any = true;
        Header();
        _input.BeginMember();
        _member = new DeflateStream(_input, CompressionMode.Decompress, true);
        _sum = _length = 0;
        return true;
    }

    private void Header()
    {
        const int Extra = 4, Name = 8, Comment = 16, HeaderSum = 2;
        if (Byte() != 0x1F || Byte() != 0x8B) throw new InvalidDataException("It is not gzip data.");
        if (Byte() != 8) throw new InvalidDataException("Its compression method is unknown.");
        var flags = Byte();
        for (var i = 0; i < 6; i++) Byte();
        if ((flags & Extra) != 0)
        {
            for (var left = Byte() | Byte() << 8; left > 0; left--) Byte();
        }
        if ((flags & Name) != 0) SkipText();
        if ((flags & Comment) != 0) SkipText();
        if ((flags & HeaderSum) == 0) return;
        Byte();
        Byte();
    }

    private void SkipText()
    {
        while (Byte() != 0)
        {
        }
    }

    private int Byte()
    {
        var value = _input.Peek(0);
        if (value < 0) throw new InvalidDataException(CutOff);
        _input.Skip();
        return value;
    }
}

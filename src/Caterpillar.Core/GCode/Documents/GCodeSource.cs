namespace Caterpillar.GCode;

/// <summary>A stream of G-code as plain text. Gzip is unpacked. Binary G-code becomes plain text. The stream itself stays open.</summary>
internal sealed class GCodeSource : IDisposable
{
    private const int TailLength = 96 * 1024;
    private readonly Stream _stream;
    private readonly GzipReader? _gzip;
    private readonly BinaryGCodeStream? _binary;
    private readonly long _length;

    /// <exception cref="IOException">The stream cannot be read.</exception>
    /// <exception cref="InvalidDataException">It begins with broken gzip data.</exception>
    public GCodeSource(Stream stream)
    {
        _stream = stream;
        _length = stream.CanSeek ? stream.Length : 0;
        var text = GzipReader.Open(stream, true);
        _gzip = text as GzipReader;
        var head = new byte[4];
        text = PeekedStream.Peek(text, head, out var count);
        if (BinaryGCodeStream.IsBinary(head, count)) text = _binary = new BinaryGCodeStream(text);
        Text = text;
    }

    public Stream Text { get; }

    /// <summary>True if these first bytes are not plain text.</summary>
    public static bool IsPacked(byte[] head, int count) => GzipReader.IsPacked(head, count) || BinaryGCodeStream.IsBinary(head, count);

    /// <summary>The end of the text, which contains the settings of some slicers. Null if it cannot be read yet.</summary>
    public GCodeChunk? Tail()
    {
        if (_binary is not null)
        {
            var known = _binary.Tail;
            return known.Length > 0 ? new GCodeChunk(known, 0, known.Length) : null;
        }
        if (!ReferenceEquals(Text, _stream) || !_stream.CanSeek) return null;
        var position = _stream.Position;
        if (_length - position < 2 * TailLength) return null;
        var bytes = new byte[TailLength];
        _stream.Seek(-TailLength, SeekOrigin.End);
        var count = ReadStream.Fill(_stream, bytes, 0, TailLength);
        _stream.Position = position;
        return new GCodeChunk(bytes, 0, count);
    }

    /// <summary>Progress after this many bytes of text, 0 to 1. Negative = unknown.</summary>
    public double Done(long bytes)
    {
        if (_length <= 0) return -1;
        var done = ReferenceEquals(Text, _stream) ? bytes : _binary is not null && _gzip is null ? _binary.Taken : _stream.Position;
        return Math.Min((double)done / _length, 1);
    }

    /// <summary>Diagnostics, at the end.</summary>
    public IReadOnlyList<Diagnostic> Notes() => _gzip is { HasTrailingBytes: true } ? [GzipReader.TrailingBytes("gcode.compression", "")] : [];

    public void Dispose() => _gzip?.Dispose();
}

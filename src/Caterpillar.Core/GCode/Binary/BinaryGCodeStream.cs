namespace Caterpillar.GCode;

/// <summary>
/// Reads Prusa's binary G-code (.bgcode, specification of libbgcode version 1): a header, then blocks with their own compression, encoding and checksum. The
/// result is the text that the slicer would write: producer, printer metadata and thumbnails as comments, then the G-code, then print metadata and settings as
/// comments. One block at a time is in memory. Every problem is an <see cref="InvalidDataException"/>.
/// </summary>
internal sealed class BinaryGCodeStream(Stream file) : ReadStream
{
    private const int FileHeader = 10;

    // All of a file's settings and images are in memory; real ones have some 100 KB.
    private const long MaxComments = 256L << 20;
    private readonly BinaryComments _before = new();
    private readonly BinaryComments _print = new();
    private readonly BinaryComments _settings = new();
    private byte[] _text = [];
    private int _at;
    private bool _begun;
    private bool _summed;
    private bool _code;
    private bool _ended;
    private long _packed = FileHeader;
    private long _plain;

    /// <summary>Bytes read from the file.</summary>
    public long Taken => _packed;

    /// <summary>The comments after the G-code, as far as read: Prusa's files have them before the G-code.</summary>
    public byte[] Tail => BinaryComments.Join(_print, _settings);

    /// <summary>True for the first bytes of a binary file.</summary>
    public static bool IsBinary(byte[] bytes, int count) => count >= 4 && bytes[0] == 'G' && bytes[1] == 'C' && bytes[2] == 'D' && bytes[3] == 'E';

    /// <exception cref="InvalidDataException">The file is broken or has an unknown version.</exception>
    public override int Read(byte[] buffer, int offset, int count)
    {
        if (count == 0) return 0;
        while (_at == _text.Length)
        {
            if (_ended) return 0;
            _text = Next();
            _at = 0;
            _plain += _text.Length;
            if (_plain > Limit(0)) throw new InvalidDataException(GzipReader.TooLarge);
        }
        var part = Math.Min(count, _text.Length - _at);
        Buffer.BlockCopy(_text, _at, buffer, offset, part);
        _at += part;
        return part;
    }

    protected override void Dispose(bool disposing)
    {
        if (disposing) file.Dispose();
        base.Dispose(disposing);
    }

    // As much as gzip may unpack to.
    private long Limit(long more) => GzipReader.Limit(_packed + more);

    private void Begin()
    {
        _begun = true;
        var head = new byte[FileHeader];
        if (Fill(file, head, 0, FileHeader) < FileHeader) throw new InvalidDataException("The header is cut off.");
        if (BinaryBlock.UInt32(head, 4) != 1) throw new InvalidDataException("The version of the binary G-code is unknown.");
        var checksum = BinaryBlock.UInt16(head, 8);
        if (checksum > 1) throw new InvalidDataException("The type of its checksums is unknown.");
        _summed = checksum == 1;
    }

    // The text of the next block of G-code, with the comments before it, or of the end.
    private byte[] Next()
    {
        if (!_begun) Begin();
        while (BinaryBlock.Read(file, _summed, Limit) is { } block)
        {
            _packed += block.Size;
            switch (block.Kind)
            {
                case BinaryBlockKind.GCode:
                    var code = block.Encoding switch
                    {
                        0 => block.Data,
                        1 or 2 => MeatPack.Unpack(block.Data),
                        _ => throw new InvalidDataException("The encoding of the G-code is unknown."),
                    };
                    if (_code) return code;
                    _code = true;
                    _before.Line("");
                    return BinaryComments.Join(_before, code);
                case BinaryBlockKind.Thumbnail:
                    // After the G-code it can only come at the end.
                    (_code ? _print : _before).Thumbnail(block);
                    break;
                case BinaryBlockKind.File:
                    (_code ? _print : _before).Producer(block);
                    break;
                case BinaryBlockKind.Printer:
                    (_code ? _print : _before).Table(block);
                    break;
                case BinaryBlockKind.Print:
                    if (block.Data.Length == 0) break;
                    _print.Line("");
                    _print.Table(block);
                    break;
                default:
                    if (block.Data.Length > 0) _settings.Settings(block);
                    break;
            }
            if (_before.Length + _print.Length + _settings.Length > MaxComments) throw new InvalidDataException("Its settings and thumbnails are too large.");
        }
        if (!_code) throw new InvalidDataException("It is cut off and contains no G-code.");
        _ended = true;
        return Tail;
    }
}

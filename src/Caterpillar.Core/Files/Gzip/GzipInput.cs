namespace Caterpillar.Files;

/// <summary>
/// The packed bytes of a gzip stream, in small pieces for the inflater. The inflater does not report how much of the last piece it used. The checksum and the
/// length after the data show it: eight bytes that are known once everything is decompressed.
/// </summary>
internal sealed class GzipInput(Stream source) : ReadStream
{
    private const int Piece = 8192;

    // The data ends in the last piece, or in the one before if the inflater read ahead.
    private const int Kept = 2 * Piece;
    private readonly byte[] _bytes = new byte[Kept + 8 * Piece];
    private int _memberStart;
    private int _at;
    private int _end;

    public Stream Source => source;

    /// <summary>Bytes read from the source.</summary>
    public long Taken { get; private set; }

    /// <summary>True if the inflater needed more bytes than the source has.</summary>
    public bool RanDry { get; private set; }

    /// <summary>True if the source could not be read.</summary>
    public bool Failed { get; private set; }

    public override int Read(byte[] buffer, int offset, int count)
    {
        if (!Have(1))
        {
            RanDry = true;
            return 0;
        }
        var part = Math.Min(Math.Min(count, Piece), _end - _at);
        Buffer.BlockCopy(_bytes, _at, buffer, offset, part);
        _at += part;
        return part;
    }

    /// <summary>A byte ahead, or −1 beyond the end.</summary>
    public int Peek(int ahead) => Have(ahead + 1) ? _bytes[_at + ahead] : -1;

    public void Skip() => _at++;

    public void SkipZeros()
    {
        while (Peek(0) == 0) _at++;
    }

    public void BeginMember()
    {
        _memberStart = _at;
        RanDry = false;
    }

    /// <summary>Skips the checksum and the length at the end of a member. False if they are missing.</summary>
    public bool SkipTrailer(uint sum, uint length)
    {
        Have(8);
        var last = Math.Min(_at, _end - 8);
        var first = Math.Max(_memberStart, _at - Kept);
        if (length == 0)
        {
            // Empty data has checksum 0, and zeros are everywhere: the end is looked up.
            first = EmptyEnd();
            last = Math.Min(last, first);
        }
        for (var at = first; at <= last; at++)
        {
            if (Number(at) != sum || Number(at + 4) != length) continue;
            _at = at + 8;
            return true;
        }
        return false;
    }

    // Empty data as compressors write it: flushes (empty stored blocks), and a last block that is empty, too.
    private int EmptyEnd()
    {
        var at = _memberStart;
        while (at + 5 < _end && _bytes[at] == 0 && IsEmptyStored(at)) at += 5;
        if (at + 1 < _end && _bytes[at] == 3 && _bytes[at + 1] == 0) return at + 2;
        return at + 4 < _end && _bytes[at] == 1 && IsEmptyStored(at) ? at + 5 : int.MaxValue;
    }

    private bool IsEmptyStored(int at) => _bytes[at + 1] == 0 && _bytes[at + 2] == 0 && _bytes[at + 3] == 0xFF && _bytes[at + 4] == 0xFF;

    private uint Number(int at) => (uint)(_bytes[at] | _bytes[at + 1] << 8 | _bytes[at + 2] << 16 | _bytes[at + 3] << 24);

    private bool Have(int count)
    {
        if (_end - _at >= count) return true;
        var drop = Math.Max(0, _at - Kept);
        if (drop > 0)
        {
            Buffer.BlockCopy(_bytes, drop, _bytes, 0, _end - drop);
            _at -= drop;
            _end -= drop;
            _memberStart = Math.Max(0, _memberStart - drop);
        }
        while (_end - _at < count)
        {
            int read;
            try
            {
                read = source.Read(_bytes, _end, _bytes.Length - _end);
            }
            catch (IOException)
            {
                Failed = true;
                throw;
            }
            if (read <= 0) return false;
            _end += read;
            Taken += read;
        }
        return true;
    }
}

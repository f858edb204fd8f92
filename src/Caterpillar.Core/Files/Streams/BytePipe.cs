namespace Caterpillar.Files;

/// <summary>A pipe for bytes from one thread to another, in reused pieces. The writer waits while many pieces are unread.</summary>
internal sealed class BytePipe : IDisposable
{
    private const int Pieces = 8;
    private const int PieceSize = 256 * 1024;
    private readonly BlockingCollection<Piece> _full = new(Pieces);
    private readonly ConcurrentBag<byte[]> _free = [];
    private volatile bool _isStopped;

    public BytePipe() => Reader = new PipeReader(this);

    /// <summary>The written bytes, as a stream for the other thread.</summary>
    public Stream Reader { get; }

    /// <summary>Copies bytes into the pipe. After <see cref="Stop"/>, they are dropped.</summary>
    public void Write(byte[] buffer, int offset, int count)
    {
        while (count > 0 && !_isStopped)
        {
            if (!_free.TryTake(out var bytes)) bytes = new byte[PieceSize];
            var part = Math.Min(count, PieceSize);
            Buffer.BlockCopy(buffer, offset, bytes, 0, part);
            while (!_isStopped && !_full.TryAdd(new Piece(bytes, part), 20))
            {
            }
            offset += part;
            count -= part;
        }
    }

    /// <summary>Ends writing.</summary>
    public void Complete() => _full.CompleteAdding();

    /// <summary>Ends reading.</summary>
    public void Stop() => _isStopped = true;

    public void Dispose() => _full.Dispose();

    private readonly record struct Piece(byte[] Bytes, int Count);

    private sealed class PipeReader(BytePipe pipe) : ReadStream
    {
        private Piece _piece = new([], 0);
        private int _at;

        public override int Read(byte[] buffer, int offset, int count)
        {
            while (_at == _piece.Count)
            {
                if (_at > 0) pipe._free.Add(_piece.Bytes);
                (_piece, _at) = (new Piece([], 0), 0);
                if (!pipe._full.TryTake(out _piece, -1)) return 0;
            }
            var part = Math.Min(count, _piece.Count - _at);
            Buffer.BlockCopy(_piece.Bytes, _at, buffer, offset, part);
            _at += part;
            return part;
        }
    }
}

/// <summary>A stream that writes to a stream, if any, and to a pipe.</summary>
internal sealed class PipedStream(Stream? target, BytePipe pipe) : WriteStream
{
    public override void Write(byte[] buffer, int offset, int count)
    {
        pipe.Write(buffer, offset, count);
        target?.Write(buffer, offset, count);
    }

    public override void Flush() => target?.Flush();
}

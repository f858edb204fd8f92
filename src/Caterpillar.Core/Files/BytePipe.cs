using System;
using System.Collections.Concurrent;
using System.IO;

namespace Caterpillar.Files;

/// <summary>Bytes from one thread to another, in pieces, without keeping them all. The writer waits while many pieces are not read yet.</summary>
internal sealed class BytePipe : IDisposable
{
    private const int Pieces = 8;
    private readonly BlockingCollection<byte[]> _pieces = new(Pieces);
    private volatile bool _isStopped;

    public BytePipe() => Reader = new PipeReader(this);

    /// <summary>What was written, as a stream for the other thread.</summary>
    public Stream Reader { get; }

    /// <summary>Copies bytes into the pipe; they are dropped where nobody reads any more.</summary>
    public void Write(byte[] buffer, int offset, int count)
    {
        if (count == 0) return;
        var piece = new byte[count];
        Buffer.BlockCopy(buffer, offset, piece, 0, count);
        while (!_isStopped)
        {
            if (_pieces.TryAdd(piece, 20)) return;
        }
    }

    /// <summary>Nothing more is written.</summary>
    public void Complete() => _pieces.CompleteAdding();

    /// <summary>Nothing more is read.</summary>
    public void Stop() => _isStopped = true;

    public void Dispose() => _pieces.Dispose();

    private sealed class PipeReader(BytePipe pipe) : Stream
    {
        private byte[] _piece = [];
        private int _at;

        public override bool CanRead => true;

        public override bool CanSeek => false;

        public override bool CanWrite => false;

        public override long Length => throw new NotSupportedException();

        public override long Position
        {
            get => throw new NotSupportedException();
            set => throw new NotSupportedException();
        }

        public override int Read(byte[] buffer, int offset, int count)
        {
            while (_at == _piece.Length)
            {
                if (!pipe._pieces.TryTake(out var next, -1)) return 0;
                (_piece, _at) = (next, 0);
            }
            var part = Math.Min(count, _piece.Length - _at);
            Buffer.BlockCopy(_piece, _at, buffer, offset, part);
            _at += part;
            return part;
        }

        public override void Flush()
        {
        }

        public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

        public override void SetLength(long value) => throw new NotSupportedException();

        public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();
    }
}

/// <summary>A stream that gives what is written to it to a stream, if there is one, and to a pipe.</summary>
internal sealed class PipedStream(Stream? target, BytePipe pipe) : Stream
{
    public override bool CanRead => false;

    public override bool CanSeek => false;

    public override bool CanWrite => true;

    public override long Length => throw new NotSupportedException();

    public override long Position
    {
        get => throw new NotSupportedException();
        set => throw new NotSupportedException();
    }

    public override void Write(byte[] buffer, int offset, int count)
    {
        pipe.Write(buffer, offset, count);
        target?.Write(buffer, offset, count);
    }

    public override void Flush() => target?.Flush();

    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();
}

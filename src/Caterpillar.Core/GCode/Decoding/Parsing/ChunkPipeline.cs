namespace Caterpillar.GCode;

/// <summary>
/// Parses chunks on several threads and delivers them in order, so that one thread follows the state of the machine while others read ahead. With one thread,
/// no other thread is started.
/// </summary>
internal static class ChunkPipeline
{
    /// <summary>Calls <paramref name="consume"/> for each chunk, in order, on the calling thread.</summary>
    /// <param name="chunks">The chunks, read on the calling thread.</param>
    /// <param name="newParser">Makes a parser. Parsers are reused.</param>
    /// <param name="isBeginning">True if the first chunk begins the file and may have a byte order mark.</param>
    /// <param name="threads">Number of parsing threads.</param>
    /// <param name="consume">Receives a parsed chunk and the number of bytes so far.</param>
    /// <param name="cancel">Cancels the work.</param>
    public static void Run(IEnumerable<GCodeChunk> chunks, Func<ChunkParser> newParser, bool isBeginning, int threads, Action<ChunkParser, long> consume,
        CancellationToken cancel)
    {
        if (threads <= 1)
        {
            var parser = newParser();
            long done = 0;
            var first = isBeginning;
            foreach (var chunk in chunks)
            {
                cancel.ThrowIfCancellationRequested();
                parser.Parse(chunk, chunk.Start + (first ? TextEncoding.MarkLength(chunk) : 0));
                first = false;
                done += chunk.Length;
                consume(parser, done);
            }
            return;
        }
        new Window(chunks, newParser, isBeginning, threads).Run(consume, cancel);
    }

    private sealed class Slot(ChunkParser parser)
    {
        public readonly ChunkParser Parser = parser;
        public GCodeChunk? Chunk;
        public int Skip;

        // 0 waiting, 1 taken, 2 parsed
        public int State;

        public void Parse()
        {
            Parser.Parse(Chunk!, Chunk!.Start + Skip);
            Volatile.Write(ref State, 2);
        }
    }

    private sealed class Window
    {
        private readonly IEnumerator<GCodeChunk> _chunks;
        private readonly Slot[] _slots;
        private readonly object _lock = new();
        private readonly int _threads;
        private readonly bool _isBeginning;
        private int _filled;
        private int _consumed;
        private bool _ended;
        private bool _stop;
        private Exception? _failure;

        public Window(IEnumerable<GCodeChunk> chunks, Func<ChunkParser> newParser, bool isBeginning, int threads)
        {
            _isBeginning = isBeginning;
            _chunks = chunks.GetEnumerator();
            _threads = threads;
            _slots = new Slot[threads * 3];
            for (var i = 0; i < _slots.Length; i++) _slots[i] = new Slot(newParser());
        }

        public void Run(Action<ChunkParser, long> consume, CancellationToken cancel)
        {
            var helpers = new Task[_threads - 1];
            for (var i = 0; i < helpers.Length; i++) helpers[i] = Task.Run(Help, CancellationToken.None);
            try
            {
                long done = 0;
                for (var next = 0; ; next++)
                {
                    cancel.ThrowIfCancellationRequested();
                    Fill();
                    if (_failure is not null) System.Runtime.ExceptionServices.ExceptionDispatchInfo.Capture(_failure).Throw();
                    if (next == _filled) return;
                    var slot = _slots[next % _slots.Length];
                    if (Interlocked.CompareExchange(ref slot.State, 1, 0) == 0) slot.Parse();
                    else Await(slot);
                    done += slot.Chunk!.Length;
                    consume(slot.Parser, done);
                    lock (_lock)
                    {
                        slot.State = 0;
                        slot.Chunk = null;
                        _consumed++;
                    }
                }
            }
            finally
            {
                lock (_lock)
                {
                    _stop = true;
                    Monitor.PulseAll(_lock);
                }
                Task.WaitAll(helpers);
                _chunks.Dispose();
            }
        }

        // Puts chunks into the free slots; the source is read by the calling thread only.
        private void Fill()
        {
            var added = false;
            while (!_ended && _filled - _consumed < _slots.Length)
            {
                if (!_chunks.MoveNext())
                {
                    _ended = true;
                    break;
                }
                var slot = _slots[_filled % _slots.Length];
                lock (_lock)
                {
                    slot.Chunk = _chunks.Current;
                    slot.Skip = _filled == 0 && _isBeginning ? TextEncoding.MarkLength(slot.Chunk) : 0;
                    _filled++;
                }
                added = true;
            }
            if (!added) return;
            lock (_lock) Monitor.PulseAll(_lock);
        }

        private void Await(Slot slot)
        {
            var spin = new SpinWait();
            while (Volatile.Read(ref slot.State) != 2)
            {
                if (Volatile.Read(ref _failure) is not null) return;
                spin.SpinOnce();
            }
        }

        private void Help()
        {
            try
            {
                while (true)
                {
                    Slot? mine = null;
                    lock (_lock)
                    {
                        while (!_stop && (mine = Take()) is null) Monitor.Wait(_lock);
                        if (_stop) return;
                    }
                    mine!.Parse();
                }
            }
            catch (Exception failure)
            {
                _failure = failure;
            }
        }

        private Slot? Take()
        {
            for (var i = _consumed; i < _filled; i++)
            {
                var slot = _slots[i % _slots.Length];
                if (slot.Chunk is not null && Interlocked.CompareExchange(ref slot.State, 1, 0) == 0) return slot;
            }
            return null;
        }
    }
}

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
        // Whoever needs a chunk first parses it: another thread, or this one.
        var ahead = new Queue<Lazy<ChunkParser>>();
        var idle = new Stack<ChunkParser>();
        long done = 0;
        var first = isBeginning;
        foreach (var chunk in chunks)
        {
            var parser = idle.Count > 0 ? idle.Pop() : newParser();
            var start = chunk.Start + (first ? TextEncoding.MarkLength(chunk) : 0);
            first = false;
            var parsed = new Lazy<ChunkParser>(() =>
            {
                parser.Parse(chunk, start);
                return parser;
            });
            ahead.Enqueue(parsed);
            if (threads > 1) Task.Run(() => parsed.Value, cancel);
            if (ahead.Count >= (threads > 1 ? 2 * threads : 1)) Deliver();
        }
        while (ahead.Count > 0) Deliver();

        void Deliver()
        {
            cancel.ThrowIfCancellationRequested();
            var parser = ahead.Dequeue().Value;
            done += parser.Chunk!.Length;
            consume(parser, done);
            idle.Push(parser);
        }
    }
}

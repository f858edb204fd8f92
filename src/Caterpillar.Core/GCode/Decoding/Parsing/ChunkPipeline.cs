namespace Caterpillar.GCode;

/// <summary>
/// Parses chunks on several threads and delivers them in order, so that one thread follows the state of the machine while others read ahead. With one thread,
/// no other thread is started.
/// </summary>
internal static class ChunkPipeline
{
    /// <summary>Calls <paramref name="consume"/> for each chunk of a file, in order, on the calling thread.</summary>
    /// <param name="chunks">The chunks, read on the calling thread.</param>
    /// <param name="extruder">The letter of E, or 0.</param>
    /// <param name="threads">Number of parsing threads.</param>
    /// <param name="isNeeded">True for the numbers of chunks that are sure to be asked for, which are parsed ahead.</param>
    /// <param name="consume">Receives a chunk, which is parsed when it is asked for, and the number of bytes so far.</param>
    /// <param name="cancel">Cancels the work.</param>
    public static void Run(IEnumerable<GCodeChunk> chunks, byte extruder, int threads, Func<int, bool> isNeeded, Action<Lazy<ChunkParser>, long> consume,
        CancellationToken cancel)
    {
        // Whoever needs a chunk first parses it: another thread, or this one.
        var ahead = new Queue<(GCodeChunk Chunk, ChunkParser Parser, Lazy<ChunkParser> Parsed)>();
        var mostAhead = threads > 1 ? 2 * threads : 1;
        var idle = new List<ChunkParser>();
        long done = 0;
        var number = 0;
        foreach (var chunk in chunks)
        {
            var parser = idle.Find(p => !p.IsHeld) ?? new ChunkParser(extruder);
            idle.Remove(parser);
            // The first chunk may have a byte order mark.
            var start = chunk.Start + (number == 0 ? TextEncoding.MarkLength(chunk) : 0);
            var parsed = new Lazy<ChunkParser>(() =>
            {
                parser.Parse(chunk, start);
                return parser;
            });
            ahead.Enqueue((chunk, parser, parsed));
            if (threads > 1 && isNeeded(number)) Task.Run(() => parsed.Value, cancel);
            number++;
            if (ahead.Count == mostAhead) Deliver();
        }
        while (ahead.Count > 0) Deliver();

        void Deliver()
        {
            cancel.ThrowIfCancellationRequested();
            var (chunk, parser, parsed) = ahead.Dequeue();
            done += chunk.Length;
            consume(parsed, done);
            idle.Add(parser);
        }
    }
}

namespace Caterpillar.GCode;

/// <summary>Options of decoding.</summary>
public sealed record DecodeOptions
{
    /// <summary>G-code flavor. Null = detect it from the file.</summary>
    public FlavorRules? Flavor { get; init; }

    /// <summary>Rule that decides which moves print.</summary>
    public ExtrusionRule Rule { get; init; } = ExtrusionRule.Balance;

    /// <summary>Filament diameter in mm if the file does not state it. Null = volumes are unknown.</summary>
    public double? FilamentDiameter { get; init; }

    /// <summary>Number of threads. 0 = all cores. The result does not depend on it.</summary>
    public int Threads { get; init; }

    /// <summary>Memory limit. Moves that do not fit into a part of it are kept in a temporary file.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>
    /// Called for each full block of moves, and for the last one if moves are not kept, on the reading thread. Blocks and chunks are smaller then, so that
    /// others can start early and the data stays in the cache.
    /// </summary>
    internal Action<DecodedBlock>? Take { get; init; }

    /// <summary>Heights of the flat extrusions of a file without layer comments, mm: those who take blocks know its layers. Null = unknown.</summary>
    internal IEnumerable<double>? Heights { get; init; }

    /// <summary>False where nobody needs all moves: the toolpath has none. For those who take them, all layers are one, which a comment begins.</summary>
    internal bool KeepsMoves { get; init; } = true;

    /// <summary>Adds up all moves, kept or not. Null = nobody.</summary>
    internal ToolpathSums? Sums { get; init; }

    /// <summary>Whether the text of a stream is kept, so that it can be edited.</summary>
    internal bool KeepsText { get; init; }

    /// <summary>Called before a stream is decoded, with what is known of it: its flavor and first lines. Returns who takes its chunks, too.</summary>
    internal Func<DecodedGCode, Action<ChunkParser, Checkpoint>>? Follow { get; init; }

    /// <summary>The same file without its moves, if it was decoded before, so that the layers of moves are known at once.</summary>
    internal DecodedGCode? Before { get; init; }

    /// <summary>True to decode only the first MB of a file and its end, if the end can be read before the rest.</summary>
    internal bool OnlyEnds { get; init; }

    /// <summary>Number of bytes per chunk.</summary>
    internal int ChunkSize => KeepsText ? GCodeChunk.Target : Take is null && KeepsMoves ? 1024 * 1024 : (Follow is null ? 64 : 128) * 1024;

    /// <summary>Collects moves, with room for some at first.</summary>
    internal BlockCollector NewBlocks(int firstSize)
        => KeepsMoves ? new(Take is null ? ToolpathBlock.Capacity : ToolpathBlock.FollowedSize, firstSize, ToolpathBlock.FileFor(Memory), true, Sums)
            : new(ToolpathBlock.FollowedSize, firstSize, null, false, Sums);

    internal int Degree => Threads > 0 ? Threads : Math.Max(Environment.ProcessorCount, 1);
}

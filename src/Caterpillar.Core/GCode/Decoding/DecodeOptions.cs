using Caterpillar.Basics;
using Caterpillar.Flavors;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Options of decoding.</summary>
public sealed record DecodeOptions
{
    /// <summary>The flavor, or null to detect it from the file.</summary>
    public FlavorRules? Flavor { get; init; }

    /// <summary>What counts as printing.</summary>
    public ExtrusionRule Rule { get; init; } = ExtrusionRule.Balance;

    /// <summary>Diameter of the filament in mm where the file does not say; null leaves volumes unknown.</summary>
    public double? FilamentDiameter { get; init; }

    /// <summary>Threads; 0 for all cores. The result does not depend on it.</summary>
    public int Threads { get; init; }

    /// <summary>How much memory the moves and the text may take; more is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>
    /// Takes each block of moves as soon as it is full, on the thread that reads; not the last one. Blocks are smaller then, and so is what is read at a time,
    /// so that others begin soon and what was read stays in the cache.
    /// </summary>
    internal Action<DecodedBlock>? Take { get; init; }

    internal int BlockSize => Take is null ? ToolpathBlock.Capacity : ToolpathBlock.FollowedSize;

    /// <summary>Number of bytes that are read at a time.</summary>
    internal int ChunkSize => Take is null ? 1024 * 1024 : 64 * 1024;

    internal int Degree => Threads > 0 ? Threads : Math.Max(Environment.ProcessorCount, 1);
}

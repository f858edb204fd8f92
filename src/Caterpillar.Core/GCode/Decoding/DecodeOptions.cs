using System;
using Caterpillar.Basics;
using Caterpillar.Dialects;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.GCode;

/// <summary>Options of decoding.</summary>
public sealed record DecodeOptions
{
    /// <summary>The dialect, or null to detect it from the file.</summary>
    public DialectRules? Dialect { get; init; }

    /// <summary>What counts as printing.</summary>
    public ExtrusionRule Rule { get; init; } = ExtrusionRule.Balance;

    /// <summary>Diameter of the filament in mm where the file does not say; null leaves volumes unknown.</summary>
    public double? FilamentDiameter { get; init; }

    /// <summary>Threads; 0 for all cores. The result does not depend on it.</summary>
    public int Threads { get; init; }

    /// <summary>How much memory the moves and the text may take; more is the error <see cref="MemoryLimit.Code"/>.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;

    /// <summary>Gets each block of moves as soon as it is full, on the thread that reads; not the last one.</summary>
    internal Action<DecodedBlock>? Follow { get; init; }

    /// <summary>Number of moves in a block.</summary>
    internal int BlockSize { get; init; } = ToolpathBlock.Capacity;

    /// <summary>Number of bytes that are read at a time.</summary>
    internal int ChunkSize { get; init; } = 1024 * 1024;

    /// <summary>False where full blocks are followed only: the toolpath is then without them.</summary>
    internal bool KeepsBlocks { get; init; } = true;

    internal int Degree => Threads > 0 ? Threads : Math.Max(Environment.ProcessorCount, 1);
}

using Caterpillar.Basics;

namespace Caterpillar.Turtles;

/// <summary>Limits that stop a program that does not end, with an error.</summary>
public sealed record TurtleLimits
{
    /// <summary>Statements that are executed; commands and loop iterations count, and a new array for each 64 of its numbers.</summary>
    public long MaxSteps { get; init; } = 50_000_000;

    /// <summary>Moves of the turtle.</summary>
    public long MaxMoves { get; init; } = 10_000_000;

    /// <summary>Nesting depth of procedure calls.</summary>
    public int MaxDepth { get; init; } = 10_000;

    /// <summary>Letters of a word of an L-system, and numbers of an array.</summary>
    public int MaxSymbols { get; init; } = LSystem.DefaultMaxSymbols;

    /// <summary>States that are pushed at one time.</summary>
    public int MaxStates { get; init; } = 1_000_000;

    /// <summary>What the moves, states and arrays of the program may take in all.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;
}

namespace Caterpillar.Turtles;

/// <summary>Limits that stop an endless program with an error.</summary>
public sealed record TurtleLimits
{
    /// <summary>Maximum number of steps. Statements and loop iterations count as one, and a new array counts as one per 64 numbers.</summary>
    public long MaxSteps { get; init; } = 50_000_000;

    /// <summary>Maximum number of moves of the turtle.</summary>
    public long MaxMoves { get; init; } = 10_000_000;

    /// <summary>Maximum nesting depth of procedure calls.</summary>
    public int MaxDepth { get; init; } = 10_000;

    /// <summary>Maximum number of letters in an L-system word, and of numbers in an array.</summary>
    public int MaxSymbols { get; init; } = LSystem.DefaultMaxSymbols;

    /// <summary>Maximum memory of the moves, states and arrays of the program.</summary>
    public MemoryLimit Memory { get; init; } = MemoryLimit.Default;
}

namespace Caterpillar.Turtles;

/// <summary>Where a program that does not end is stopped, with an error.</summary>
public sealed record TurtleLimits
{
    /// <summary>Statements that are executed; commands and turns of loops count.</summary>
    public long MaxSteps { get; init; } = 50_000_000;

    /// <summary>Moves of the turtle.</summary>
    public long MaxMoves { get; init; } = 10_000_000;

    /// <summary>Procedures that call each other.</summary>
    public int MaxDepth { get; init; } = 10_000;

    /// <summary>Letters of a word of an L-system, and numbers of an array.</summary>
    public int MaxSymbols { get; init; } = LSystem.DefaultMaxSymbols;
}

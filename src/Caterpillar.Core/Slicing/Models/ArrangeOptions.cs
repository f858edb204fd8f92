namespace Caterpillar.Slicing;

/// <summary>Options for arranging models on the bed.</summary>
public sealed record ArrangeOptions
{
    /// <summary>Minimum distance between the outlines of two models seen from above, mm.</summary>
    public double Spacing { get; init; } = 5;

    /// <summary>Minimum distance from the edge of the bed and from excluded areas, mm.</summary>
    public double Margin { get; init; } = 2;

    /// <summary>True if models are printed one after the other: they need room for the print head next to printed models.</summary>
    public bool OneAfterTheOther { get; init; }
}

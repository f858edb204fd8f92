namespace Caterpillar.Slicing;

/// <summary>How models are arranged on a bed.</summary>
public sealed record ArrangeOptions
{
    /// <summary>Smallest distance between the outlines of two models seen from above, mm.</summary>
    public double Spacing { get; init; } = 5;

    /// <summary>Smallest distance from the edge of the bed and from excluded areas, mm.</summary>
    public double Margin { get; init; } = 2;

    /// <summary>The models are printed one after the other: the head keeps clear of what stands already, as high as that is.</summary>
    public bool OneAfterTheOther { get; init; }
}

namespace Caterpillar.Slicing;

/// <summary>The order of the paths of an island. Walls take the ranks from <see cref="Walls"/> on.</summary>
internal static class StepRank
{
    public const int EarlyInfill = -20_000;

    // Walls over air take a rank each, up to the next.
    public const int OverAir = -10_000;
    public const int Walls = 0;
    public const int Bottom = 10_000;
    public const int Solid = 10_001;
    public const int Infill = 10_002;

    // Lines that keep their order take a rank each, from here on.
    public const int Top = 1_000_000;
    public const int Ironing = 1_000_000_000;
}

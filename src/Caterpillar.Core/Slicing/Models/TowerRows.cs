namespace Caterpillar.Slicing;

/// <summary>The rows of a layer of a purge tower, inside its wall. Lengths in mm.</summary>
/// <param name="rules">Rules of the layer.</param>
/// <param name="width">Width of the tower.</param>
internal readonly struct TowerRows(SliceRules rules, double width)
{
    // Rows come so much of a pitch closer to the wall than to each other.
    private const double Overlap = 0.15;

    /// <summary>Distance between rows, and between the wall and the first and last one.</summary>
    public double Pitch => rules.Pitch(rules.Width);

    /// <summary>Distance of the ends of rows from the edge of the tower.</summary>
    public double Inset => rules.Width / 2 + Pitch * (1 - Overlap);

    /// <summary>Number of rows for a volume in mm³, with the links between their ends.</summary>
    public int CountFor(double volume)
        => Math.Max(1, (int)Math.Ceiling((volume / rules.Bead(rules.Width).Area + Pitch) / (width - 2 * Inset + Pitch) - 1e-9));

    /// <summary>Depth of a tower with a number of rows.</summary>
    public double DepthOf(int rows) => rules.Width + Pitch * (rows + 1);
}

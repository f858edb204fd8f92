namespace Caterpillar.Geometry;

/// <summary>A subdivision would give too many points: the distance, tolerance or angle is too small for the curve.</summary>
internal sealed class SubdivisionLimitException : Exception
{
    /// <summary>Maximum number of points of one curve.</summary>
    public const int MaxPoints = 5_000_000;

    public SubdivisionLimitException()
        : base($"The subdivision would give one curve more than {NumberFormatter.Format(MaxPoints)} points. Use a larger distance, tolerance or angle.")
    {
    }
}

namespace Caterpillar.Geometry;

/// <summary>Options of plane sections.</summary>
internal sealed record SectionOptions
{
    /// <summary>
    /// Gaps of open contours up to this distance in mm are closed by a straight segment and reported (<c>mesh.gap_closed</c>); 0 closes none.
    /// Closed meshes have no gaps.
    /// </summary>
    public double GapMm { get; init; } = 0.1;

    /// <summary>Maximum number of threads. 0 = all cores. The result does not depend on it.</summary>
    public int Threads { get; init; }

    internal int Degree => Threads > 0 ? Threads : Environment.ProcessorCount;
}

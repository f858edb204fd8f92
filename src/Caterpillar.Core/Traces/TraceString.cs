namespace Caterpillar.Traces;

/// <summary>A straight, directed piece of an extrusion: Kanada's S = (start, end, c, v).</summary>
/// <param name="Start">Start, mm.</param>
/// <param name="End">End, mm.</param>
/// <param name="Area">Cross-section, mm².</param>
/// <param name="Speed">Speed of the head, mm/s; 0 = printing speed of the settings.</param>
public readonly record struct TraceString(Vec3 Start, Vec3 End, double Area, double Speed)
{
    /// <summary>Length in mm.</summary>
    public double Length => Start.DistanceTo(End);
}

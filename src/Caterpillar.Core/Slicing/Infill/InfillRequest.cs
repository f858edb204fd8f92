namespace Caterpillar.Slicing;

/// <summary>An area of a layer to be filled.</summary>
/// <param name="Area">Where the center lines of extrusions may run, mm.</param>
/// <param name="Pattern">What the lines look like.</param>
/// <param name="Spacing">
/// mm, positive: area filled per length of line. It is the pitch of solid lines × 100 / percent, whatever the pattern; patterns of several families of lines
/// space each family wider (<see cref="InfillFiller.Families"/>), so that all of them together lay down the same length.
/// </param>
/// <param name="Width">Width of an extrusion, mm, positive.</param>
internal sealed record InfillRequest(Region Area, InfillPattern Pattern, double Spacing, double Width)
{
    /// <summary>Direction of the (first) lines, degrees from +X.</summary>
    public double Angle { get; init; }

    /// <summary>Height of the extrusions, mm. Cubic, gyroid and formula depend on it.</summary>
    public double Z { get; init; }

    /// <summary>Number of the layer.</summary>
    public int Layer { get; init; }

    /// <summary>Ends of lines are joined along the boundary.</summary>
    public bool Linked { get; init; } = true;

    /// <summary>Longest joint along the boundary, mm; 0 = twice the distance of the lines.</summary>
    public double LongestLink { get; init; }

    /// <summary>How far an end that is not joined is led along the boundary, mm.</summary>
    public double Anchor { get; init; }

    /// <summary>Nothing may stay uncovered: rows fit between the sides of each island, and the flow follows their distance.</summary>
    public bool Solid { get; init; }

    /// <summary>Solid lines end straight: what their turns leave open beside the walls is not seen, and bends take time.</summary>
    public bool Hidden { get; init; }

    /// <summary>By how much solid lines end early where they turn back sharply, which takes time, mm. 0 for lines that must reach the walls.</summary>
    public double Early { get; init; }

    /// <summary>How far ends of solid lines reach into what surrounds the area, mm; lines along its edge do not.</summary>
    public double Overlap { get; init; }

    /// <summary>
    /// For <see cref="InfillPattern.Formula"/>: variables x, y, z (mm), layer, spacing and width, in this order (<see cref="LevelSet.Variables"/>).
    /// </summary>
    public Formula? Formula { get; init; }

    /// <summary>For <see cref="InfillPattern.Formula"/>: maximum deviation of the lines from the exact curve, mm.</summary>
    public double Tolerance { get; init; } = 0.02;

    /// <summary>For <see cref="InfillPattern.Gyroid"/>: maximum deviation of its chords, mm.</summary>
    public double Chords { get; init; } = 0.04;

    /// <summary>For <see cref="InfillPattern.Curves"/> and <see cref="InfillPattern.Lightning"/>: the lines of this layer, in mm.</summary>
    public IReadOnlyList<Polyline>? Curves { get; init; }
}

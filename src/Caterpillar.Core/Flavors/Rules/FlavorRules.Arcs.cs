using Caterpillar.Geometry;

namespace Caterpillar.Flavors;

/// <summary>G2 and G3.</summary>
public sealed partial record FlavorRules
{
    /// <summary>G2 and G3 exist.</summary>
    internal bool Arcs { get; init; } = true;

    /// <summary>Arcs by R; otherwise an arc without center is refused and does nothing.</summary>
    internal bool RadiusArcs { get; init; } = true;

    /// <summary>R is understood in the plane XY only.</summary>
    internal bool RadiusInXyOnly { get; init; }

    /// <summary>
    /// How far half the chord of an arc by R may exceed the radius, as a share of the radius: such an arc is a half circle about the middle of its chord.
    /// Others are refused.
    /// </summary>
    internal double ShortRadius { get; init; } = double.PositiveInfinity;

    /// <summary>The same in mm, in addition.</summary>
    internal double ShortRadiusMm { get; init; }

    /// <summary>What an arc with both R and I J K is.</summary>
    internal RadiusAndCenterRule RadiusAndCenter { get; init; } = RadiusAndCenterRule.RadiusWins;

    /// <summary>Arcs in G91; otherwise they are refused and do nothing.</summary>
    internal bool ArcsInRelativeMode { get; init; } = true;

    /// <summary>What P of an arc means.</summary>
    internal ArcTurnsRule ArcTurns { get; init; }

    /// <summary>An arc with neither center nor radius is a straight line; otherwise it is refused.</summary>
    internal bool ArcWithoutCenterIsLine { get; init; }

    /// <summary>An arc must name its end in the plane, a full circle too; otherwise it is refused.</summary>
    internal bool ArcNamesEnd { get; init; }

    /// <summary>G90.1 and G91.1 switch the centers of arcs.</summary>
    internal bool AbsoluteCenters { get; init; }

    /// <summary>G18 and G19 choose other planes for arcs.</summary>
    internal bool Planes { get; init; } = true;

    /// <summary>In G18 the arcs turn the other way than by the standard: G3 from X to Z.</summary>
    internal bool MirroredZx { get; init; }

    /// <summary>G3 draws full circles; otherwise G2 alone does, and G3 to the point where it begins makes no turn.</summary>
    internal bool CounterclockwiseCircles { get; init; } = true;

    /// <summary>The rise of a helix comes at once, before the circle.</summary>
    internal bool HelixRisesFirst { get; init; }

    /// <summary>Which arcs are refused because start and end lie on different circles; null where none is.</summary>
    internal ArcTolerance? ArcTolerance { get; init; }

    /// <summary>2 or 3: the command for an arc that turns clockwise or counter-clockwise in its plane, seen as the standard does.</summary>
    internal int ArcCode(ArcPlane plane, bool clockwise) => clockwise != (MirroredZx && plane == ArcPlane.ZX) ? 2 : 3;

    /// <summary>The number after P for an arc of this many turns (the last may be a part), or 0 if P cannot express it.</summary>
    internal int TurnsWord(int turns) => turns <= 1 ? 0 : ArcTurns switch { ArcTurnsRule.Count => turns, ArcTurnsRule.Added => turns - 1, _ => 0 };
}

/// <summary>What P of an arc means.</summary>
internal enum ArcTurnsRule
{
    /// <summary>Nothing.</summary>
    Ignored,

    /// <summary>The turns in all: P1 is the arc itself.</summary>
    Count,

    /// <summary>Full circles more, which share rise and extrusion with the arc.</summary>
    Added,

    /// <summary>Full circles in the plane and without extrusion first, then the arc.</summary>
    CirclesFirst,

    /// <summary>Only P1, and only of a full circle; other arcs with P are refused.</summary>
    OneCircle,

    /// <summary>Arcs with P are refused.</summary>
    Refused,
}

/// <summary>What an arc with both R and I J K is.</summary>
internal enum RadiusAndCenterRule
{
    /// <summary>R is ignored.</summary>
    CenterWins,

    /// <summary>I, J and K are ignored.</summary>
    RadiusWins,

    /// <summary>The arc is refused.</summary>
    Refused,
}

/// <summary>
/// When an arc is refused because its end is not on the circle about its center: where the radii of start and end differ by more than
/// <see cref="Largest"/> (mm), or by more than <see cref="Smallest"/> (mm) and by more than <see cref="Relative"/> of the radius.
/// </summary>
internal sealed record ArcTolerance(double Smallest, double Largest, double Relative)
{
    /// <summary>True when these radii (mm) are too different.</summary>
    public bool Refuses(double startRadius, double endRadius)
    {
        var difference = Math.Abs(startRadius - endRadius);
        return difference > Largest || (difference > Smallest && difference > Relative * Math.Max(startRadius, endRadius));
    }
}

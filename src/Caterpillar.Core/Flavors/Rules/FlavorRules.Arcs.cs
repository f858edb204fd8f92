namespace Caterpillar.Flavors;

/// <summary>G2 and G3.</summary>
public sealed partial class FlavorRules
{
    /// <summary>G2 and G3 are supported.</summary>
    internal bool Arcs { get; } = words.Is(nameof(Arcs), true);

    /// <summary>Arcs by R are supported. Otherwise an arc without center is refused and does nothing.</summary>
    internal bool RadiusArcs { get; } = words.Is(nameof(RadiusArcs), true);

    /// <summary>R is supported in the XY plane only.</summary>
    internal bool RadiusInXyOnly { get; } = words.Is(nameof(RadiusInXyOnly));

    /// <summary>
    /// Maximum excess of half the chord of an arc by R over the radius, relative to the radius. Such an arc is a half circle about the middle of its chord.
    /// Others are refused.
    /// </summary>
    internal double ShortRadius { get; } = words.Number(nameof(ShortRadius), double.PositiveInfinity);

    /// <summary>The same in mm, in addition.</summary>
    internal double ShortRadiusMm { get; } = words.Number(nameof(ShortRadiusMm));

    /// <summary>Meaning of an arc with both R and I J K.</summary>
    internal RadiusAndCenterRule RadiusAndCenter { get; } = words.One(nameof(RadiusAndCenter), RadiusAndCenterRule.RadiusWins);

    /// <summary>Arcs are supported in G91. Otherwise they are refused and do nothing.</summary>
    internal bool ArcsInRelativeMode { get; } = words.Is(nameof(ArcsInRelativeMode), true);

    /// <summary>Meaning of P of an arc.</summary>
    internal ArcTurnsRule ArcTurns { get; } = words.One<ArcTurnsRule>(nameof(ArcTurns));

    /// <summary>An arc with neither center nor radius is a straight line. Otherwise it is refused.</summary>
    internal bool ArcWithoutCenterIsLine { get; } = words.Is(nameof(ArcWithoutCenterIsLine));

    /// <summary>Every arc must name its end in the plane, even a full circle. Otherwise it is refused.</summary>
    internal bool ArcNamesEnd { get; } = words.Is(nameof(ArcNamesEnd));

    /// <summary>G90.1 and G91.1 switch between absolute and relative arc centers.</summary>
    internal bool AbsoluteCenters { get; } = words.Is(nameof(AbsoluteCenters));

    /// <summary>G18 and G19 select other planes for arcs.</summary>
    internal bool Planes { get; } = words.Is(nameof(Planes), true);

    /// <summary>Arcs in G18 turn opposite to the standard: G3 from X to Z.</summary>
    internal bool MirroredZx { get; } = words.Is(nameof(MirroredZx));

    /// <summary>G3 draws full circles. Otherwise only G2 does, and G3 to its start point does not turn.</summary>
    internal bool CounterclockwiseCircles { get; } = words.Is(nameof(CounterclockwiseCircles), true);

    /// <summary>A helix moves in Z first, before the circle.</summary>
    internal bool HelixRisesFirst { get; } = words.Is(nameof(HelixRisesFirst));

    /// <summary>Which arcs are refused because start and end are on different circles; null = none.</summary>
    internal ArcTolerance? ArcTolerance { get; } = Flavors.ArcTolerance.Read(words.List(nameof(ArcTolerance)));

    /// <summary>2 or 3: the command for an arc that turns clockwise or counterclockwise in its plane by the standard.</summary>
    internal int ArcCode(ArcPlane plane, bool clockwise) => clockwise != (MirroredZx && plane == ArcPlane.ZX) ? 2 : 3;

    /// <summary>The number after P for an arc of this many turns (the last may be partial), or 0 if P cannot express it.</summary>
    internal int TurnsWord(int turns) => turns <= 1 ? 0 : ArcTurns switch { ArcTurnsRule.Count => turns, ArcTurnsRule.Added => turns - 1, _ => 0 };
}

/// <summary>Meaning of P of an arc.</summary>
internal enum ArcTurnsRule
{
    /// <summary>Nothing.</summary>
    Ignored,

    /// <summary>Total number of turns: P1 is the arc itself.</summary>
    Count,

    /// <summary>Additional full circles that share Z movement and extrusion with the arc.</summary>
    Added,

    /// <summary>Flat full circles without extrusion before the arc.</summary>
    CirclesFirst,

    /// <summary>Only P1 of a full circle is allowed. Other arcs with P are refused.</summary>
    OneCircle,

    /// <summary>Arcs with P are refused.</summary>
    Refused,
}

/// <summary>Meaning of an arc with both R and I J K.</summary>
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
/// When an arc is refused because its end is not on the circle about its center: if the radii of start and end differ by more than
/// <see cref="Largest"/> (mm), or by more than <see cref="Smallest"/> (mm) and by more than <see cref="Relative"/> of the radius.
/// </summary>
internal sealed record ArcTolerance(double Smallest, double Largest, double Relative)
{
    /// <summary>The tolerance with these numbers; null for none.</summary>
    public static ArcTolerance? Read(IReadOnlyList<string> numbers)
    {
        var values = numbers.Select(n => NumberReader.TryParse(n, out var value) ? value : 0).ToArray();
        return values.Length == 3 ? new ArcTolerance(values[0], values[1], values[2]) : null;
    }

    /// <summary>True if these radii (mm) differ too much.</summary>
    public bool Refuses(double startRadius, double endRadius)
    {
        var difference = Math.Abs(startRadius - endRadius);
        return difference > Largest || (difference > Smallest && difference > Relative * Math.Max(startRadius, endRadius));
    }
}

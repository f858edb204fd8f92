using System;

namespace Caterpillar.Dialects;

/// <summary>
/// When an arc is refused because its end is not on the circle about its center: where the radii of start and end differ by more than <see cref="Largest"/>
/// (mm), or by more than
/// <see cref="Smallest"/> (mm) and by more than <see cref="Relative"/> of the radius.
/// </summary>
public sealed record ArcTolerance(double Smallest, double Largest, double Relative)
{
    /// <summary>True when these radii (mm) are too different.</summary>
    public bool Refuses(double startRadius, double endRadius)
    {
        var difference = Math.Abs(startRadius - endRadius);
        return difference > Largest || (difference > Smallest && difference > Relative * Math.Max(startRadius, endRadius));
    }
}

namespace Caterpillar.Planning;

/// <summary>
/// The space that the head sweeps along a travel: rings around its axis, each with the minimum height of the head above the tip inside it. A print may be as
/// high as the ring it comes under.
/// </summary>
/// <param name="rings">Outer radius and minimum height above the tip, mm; from the tip outward, the first at height 0.</param>
internal sealed class HeadCorridor(IEnumerable<(double Radius, double Height)> rings)
{
    private readonly (double Radius, double Height)[] _rings = [.. rings];

    /// <summary>Radius of the tip, mm.</summary>
    public double TipRadius => _rings[0].Radius;

    /// <summary>
    /// Minimum height of the tip, mm, at which the head passes from a to b without touching the print; negative infinity if nothing is near. Results
    /// below <paramref name="level"/>, the height that the travel has anyway, are not refined.
    /// </summary>
    public double RequiredHeight(Deposit deposit, Vec3 a, Vec3 b, double level)
    {
        var needed = double.NegativeInfinity;
        foreach (var (radius, height) in _rings)
        {
            if (deposit.Highest - height <= Math.Max(needed, level)) break;
            needed = Math.Max(needed, deposit.TopAlong(a, b, radius) - height);
        }
        return needed;
    }

    /// <summary>Rings of an outline whose points are joined by cones: each cone in several steps, at the height of its inner edge.</summary>
    public static IEnumerable<(double Radius, double Height)> Rings(IEnumerable<(double Radius, double Height)> outline, int steps = 4)
    {
        double radius = 0, height = 0;
        foreach (var (r, h) in outline)
        {
            var pieces = height < h && radius > 0 ? steps : 1;
            for (var i = 1; i <= pieces; i++) yield return (radius + (r - radius) * i / pieces, height + (h - height) * (i - 1) / pieces);
            (radius, height) = (r, h);
        }
    }
}

using System;
using Caterpillar.Toolpaths;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>The reach of a head by its definition, height by height.</summary>
internal static class HeadReach
{
    /// <summary>
    /// Reach from the axis of the head to the axis of an extrusion with half its width. If lenient, an extrusion next to the axis that rises by less than 45°
    /// does not count if only the flat of the tip digs into it.
    /// </summary>
    public static double AxisReach(this HeadShape head, double excess, double half, bool lenient)
    {
        var reach = head.Reach(excess);
        if (reach < 0) return -1;
        if (!lenient || reach > 3 * head.FlatRadius) return reach + half;
        var inner = head.Reach(excess - head.FlatRadius);
        return Math.Min(reach + half, Math.Max(excess, inner < 0 ? 0 : inner + half));
    }
}

using System.Collections.Generic;
using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Tests.Toolpaths;

/// <summary>Points of the top of a straight extrusion, level across itself and round at its ends.</summary>
internal static class SampledExtrusion
{
    public static IEnumerable<Vec3> Top(Vec3 a, Vec3 b, double half, int steps)
    {
        var length = (b - a).LengthXY;
        var along = length > 0 ? new Vec3((b.X - a.X) / length, (b.Y - a.Y) / length) : new Vec3(1, 0);
        var aside = new Vec3(-along.Y, along.X);
        for (var w = half > 0 ? -2 : 0; w <= (half > 0 ? 2 : 0); w++)
        {
            for (var k = 0; k <= steps; k++) yield return Vec3.Lerp(a, b, (double)k / steps) + aside * (half * w / 2);
        }
        for (var k = 0; k <= 16; k++)
        {
            var (cos, sin) = (half * Angle.Cos(180.0 * k / 16 - 90), half * Angle.Sin(180.0 * k / 16 - 90));
            yield return a + aside * sin - along * cos;
            yield return b + aside * sin + along * cos;
        }
    }
}

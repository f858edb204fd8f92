using System;
using Caterpillar.Geometry;

namespace Caterpillar.Examples;

/// <summary>
/// A piece of terrain, 120 × 90 mm, with a lake. It has four octaves of value noise over a grid of pseudo-random heights (a hash of integers, the same
/// everywhere).
/// </summary>
internal static class Terrain
{
    private const int Columns = 104;
    private const int Rows = 78;

    public static TriMesh Make() => HeightBlock.Make(120, 90, Columns, Rows, (i, j) =>
    {
        var x = (double)i / Columns * 4;
        var y = (double)j / Columns * 4;
        var sum = 0.0;
        var size = 1.0;
        for (var octave = 0; octave < 4; octave++)
        {
            sum += size * Noise(x, y, octave);
            x *= 2;
            y *= 2;
            size *= 0.45;
        }
        return 4 + 20 * Math.Max(0, sum / 1.74 - 0.33);
    });

    // 0 to 1, smooth between the points of the grid.
    private static double Noise(double x, double y, int octave)
    {
        int i = (int)x, j = (int)y;
        var (u, v) = (Smooth(x - i), Smooth(y - j));
        var low = Corner(i, j, octave) * (1 - u) + Corner(i + 1, j, octave) * u;
        var high = Corner(i, j + 1, octave) * (1 - u) + Corner(i + 1, j + 1, octave) * u;
        return low * (1 - v) + high * v;
    }

    private static double Smooth(double t) => t * t * t * (t * (6 * t - 15) + 10);

    private static double Corner(int i, int j, int octave)
    {
        unchecked
        {
            var h = (uint)i * 0x9E3779B1u ^ (uint)j * 0x85EBCA77u ^ (uint)(octave + 1) * 0xC2B2AE3Du;
            h = (h ^ h >> 15) * 0x2C1B3C6Du;
            h = (h ^ h >> 12) * 0x297A2D39u;
            return (h ^ h >> 15) / 4294967296.0;
        }
    }
}

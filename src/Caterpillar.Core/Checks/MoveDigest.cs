using System;
using Caterpillar.GCode;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Checks;

/// <summary>
/// A number of 64 bits for all that checks see of a block but its lines: blocks that have the same are the same moves. Only for one run of a program.
/// </summary>
internal static class MoveDigest
{
    // Odd, with bits all over: multiplying by it and turning spreads every bit over all others.
    private const ulong Factor = 0x9E3779B97F4A7C15;

    public static ulong Of(DecodedBlock block)
    {
        var c = block.Columns;
        var start = block.Start ?? Vec3.Zero;
        var sum = Mix(Mix(Mix(Mix((ulong)(uint)c.Count, start.X), start.Y), start.Z), block.Start is null ? 0UL : 1);
        // Sums beside each other need not wait for each other.
        ulong places = 1, amounts = 2, kinds = 3;
        for (var i = 0; i < c.Count; i++)
        {
            // Of moves before the first strand of a layer nobody asks for its thickness; a block may end before it is known.
            var thickness = c.Deposited[i] > 0 && block.Layers[i] is >= 0 and var layer ? block.Thicknesses![layer] : 0;
            places = Mix(Mix(Mix(places, c.X[i]), c.Y[i]), c.Z[i]);
            amounts = Mix(Mix(Mix(amounts, c.E[i]), c.Deposited[i]), c.Speed[i]);
            kinds = Mix(Mix(Mix(Mix(kinds, thickness), (ulong)c.Kind[i]), (ulong)c.Role[i]), (ulong)c.Tool[i]);
        }
        sum = Mix(Mix(Mix(sum, places), amounts), kinds);
        for (var i = 0; i < c.Arcs.Length; i++)
        {
            var arc = c.Arcs[i];
            sum = Mix(Mix(Mix(Mix(sum, arc.Center.X), arc.Center.Y), arc.Center.Z), arc.Sweep);
            sum = Mix(Mix(sum, (ulong)c.ArcMoves[i]), (ulong)arc.Plane);
        }
        foreach (var entry in block.Events)
        {
            if (entry.Event is HomeEvent home) sum = Mix(Mix(sum, (ulong)(uint)entry.Move), (ulong)(uint)home.GetHashCode());
        }
        return sum;
    }

    private static ulong Mix(ulong sum, double value) => Mix(sum, (ulong)BitConverter.DoubleToInt64Bits(value));

    private static ulong Mix(ulong sum, ulong value)
    {
        sum = (sum ^ value) * Factor;
        return sum ^ (sum >> 29);
    }
}

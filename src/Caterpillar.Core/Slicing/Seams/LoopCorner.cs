namespace Caterpillar.Slicing;

/// <summary>How well a corner of a loop hides a seam. The part lies on the left of its loops.</summary>
internal static class LoopCorner
{
    // Degrees: a smaller turn hides nothing, a greater one no more.
    private const double Least = 25;
    private const double Full = 90;

    // A seam in a convex corner is seen, though less than on a smooth side.
    private const double Convex = 0.5;

    /// <summary>From 0 for a smooth place to 1 for a concave corner.</summary>
    /// <param name="loop">The loop.</param>
    /// <param name="vertex">The vertex.</param>
    /// <param name="arm">Length over which the directions before and after the vertex are taken, so that rounded corners count, mm.</param>
    public static double Score(Vec3[] loop, int vertex, double arm)
    {
        var turn = Turn(loop, vertex, arm);
        var sharp = Math.Min(1, Math.Max(0, (Math.Abs(turn) - Least) / (Full - Least)));
        return turn > 0 ? sharp * Convex : sharp;
    }

    /// <summary>By how much the loop turns left, around the part, in degrees from −180 to 180; arms as for <see cref="Score"/>.</summary>
    public static double Turn(Vec3[] loop, int vertex, double arm)
    {
        var at = loop[vertex];
        var back = Along(loop, vertex, -1, arm) - at;
        var on = Along(loop, vertex, 1, arm) - at;
        return Angle.Atan2(on.X * back.Y - on.Y * back.X, -(on.X * back.X + on.Y * back.Y));
    }

    private static Vec3 Along(Vec3[] loop, int vertex, int direction, double length)
    {
        var at = vertex;
        for (var n = 1; n < loop.Length; n++)
        {
            var next = at + direction < 0 ? loop.Length - 1 : at + direction == loop.Length ? 0 : at + direction;
            var step = (loop[next] - loop[at]).LengthXY;
            if (step >= length) return Vec3.Lerp(loop[at], loop[next], length / step);
            length -= step;
            at = next;
        }
        return loop[at];
    }
}

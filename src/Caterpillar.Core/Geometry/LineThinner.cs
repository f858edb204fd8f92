namespace Caterpillar.Geometry;

/// <summary>Leaves away points of a line that straight pieces do not need.</summary>
internal static class LineThinner
{
    private const int Longest = 64;

    /// <summary>
    /// The points that are kept: from each on as far as all points passed lie within the tolerance of the chord. The first is always kept, the last never, so
    /// that closed lines, which end at their first point, can do without.
    /// </summary>
    public static List<Vec3> Thin(List<Vec3> line, double tolerance)
    {
        var kept = new List<Vec3> { line[0] };
        var anchor = 0;
        for (var i = 2; i < line.Count; i++)
        {
            if (i - anchor <= Longest && IsStraight(line, anchor, i, tolerance)) continue;
            anchor = i - 1;
            kept.Add(line[anchor]);
        }
        return kept;
    }

    private static bool IsStraight(List<Vec3> line, int from, int to, double tolerance)
    {
        Vec3 a = line[from], chord = line[to] - a;
        var square = chord.LengthSquared;
        if (square == 0) return false;
        for (var k = from + 1; k < to; k++)
        {
            var p = line[k] - a;
            var along = Vec3.Dot(p, chord);
            if (along < 0 || along > square || Vec3.Cross(p, chord).LengthSquared > tolerance * tolerance * square) return false;
        }
        return true;
    }
}

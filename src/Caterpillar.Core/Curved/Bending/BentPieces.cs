namespace Caterpillar.Curved;

/// <summary>Tells whether edges and triangles of a part match their bent images. It only reads, so any thread may ask.</summary>
/// <param name="field">Bends points.</param>
/// <param name="tolerance">mm.</param>
/// <param name="part">Points of the part.</param>
/// <param name="flat">The same points, bent.</param>
internal sealed class BentPieces(LayerField field, double tolerance, List<Vec3> part, List<Vec3> flat)
{
    // Uneven, so that waves do not hide between them.
    private static readonly double[] Shares = [0.5, 0.27, 0.81];
    private static readonly (double U, double V)[] Inner = [(1.0 / 3, 1.0 / 3), (0.2, 0.2), (0.6, 0.2), (0.2, 0.6)];
    private const int MostSamples = 4096;

    // Of the tolerance, where no other place has to be looked at.
    private const double Clear = 0.125;
    private readonly IReadOnlyList<double> _creases = field.Creases;

    /// <summary>Where an edge must be divided; null if it matches.</summary>
    public (Vec3 Part, Vec3 Flat)? Test((int A, int B) edge)
    {
        var (a, b) = edge;
        // Shorter ones would not be seen in print.
        if (part[a].DistanceTo(part[b]) < tolerance) return null;
        if (IsShort(a, b) && !IsOff(a, b, 0.5, Clear)) return null;
        foreach (var t in Shares)
        {
            if (IsOff(a, b, t)) return Middle(edge);
        }
        var samples = Samples(part[b] - part[a], 2);
        for (var i = 0; i < samples; i++)
        {
            if (IsOff(a, b, (i + Shares[i % 3]) / samples)) return Middle(edge);
        }
        return null;
    }

    /// <summary>Where an edge is divided: where it crosses a crease of the field, else in its middle.</summary>
    public (Vec3 Part, Vec3 Flat) Middle((int A, int B) edge)
    {
        var at = MiddleOf(edge.A, edge.B);
        return (at, field.ToFlat(at));
    }

    /// <summary>Shorter edges would not be seen in print.</summary>
    public bool CanDivide((int A, int B) edge) => (part[edge.A] - part[edge.B]).LengthSquared > 4 * tolerance * tolerance;

    /// <summary>Whether a triangle with edges that match does so inside, too.</summary>
    public bool IsFlat((int A, int B, int C) corners)
    {
        var (a, b, c) = corners;
        // Turned until the longest edge comes first.
        double ab = (part[b] - part[a]).LengthSquared, bc = (part[c] - part[b]).LengthSquared, ca = (part[a] - part[c]).LengthSquared;
        if (bc > ab && bc >= ca) (a, b, c, ab) = (b, c, a, bc);
        else if (ca > ab) (a, b, c, ab) = (c, a, b, ca);
        // Narrow ones have no inside that could differ from their edges.
        var area = Vec3.Cross(part[b] - part[a], part[c] - part[a]);
        if (area.LengthSquared < 16 * tolerance * tolerance * ab) return true;
        if (IsShort(a, b) && !IsOff(a, b, c, 1.0 / 3, 1.0 / 3, Clear)) return true;
        foreach (var (u, v) in Inner)
        {
            if (IsOff(a, b, c, u, v)) return false;
        }
        var across = Vec3.Cross(area, part[b] - part[a]) / ab;
        var rows = Samples(across, 1);
        for (var j = 0; j < rows; j++)
        {
            var w = (j + Shares[j % 3]) / rows;
            var columns = Samples((part[b] - part[a]) * (1 - w), 1);
            for (var i = 0; i < columns; i++)
            {
                if (IsOff(a, b, c, (1 - w) * (1 - (i + Shares[(i + j) % 3]) / columns), (1 - w) * (i + Shares[(i + j) % 3]) / columns)) return false;
            }
        }
        return true;
    }

    // So many places that no feature of the field is missed; none where the fixed ones do.
    private int Samples(Vec3 step, int density)
    {
        var count = density * field.Span(step) / field.Detail;
        return count > 1 ? (int)Math.Min(MostSamples, Math.Ceiling(count)) : 0;
    }

    // Within a detail of the field, the middle tells.
    private bool IsShort(int a, int b) => field.Span(part[b] - part[a]) < field.Detail;

    private bool IsOff(int a, int b, double t, double share = 1)
        => IsOff(Vec3.Lerp(part[a], part[b], t), Vec3.Lerp(flat[a], flat[b], t), share * tolerance);

    private bool IsOff(int a, int b, int c, double u, double v, double share = 1)
    {
        var w = 1 - u - v;
        return IsOff(part[a] * u + part[b] * v + part[c] * w, flat[a] * u + flat[b] * v + flat[c] * w, share * tolerance);
    }

    // Where layers are thin, what is much for the field is little in the part.
    private bool IsOff(Vec3 place, Vec3 straight, double most)
    {
        var off = field.ToFlat(place) - straight;
        if (!(off.LengthSquared > most * most)) return false;
        return off.LengthXY > most || Math.Abs(off.Z) * Math.Min(1, field.Spread(place)) > most;
    }

    private Vec3 MiddleOf(int a, int b)
    {
        foreach (var crease in _creases)
        {
            double low = flat[a].Z - crease, high = flat[b].Z - crease;
            if (low < 0 == high < 0 || Math.Min(Math.Abs(low), Math.Abs(high)) < tolerance) continue;
            double from = 0, to = 1, t = 0.5;
            for (var i = 0; i < 20; i++)
            {
                t = from + (to - from) * low / (low - high);
                var at = field.Value(Vec3.Lerp(part[a], part[b], t)) - crease;
                if (Math.Abs(at) < 1e-7 || double.IsNaN(at)) break;
                if (at < 0 == low < 0) (from, low) = (t, at);
                else (to, high) = (t, at);
            }
            if (t > 0.001 && t < 0.999) return Vec3.Lerp(part[a], part[b], t);
        }
        return Vec3.Lerp(part[a], part[b], 0.5);
    }
}

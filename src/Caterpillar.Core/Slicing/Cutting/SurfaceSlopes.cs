namespace Caterpillar.Slicing;

/// <summary>
/// How shallow the surface of a mesh is at each height, for layers whose steps (cusps) stay below a limit: thickness · |cos of the angle between normal and Z|
/// ≤ cusp (Dolenc and Mäkelä, "Slicing procedures for layered manufacturing techniques", 1994), or for layers that are thinner than usual only where it
/// rises by less than 26°: thickness ≤ 1.44 · usual · √(rise / run), as in PrusaSlicer, which follows Wasserfall et al., "Adaptive slicing for the FDM
/// process revisited", 2017. Layers are to end at level facets, which have no cusp.
/// </summary>
internal sealed class SurfaceSlopes
{
    private const double Bin = 0.01;
    private const double Least = 1e-3;
    private const double Rise = 1.44;
    private readonly double _low;
    private readonly double[] _cosine;
    private readonly double[] _levels;

    public SurfaceSlopes(TriMesh mesh)
    {
        var bounds = mesh.Bounds;
        _low = bounds.Min.Z;
        var bins = (int)Math.Min(4_000_000, Math.Ceiling((bounds.Max.Z - _low) / Bin) + 1);
        var doubled = new List<double[]> { new double[bins] };
        for (var span = 2; span <= bins; span *= 2) doubled.Add(new double[bins]);
        var levels = new SortedSet<double>();
        for (var t = 0; t < mesh.TriangleCount; t++) Add(mesh, t, bins, doubled, levels);
        // What holds for 2^k bins holds for both halves of them.
        for (var k = doubled.Count - 1; k > 0; k--)
        {
            for (var i = 0; i + (1 << k) <= bins; i++)
            {
                doubled[k - 1][i] = Math.Max(doubled[k - 1][i], doubled[k][i]);
                doubled[k - 1][i + (1 << (k - 1))] = Math.Max(doubled[k - 1][i + (1 << (k - 1))], doubled[k][i]);
            }
        }
        _cosine = doubled[0];
        _levels = new double[levels.Count];
        levels.CopyTo(_levels);
    }

    /// <summary>The thickness of a layer that begins at a height, mm.</summary>
    /// <param name="z">The height.</param>
    /// <param name="min">The least.</param>
    /// <param name="max">The most.</param>
    /// <param name="cusp">The limit of cusps, or 0 for layers by the rise alone.</param>
    /// <param name="usual">Thickness of layers that are not adaptive.</param>
    public double Thickness(double z, double min, double max, double cusp, double usual)
    {
        var thickness = max;
        // The layer grows bin by bin until the steepest limit within it is reached.
        for (var at = Math.Max(0, (int)Math.Floor((z - _low) / Bin)); at < _cosine.Length && _low + at * Bin < z + thickness; at++)
        {
            var cosine = Math.Max(Least, _cosine[at]);
            var limit = cusp > 0 ? cusp / cosine : Rise * usual * Math.Sqrt(Math.Sqrt(Math.Max(0, 1 - cosine * cosine)) / cosine);
            if (limit < thickness) thickness = Math.Max(limit, Math.Min(thickness, _low + at * Bin - z));
        }
        thickness = Math.Max(min, Math.Floor(thickness * 1000 + 1e-6) / 1000);
        // Up to a level facet, in as many layers as it takes.
        var next = Array.BinarySearch(_levels, z + Least);
        next = next < 0 ? ~next : next;
        if (next == _levels.Length) return thickness;
        var rest = _levels[next] - z;
        if (rest > 2 * thickness || rest < min) return thickness;
        return rest <= thickness * (1 + 1e-9) ? rest : Math.Max(min, rest / 2);
    }

    private void Add(TriMesh mesh, int t, int bins, List<double[]> doubled, SortedSet<double> levels)
    {
        var (i, j, l) = mesh.Triangle(t);
        Vec3 a = mesh.Vertices[i], b = mesh.Vertices[j], c = mesh.Vertices[l];
        var normal = Vec3.Cross(b - a, c - a);
        var length = normal.Length;
        if (!(length > 0)) return;
        double low = Math.Min(a.Z, Math.Min(b.Z, c.Z)), high = Math.Max(a.Z, Math.Max(b.Z, c.Z));
        if (high - low < 1e-4)
        {
            levels.Add(Math.Floor(low * 1e4 + 0.5) / 1e4);
            return;
        }
        var cosine = Math.Abs(normal.Z) / length;
        var first = Math.Min(bins - 1, (int)((low - _low) / Bin));
        var last = Math.Min(bins - 1, (int)((high - _low) / Bin));
        var k = 0;
        while (2 << k <= last - first + 1) k++;
        doubled[k][first] = Math.Max(doubled[k][first], cosine);
        doubled[k][last - (1 << k) + 1] = Math.Max(doubled[k][last - (1 << k) + 1], cosine);
    }
}

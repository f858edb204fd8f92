namespace Caterpillar.Curved;

/// <summary>A place of a face that should lie in one layer.</summary>
/// <param name="Node">The node of the grid.</param>
/// <param name="Height">mm.</param>
/// <param name="ByX">How the height changes with x.</param>
/// <param name="ByY">How the height changes with y.</param>
/// <param name="Visible">True if it is seen from above.</param>
internal readonly record struct TopSample(int Node, double Height, double ByX, double ByY, bool Visible)
{
    /// <summary>Tangent of the slope.</summary>
    public double Slope => Math.Sqrt(ByX * ByX + ByY * ByY);
}

/// <summary>The tops of a part that slope gently, and its level bottoms, at the nodes of a grid, in connected pieces.</summary>
internal sealed class TopSamples
{
    /// <summary>Tangent of the slope up to which a face counts as level.</summary>
    public const double LevelSlope = 0.005;
    private readonly SlopeGrid _grid;
    private readonly double _steepest;
    private readonly List<TopSample> _samples = [];

    // The first sample of each node.
    private readonly int[] _firsts;
    private readonly DisjointSets _pieces;

    /// <param name="meshes">The part.</param>
    /// <param name="grid">The nodes.</param>
    /// <param name="steepest">Tangent of the steepest slope.</param>
    public TopSamples(IReadOnlyList<TriMesh> meshes, SlopeGrid grid, double steepest)
    {
        (_grid, _steepest, _firsts) = (grid, steepest, new int[grid.Count + 1]);
        var heights = meshes.Select(m => new MeshHeights(m)).ToArray();
        for (var node = 0; node < grid.Count; node++)
        {
            for (var m = 0; m < heights.Length; m++) Add(node, meshes[m], heights[m]);
            _firsts[node + 1] = _samples.Count;
        }
        _pieces = new DisjointSets(_samples.Count);
        for (var node = 0; node < grid.Count; node++)
        {
            if (node % grid.Columns > 0) Join(node - 1, node);
            if (node >= grid.Columns) Join(node - grid.Columns, node);
        }
    }

    public IReadOnlyList<TopSample> All => _samples;

    /// <summary>Samples of the same piece have the same number, which is that of one of them.</summary>
    public int PieceOf(int sample) => _pieces.Of(sample);

    /// <summary>
    /// The nodes of samples and those around them, where the faces go on beyond their edges, so that they are exact up to there.
    /// </summary>
    public IEnumerable<(int Node, double Height)> WithEdges(IReadOnlyList<int> samples)
    {
        var taken = new HashSet<int>(samples.Select(s => _samples[s].Node));
        foreach (var s in samples) yield return (_samples[s].Node, _samples[s].Height);
        foreach (var s in samples)
        {
            var sample = _samples[s];
            for (var k = 0; k < 9; k++)
            {
                int dx = k % 3 - 1, dy = k / 3 - 1, node = sample.Node + dy * _grid.Columns + dx;
                var height = sample.Height + _grid.Cell * (dx * sample.ByX + dy * sample.ByY);
                if (taken.Contains(node) || GoesOn(node, height)) continue;
                taken.Add(node);
                yield return (node, height);
            }
        }
    }

    private bool GoesOn(int node, double height)
    {
        for (var s = _firsts[node]; s < _firsts[node + 1]; s++)
        {
            if (Math.Abs(_samples[s].Height - height) < 2 * _steepest * _grid.Cell) return true;
        }
        return false;
    }

    private void Add(int node, TriMesh mesh, MeshHeights heights)
    {
        var at = _grid.At(node);
        var visible = true;
        for (var z = heights.TopUnder(at.X, at.Y, double.PositiveInfinity, out var t); t >= 0; z = heights.TopUnder(at.X, at.Y, z - 1e-6, out t))
        {
            var normal = mesh.Normal(t);
            var sample = new TopSample(node, z, -normal.X / normal.Z, -normal.Y / normal.Z, visible);
            if (normal.Z > 0 ? sample.Slope <= _steepest : sample.Slope <= LevelSlope) _samples.Add(sample);
            visible = false;
        }
    }

    private void Join(int before, int node)
    {
        for (var a = _firsts[before]; a < _firsts[before + 1]; a++)
        {
            for (var b = _firsts[node]; b < _firsts[node + 1]; b++)
            {
                if (Math.Abs(_samples[a].Height - _samples[b].Height) <= 1.05 * _steepest * _grid.Cell) _pieces.Join(a, b);
            }
        }
    }
}

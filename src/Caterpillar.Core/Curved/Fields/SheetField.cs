namespace Caterpillar.Curved;

/// <summary>
/// Layers of a surface that is printed as single walls: values at the vertices of its mesh. Their level curves are the walls, which may overhang and lie over
/// each other. Elsewhere the nearest point of the mesh counts.
/// </summary>
internal sealed class SheetField : LayerField
{
    private readonly MeshDistance _nearest;

    // Corners of the faces on which values rise, without those that are boundaries.
    private readonly int[] _corners;

    // Of each vertex: the gradient along the surface, and how fast values change; around folds gradients turn, and their mean is shorter.
    private readonly Vec3[] _gradients;
    private readonly double[] _slopes;

    // Of the mesh for which the field was made; null for others.
    private readonly MeshBoundaries? _boundaries;

    /// <param name="boundaries">The mesh and its boundaries.</param>
    /// <param name="values">One for each vertex of the fine mesh.</param>
    /// <param name="levels">Values of the layers, ascending from 0 at the lower boundary.</param>
    public SheetField(MeshBoundaries boundaries, double[] values, double[] levels) : this(boundaries.Mesh, values, levels) => _boundaries = boundaries;

    private SheetField(TriMesh mesh, double[] values, double[] levels)
    {
        (Mesh, Values, Levels) = (mesh, values, levels);
        _gradients = new Vec3[values.Length];
        _slopes = new double[values.Length];
        var areas = new double[values.Length];
        var corners = new List<int>();
        for (var t = 0; t < Mesh.RawTriangles.Length; t += 3)
        {
            if (SurfaceSlope.Gradient(Mesh, values, t, out var area) is not { } gradient) continue;
            WallLength += gradient.Length * area / (levels[levels.Length - 1] - levels[levels.Length - 2]);
            for (var k = 0; k < 3; k++)
            {
                var vertex = Mesh.RawTriangles[t + k];
                corners.Add(vertex);
                _gradients[vertex] += gradient * area;
                _slopes[vertex] += gradient.Length * area;
                areas[vertex] += area;
            }
        }
        for (var i = 0; i < areas.Length; i++) _slopes[i] /= areas[i];
        _corners = corners.ToArray();
        _nearest = new MeshDistance(TriMesh.Own(Mesh.RawVertices, _corners));
    }

    public override bool StartsLevel => _boundaries?.StartLevel == true;

    public TriMesh Mesh { get; }

    public double[] Values { get; }

    public double[] Levels { get; }

    /// <summary>Length of the level curves of all layers, about, mm.</summary>
    public double WallLength { get; }

    /// <summary>How fast values change at each vertex, per mm.</summary>
    public IReadOnlyList<double> Slopes => _slopes;

    internal override SheetField Sheet => this;

    internal override Func<Vec3, Vec3> Side => point => _nearest.Nearest(point).Normal;

    public override double Value(Vec3 point) => Mixed(_nearest.Nearest(point), Values);

    public override Vec3 Normal(Vec3 point) => Slope(point).Direction;

    internal override (SheetField Field, Vec3 Shift)? SheetOf(TriMesh mesh)
    {
        if (_boundaries is null || _boundaries.IsOf(mesh)) return (this, Vec3.Zero);
        var fine = MeshBoundaries.Fine(mesh);
        return (new SheetField(fine, Array.ConvertAll(fine.RawVertices, Value), Levels), Vec3.Zero);
    }

    /// <summary>The direction along the surface in which values rise, and by how much, per mm.</summary>
    public (Vec3 Direction, double Slope) Slope(Vec3 point)
    {
        var place = _nearest.Nearest(point);
        var corner = 3 * place.Triangle;
        var (a, b, c) = (_corners[corner], _corners[corner + 1], _corners[corner + 2]);
        var direction = _gradients[a].Unit() * place.Weights.X + _gradients[b].Unit() * place.Weights.Y + _gradients[c].Unit() * place.Weights.Z;
        return (direction.Unit(), Mixed(place, _slopes));
    }

    /// <summary>Height between the lowest and the highest point of a layer, at most, mm.</summary>
    public double Rise()
    {
        var ranges = new Dictionary<int, (double Low, double High)>();
        for (var i = 0; i < Values.Length; i++)
        {
            var layer = Array.BinarySearch(Levels, Values[i]);
            if (layer < 0) layer = ~layer;
            var z = Mesh.RawVertices[i].Z;
            ranges[layer] = ranges.TryGetValue(layer, out var range) ? (Math.Min(range.Low, z), Math.Max(range.High, z)) : (z, z);
        }
        return ranges.Values.Max(r => r.High - r.Low);
    }

    /// <summary>Reports places where walls rise away from the tool.</summary>
    /// <param name="tilt">Maximum tilt of the tool, degrees.</param>
    /// <param name="partial">Whether what cannot be printed is left out.</param>
    /// <param name="problems">Receives the problem.</param>
    public void CheckTool(double tilt, bool partial, DiagnosticList problems)
    {
        if (new SurfaceSlope(Mesh, Values).Falling(tilt, out var place) is not (> 0.01 and var share)) return;
        problems.Add(partial ? Severity.Warning : Severity.Error, "curved.overhanging_layers",
            $"Layers overhang or fold back on {NumberFormatter.Format(share * 100, 1)} % of the surface, most at {place}. "
                + (tilt > 0 ? "The tool must tilt farther (--max-tilt)." : "A printer with rotary axes that tilts its tool can print them."));
    }

    private double Mixed(NearestOnMesh place, double[] values)
    {
        var corner = 3 * place.Triangle;
        return values[_corners[corner]] * place.Weights.X + values[_corners[corner + 1]] * place.Weights.Y + values[_corners[corner + 2]] * place.Weights.Z;
    }
}

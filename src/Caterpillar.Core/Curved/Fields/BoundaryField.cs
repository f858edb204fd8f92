namespace Caterpillar.Curved;

/// <summary>
/// Layers between boundaries of a mesh. On its surface the field is linear in each triangle, so its level curves are the walls; inside of them a layer spans
/// its walls.
/// </summary>
/// <param name="boundaries">The boundaries.</param>
/// <param name="values">Of each vertex, from 0 at the lower boundary to the height at the upper one.</param>
/// <param name="height">Value at the upper boundary.</param>
/// <param name="levels">Values of the level curves that are spanned.</param>
internal sealed class BoundaryField(MeshBoundaries boundaries, double[] values, double height, Func<double[]> levels) : LayerField
{
    private readonly Lazy<SpanGrid> _grid = new(() => SpanGrid.Of(boundaries.Mesh, values, levels()));

    public override double Detail => 1;

    public override bool StartsLevel => boundaries.StartLevel;

    /// <summary>A field of values from 0 at the lower boundary to 1 at the upper one.</summary>
    public static LayerField Of(MeshBoundaries boundaries, double[] shares)
    {
        var mesh = boundaries.Mesh;
        // Nine tenths of the surface have layers no thicker than asked for; near branchings they are thicker, and may be divided.
        var height = new SurfaceSlope(mesh, shares).Thickness(0.9);
        var values = Array.ConvertAll(shares, s => s * height);
        return new BoundaryField(boundaries, values, height, () => Even(0, height, 100));
    }

    public static double[] HarmonicShares(MeshBoundaries boundaries, CancellationToken cancel)
    {
        var given = new double[boundaries.Mesh.VertexCount];
        for (var i = 0; i < given.Length; i++) given[i] = double.NaN;
        foreach (var v in boundaries.Lower) given[v] = 0;
        foreach (var v in boundaries.Upper) given[v] = 1;
        return HarmonicValues.Solve(boundaries.Mesh, given, cancel);
    }

    public static double[] GeodesicShares(MeshBoundaries boundaries, CancellationToken cancel)
    {
        var low = GeodesicDistance.From(boundaries.Mesh, boundaries.Lower, cancel);
        var high = GeodesicDistance.From(boundaries.Mesh, boundaries.Upper, cancel);
        return low.Select((d, v) => d / (d + high[v])).ToArray();
    }

    public override double Value(Vec3 point) => _grid.Value.Level(point);

    public override double Height(double x, double y, double value) => _grid.Value.Height(x, y, value);

    public override Vec3 Normal(Vec3 point)
    {
        var (grid, step) = (_grid.Value, _grid.Value.Cell / 2);
        var level = grid.Level(point);
        var byX = (grid.Height(point.X + step, point.Y, level) - grid.Height(point.X - step, point.Y, level)) / (2 * step);
        var byY = (grid.Height(point.X, point.Y + step, level) - grid.Height(point.X, point.Y - step, level)) / (2 * step);
        return new Vec3(-byX, -byY, 1).Unit();
    }

    internal override double Span(Vec3 step) => step.LengthXY;

    internal override TriMesh? FlatMesh(TriMesh mesh)
    {
        if (!boundaries.IsOf(mesh)) return null;
        return TriMesh.Own(boundaries.Mesh.RawVertices.Select((p, i) => p.WithZ(values[i])).ToArray(), boundaries.Mesh.RawTriangles);
    }

    internal override LayerField FitTo(PartColumns part, PrintSettings settings, DiagnosticList problems)
    {
        var first = settings.FirstLayerHeight;
        var layers = Math.Max(1, (int)Math.Ceiling((height - first) / settings.LayerHeight - 1e-6));
        var whole = first + layers * settings.LayerHeight;
        var fitted = Array.ConvertAll(values, v => v * whole / height);
        if (settings.OpenContours == OpenContours.Surface) return new SheetField(boundaries, fitted, [0, .. Even(first, whole, layers)]);
        if (new SurfaceSlope(boundaries.Mesh, values).Falling(0, out var place) is > 0.01 and var share)
        {
            // Small places where branches meet do little harm.
            var most = share > 0.05;
            problems.Add(most ? Severity.Error : Severity.Warning, "curved.overhanging_layers",
                $"Layers overhang or fold back on {NumberFormatter.Format(share * 100, 1)} % of the part's surface, most at {place}. "
                + (most ? "Solid layers must rise everywhere. Rotate the model, choose other ends, or print its surface as single walls with a tool that tilts "
                    + "(open_contours=surface)." : "They cannot be printed well."));
            if (most) return this;
        }
        return new BoundaryField(boundaries, fitted, whole, () => [0, .. Even(first, whole, layers)]);
    }

    private static double[] Even(double from, double to, int parts)
    {
        var result = new double[parts + 1];
        for (var i = 0; i <= parts; i++) result[i] = from + (to - from) * i / parts;
        return result;
    }
}

namespace Caterpillar.Curved;

/// <summary>
/// Level layers that bend where gently sloped tops lie in a layer instead of in steps (as in CurviSlicer, Etienne and others 2019). The heights of each layer
/// are given at the nodes of a grid, bilinear between them, and between layers linear along Z.
/// </summary>
internal sealed class SmoothField : LayerField
{
    // Heights in all columns of nodes together.
    private const double MostHeights = 6e6;

    // Degrees: steeper tops hardly show steps.
    private const double SteepestTop = 45;

    // Degrees: more than what steps between nodes add to a slope, and what beads and the tip of the nozzle need where a slope begins.
    private const double Margin = 1.5;

    // Of the layer height: as much may outer walls differ from a slope that they run across, if they are as wide as this share of the nozzle at least.
    private const double WallStep = 0.4;
    private const double NarrowestWall = 0.875;
    private readonly SlopeGrid _grid;
    private readonly LayerRules _rules;
    private readonly int _layers;
    private readonly double _angle;
    private readonly double _wall;

    // Of the layers from the bed up, node by node.
    private readonly double[] _heights;

    public SmoothField(SlopeGrid grid, LayerRules rules, IReadOnlyList<FixedLayer> given, int layers, double angle, double wall)
    {
        (_grid, _rules, _layers, _angle, _wall) = (grid, rules, layers, angle, wall);
        _heights = new double[grid.Count * (layers + 1)];
        double[] upper = new double[layers + 1], lower = new double[layers + 1];
        for (var node = 0; node < grid.Count; node++)
        {
            for (var k = 0; k <= layers; k++) (upper[k], lower[k]) = (double.PositiveInfinity, double.NegativeInfinity);
            (upper[1], lower[1]) = (rules.First, rules.First);
            foreach (var layer in given)
            {
                upper[layer.Number] = Math.Min(upper[layer.Number], layer.Upper[node]);
                lower[layer.Number] = Math.Max(lower[layer.Number], layer.Lower[node]);
            }
            for (var k = 2; k <= layers; k++)
            {
                upper[k] = Math.Min(upper[k], upper[k - 1] + rules.Most);
                lower[k] = Math.Max(lower[k], lower[k - 1] + rules.Least);
            }
            for (var k = layers - 1; k > 0; k--)
            {
                upper[k] = Math.Min(upper[k], upper[k + 1] - rules.Least);
                lower[k] = Math.Max(lower[k], lower[k + 1] - rules.Most);
            }
            for (var k = 1; k <= layers; k++)
                _heights[node * (layers + 1) + k] = Math.Min(Math.Max(rules.Height(k), lower[k]), upper[k]);
        }
    }

    public override double Detail => 2 * _grid.Cell;

    public override bool StartsLevel => true;

    /// <summary>The field for parts on the bed, or level layers where no top slopes gently.</summary>
    public static Result<LayerField> For(IReadOnlyList<NamedMesh> models, PrintSetup setup, CancellationToken cancel)
    {
        var problems = new DiagnosticList();
        var bounds = models.Aggregate(Bounds.Empty, (b, m) => b.Include(m.Mesh.Bounds));
        var settings = setup.Settings;
        var level = Vertical(PlanSurface.Level(0));
        if (bounds.IsEmpty) return new Result<LayerField>(level, []);
        var limit = HeadSlope.Limit(setup, bounds.Size.LengthXY, bounds.Size.Z);
        var (sin, cos) = Angle.SinCos(Math.Min(SteepestTop, Math.Max(0, limit - Margin)));
        var slope = sin / cos;
        // Thickness is measured across the layer.
        var most = Math.Max(LayerRules.GreatestGap(setup), settings.LayerHeight);
        var least = Math.Max(LayerRules.LeastGap(setup), settings.CurvedMaxGapRatio > 0 ? most / settings.CurvedMaxGapRatio : 0);
        var rules = new LayerRules(settings.FirstLayerHeight, settings.LayerHeight, Math.Min(least / cos, settings.LayerHeight), most, slope);
        var grid = SlopeGrid.Over(bounds, Math.Min(40_000, MostHeights / (bounds.Max.Z / settings.LayerHeight + 2)));
        var samples = new TopSamples(models.Select(m => m.Mesh).ToArray(), grid, slope);
        var plan = new SmoothPlan(samples, grid, rules);
        plan.Run(cancel);
        Tell(plan, samples, grid, rules, problems);
        if (plan.Steepest == 0) return new Result<LayerField>(level, problems.ToList());
        var given = Gentler(plan, grid, ref rules);
        for (var share = 0.05; share < 0.99; share += 0.05)
        {
            if (!IsPossible(given, rules.With(share))) continue;
            rules = rules.With(share);
            break;
        }
        var wall = Math.Max(NarrowestWall * setup.Printer.NozzleDiameter, WallStep * settings.LayerHeight / plan.Steepest);
        var layers = Math.Max(given[given.Count - 1].Number, 1 + rules.Fewest(bounds.Max.Z)) + 1;
        return new Result<LayerField>(new SmoothField(grid, rules, given, layers, plan.Angle, wall), problems.ToList());
    }

    public override double Value(Vec3 point)
    {
        if (!(point.Z > 0)) return point.Z;
        var place = _grid.Locate(point.X, point.Y);
        var k = (int)Math.Min(_layers - 1, Math.Max(0, (point.Z - _rules.First) / _rules.Usual + 1));
        double low = At(place, k), high = At(place, k + 1);
        while (point.Z > high && k < _layers - 1) (k, low, high) = (k + 1, high, At(place, k + 2));
        while (point.Z < low && k > 0) (k, low, high) = (k - 1, At(place, k - 1), low);
        var thickness = _rules.Height(k + 1) - _rules.Height(k);
        return point.Z > high ? _rules.Height(k + 1) + point.Z - high : _rules.Height(k) + thickness * (point.Z - low) / (high - low);
    }

    public override double Height(double x, double y, double value) => HeightAt(_grid.Locate(x, y), value);

    // No two places of a layer differ by more than the slope allows; only in the corners of cells it may seem so.
    public override Vec3 Normal(Vec3 point)
    {
        var (value, step) = (Value(point), _grid.Cell);
        var byX = Height(point.X + step, point.Y, value) - Height(point.X - step, point.Y, value);
        var byY = Height(point.X, point.Y + step, value) - Height(point.X, point.Y - step, value);
        return new Vec3(-byX, -byY, Math.Max(2 * step, Math.Sqrt(byX * byX + byY * byY) / (_rules.Slope * SlopeGrid.Detour))).Unit();
    }

    internal override (double First, double Second) Heights(double x, double y, double first, double second)
    {
        var place = _grid.Locate(x, y);
        return (HeightAt(place, first), HeightAt(place, second));
    }

    internal override double Spread(Vec3 point)
    {
        const double Step = 0.01;
        return 2 * Step / (Value(point + new Vec3(0, 0, Step)) - Value(point - new Vec3(0, 0, Step)));
    }

    // Walls across a slope are steps themselves.
    internal override PrintSettings Suited(PrintSettings settings)
    {
        settings = settings with { OnlyOneWallTop = true };
        if (settings.SolidInfillAngle == new PrintSettings().SolidInfillAngle) settings = settings with { SolidInfillAngle = _angle };
        return settings.OuterWallLineWidth == 0 && _wall < settings.LineWidth ? settings with { OuterWallLineWidth = _wall } : settings;
    }

    private double HeightAt((int Node, double U, double V) place, double value)
    {
        if (!(value > 0)) return value;
        var k = value < _rules.First ? 0 : (int)Math.Min(_layers - 1, (value - _rules.First) / _rules.Usual + 1);
        double from = _rules.Height(k), to = _rules.Height(k + 1), low = At(place, k), high = At(place, k + 1);
        return value > to ? high + value - to : low + (high - low) * (value - from) / (to - from);
    }

    private double At((int Node, double U, double V) place, int layer)
    {
        int stride = _layers + 1, at = place.Node * stride + layer, next = at + _grid.Columns * stride;
        var near = _heights[at] + (_heights[at + stride] - _heights[at]) * place.U;
        var far = _heights[next] + (_heights[next + stride] - _heights[next]) * place.U;
        return near + (far - near) * place.V;
    }

    // Layers turn to the faces no faster than they must.
    private static IReadOnlyList<FixedLayer> Gentler(SmoothPlan plan, SlopeGrid grid, ref LayerRules rules)
    {
        var gentle = rules with { Slope = Math.Min(rules.Slope, 1.05 * plan.Steepest) };
        var given = plan.Layers.Select(l => FixedLayer.Of(l.Number, l.Places, grid, gentle.Slope)).ToArray();
        for (var i = 0; i < given.Length; i++)
        {
            if (given[i].Places.Count < plan.Layers[i].Places.Count) return plan.Layers;
        }
        if (!IsPossible(given, gentle)) return plan.Layers;
        rules = gentle;
        return given;
    }

    // Whether layers reach all given heights.
    private static bool IsPossible(IReadOnlyList<FixedLayer> given, LayerRules rules)
    {
        foreach (var layer in given)
        {
            foreach (var (node, height) in layer.Places)
            {
                var (upper, lower) = (rules.First + rules.Upper(layer.Number - 1), rules.First + rules.Lower(layer.Number - 1));
                foreach (var other in given)
                {
                    upper = Math.Min(upper, other.Upper[node] + rules.Upper(layer.Number - other.Number));
                    lower = Math.Max(lower, other.Lower[node] + rules.Lower(layer.Number - other.Number));
                }
                if (height > upper + 1e-6 || height < lower - 1e-6) return false;
            }
        }
        return true;
    }

    private static void Tell(SmoothPlan plan, TopSamples samples, SlopeGrid grid, LayerRules rules, DiagnosticList problems)
    {
        if (plan.Steepest == 0 && plan.LeftOut.Count == 0)
            problems.Add(Severity.Note, "curved.smooth_level", "No top slopes gently: all layers are level.");
        if (plan.LeftOut.Count * grid.Cell * grid.Cell is not (>= 1 and var area)) return;
        var largest = plan.LeftOut.GroupBy(samples.PieceOf).OrderByDescending(g => g.Count()).ThenBy(g => g.Key).First().ToArray();
        var place = samples.All[largest[largest.Length / 2]];
        problems.Add(Severity.Note, "curved.smooth_left_out",
            $"{Text(area, 0)} mm² of sloped tops keep their steps, for example at {grid.At(place.Node).WithZ(place.Height)}: there layers would be thinner "
            + $"than {Text(rules.Least, 3)} mm, thicker than {Text(rules.Most, 3)} mm or too steep.");
    }

    private static string Text(double value, int decimals) => NumberFormatter.Format(value, decimals);
}

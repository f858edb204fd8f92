namespace Caterpillar.Slicing;

/// <summary>
/// A tower beside the models on which each tool prints first what its nozzle still holds of another material. It grows with the print up to the last tool
/// change: a wall, dense rows for each change, and what is left sparse. No layer of it is smaller than those above.
/// </summary>
internal sealed class PurgeTower
{
    // mm. Dense rows span this much between sparse lines below them.
    private const double SparseDistance = 5;

    // mm, and share of the height: less deep it would not stand.
    private const double LeastDepth = 5;
    private const double LeastShare = 0.15;

    private readonly PrintSettings _settings;
    private readonly Dictionary<double, SliceRules> _rules = [];
    private readonly List<Storey> _storeys = [];

    private PurgeTower(PrintSettings settings) => _settings = settings;

    /// <summary>Adds the layers of the tower to the turns, if tools purge.</summary>
    /// <param name="levels">The turns of each height.</param>
    /// <param name="settings">The settings of the print.</param>
    /// <param name="printer">The printer.</param>
    /// <exception cref="DiagnosticException">There is no place for the tower, or it cannot grow.</exception>
    public static void Add(IReadOnlyList<ToolTurn[]> levels, PrintSettings settings, Printer printer)
    {
        var tower = new PurgeTower(settings);
        tower.Plan(levels);
        if (tower._storeys.Count == 0) return;
        var objects = levels.SelectMany(l => l).SelectMany(t => t.Layers).GroupBy(l => l.Layer.Object, StringComparer.Ordinal);
        var obstacles = objects.Select(o => o.Aggregate(Bounds.Empty, (box, l) => box.Include(l.Region.Bounds).Include(l.Support.Bounds)));
        var corner = TowerPlace.Find(tower._storeys[0].Depth, [.. obstacles.Select(Footprint.Of)], settings, printer);
        foreach (var storey in tower._storeys) tower.Print(storey, corner);
    }

    private void Plan(IReadOnlyList<ToolTurn[]> levels)
    {
        const double Rounding = 1e-6;
        var last = levels.Count - 1;
        while (last >= 0 && !Array.Exists(levels[last], t => t.Purge > 0)) last--;
        var z = 0.0;
        for (var i = 0; i <= last; i++)
        {
            var layer = levels[i][0].Layers[0].Layer;
            var (gap, most) = (layer.Z - z, Math.Max(layer.Thickness, _settings.LargerLayerHeight));
            var purges = Array.FindAll(levels[i], t => t.Purge > 0);
            // Between the layers of models with other heights it waits for the next one.
            if (purges.Length == 0 && gap < layer.Thickness - Rounding) continue;
            if (gap < layer.Thickness / 4)
                throw new DiagnosticException([new Diagnostic(Severity.Error, "slice.purge_tower", "Tools change at z = "
                    + $"{NumberFormatter.Format(layer.Z, 3)} mm, only {NumberFormatter.Format(gap, 3)} mm above the purge tower. "
                    + "Print all models with the same layer heights.")]);
            // Where it has waited, and beside the gap above a raft, it grows in several layers.
            var pieces = (int)Math.Ceiling(gap / most - Rounding);
            for (var k = 1; k <= pieces; k++)
            {
                var own = new Layer(layer.Index, k == pieces ? layer.Z : z + gap * k / pieces, gap / pieces, "");
                var purging = k == pieces && purges.Length > 0;
                _storeys.Add(new Storey(own, RulesOf(gap / pieces), purging ? purges : [levels[i][0]], purging));
            }
            z = layer.Z;
        }
        var depth = Math.Max(LeastDepth, LeastShare * z);
        for (var i = _storeys.Count - 1; i >= 0; i--)
        {
            var storey = _storeys[i];
            var rows = RowsOf(storey);
            if (storey.Purges) depth = Math.Max(depth, rows.DepthOf(storey.Visits.Sum(t => rows.CountFor(t.Purge))));
            storey.Depth = depth;
        }
    }

    private SliceRules RulesOf(double thickness)
    {
        thickness = Math.Round(thickness, 9);
        if (!_rules.TryGetValue(thickness, out var rules)) _rules.Add(thickness, rules = SliceRules.Of(_settings, thickness));
        return rules;
    }

    private TowerRows RowsOf(Storey storey) => new(storey.Rules, _settings.PurgeTowerWidth);

    private void Print(Storey storey, Vec3 corner)
    {
        var (rules, size) = (storey.Rules, RowsOf(storey));
        var (pitch, inset, half) = (size.Pitch, size.Inset, rules.Width / 2);
        var box = new Bounds(corner, corner + new Vec3(_settings.PurgeTowerWidth, storey.Depth));
        double left = box.Min.X + inset, right = box.Max.X - inset, y = box.Min.Y + half + pitch, rear = box.Max.Y - half - pitch;
        var isFirst = ReferenceEquals(storey, _storeys[0]);
        foreach (var turn in storey.Visits)
        {
            var paths = new List<(Vec3[] Points, bool Closed)>();
            if (isFirst && turn == storey.Visits[0]) paths.AddRange(Brim(box, rules));
            var rows = storey.Purges ? size.CountFor(turn.Purge) : 0;
            var ends = turn == storey.Visits[storey.Visits.Length - 1];
            // It stands on a closed layer.
            if (ends && isFirst) rows += Math.Max(0, (int)((rear - y) / pitch + 1 - rows + 1e-6));
            if (rows > 0) paths.Add((Zigzag(rows, y, pitch, left, right), false));
            y += rows * pitch;
            if (ends)
            {
                var gaps = (int)Math.Ceiling((right - left) / SparseDistance);
                if (rear - y > pitch) paths.Add((Upright(Zigzag(gaps + 1, left, (right - left) / gaps, y, rear)), false));
                paths.Add((Rectangle(box, -half), true));
            }
            // Layers of the tower come first, in their order; but a skirt before them.
            var place = isFirst && !turn.Changes ? turn.Layers.Count : turn.Layers.TakeWhile(l => l.Steps[0].Path.Role == Role.PrimeTower).Count();
            turn.Layers.Insert(place, LayerOf(storey, box, turn.Tool, paths));
        }
    }

    private static SlicedLayer LayerOf(Storey storey, Bounds box, int tool, List<(Vec3[] Points, bool Closed)> paths)
    {
        var region = Region.From([new Polyline(Rectangle(box, 0), true)]);
        var steps = new List<PathStep>();
        var bead = storey.Rules.Bead(storey.Rules.Width);
        foreach (var (points, closed) in paths)
        {
            var path = PrintPath.Own(Array.ConvertAll(points, p => p.WithZ(storey.Layer.Z)), [bead], closed).With(Role.PrimeTower, storey.Layer, tool);
            steps.Add(new PathStep(path, new StepGroup(0, 0, steps.Count)) { KeepStart = true, Region = region });
        }
        return new SlicedLayer(storey.Layer, region, steps);
    }

    private IEnumerable<(Vec3[] Points, bool Closed)> Brim(Bounds box, SliceRules rules)
    {
        var pitch = rules.Pitch(rules.Width);
        for (var loop = (int)Math.Round(_settings.PurgeTowerBrimWidth / pitch); loop > 0; loop--)
            yield return (Rectangle(box, loop * pitch - rules.Width / 2), true);
    }

    private static Vec3[] Rectangle(Bounds box, double grown)
    {
        var (min, max) = (box.Min - new Vec3(grown, grown), box.Max + new Vec3(grown, grown));
        return [min.WithZ(0), new Vec3(max.X, min.Y), max.WithZ(0), new Vec3(min.X, max.Y)];
    }

    // Rows along X, linked at their ends.
    private static Vec3[] Zigzag(int rows, double first, double distance, double from, double to)
    {
        var points = new Vec3[2 * rows];
        for (var k = 0; k < rows; k++)
        {
            var isEven = k % 2 == 0;
            points[2 * k] = new Vec3(isEven ? from : to, first + k * distance);
            points[2 * k + 1] = new Vec3(isEven ? to : from, first + k * distance);
        }
        return points;
    }

    private static Vec3[] Upright(Vec3[] points) => Array.ConvertAll(points, p => new Vec3(p.Y, p.X));

    // A layer of the tower, and the turns that print it.
    private sealed class Storey(Layer layer, SliceRules rules, ToolTurn[] visits, bool purges)
    {
        public Layer Layer { get; } = layer;

        public SliceRules Rules { get; } = rules;

        public ToolTurn[] Visits { get; } = visits;

        public bool Purges { get; } = purges;

        public double Depth { get; set; }
    }
}

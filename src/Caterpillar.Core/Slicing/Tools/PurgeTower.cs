namespace Caterpillar.Slicing;

/// <summary>
/// A tower beside the models on which each tool prints first what its nozzle still holds of another material. It grows with the print up to the last tool
/// change: a wall, dense rows for each change, and sparse lines in the rest.
/// </summary>
internal sealed class PurgeTower(Bounds box, double brim)
{
    // mm. Dense rows span this much between sparse lines below them.
    private const double SparseDistance = 5;

    // mm, and share of the height: less deep it would not stand.
    private const double LeastDepth = 5;
    private const double LeastShare = 0.15;

    /// <summary>Adds the layers of the tower to the turns of each height, if tools purge.</summary>
    /// <exception cref="DiagnosticException">There is no place for the tower, or it cannot grow.</exception>
    public static void Add(List<ToolTurn[]> levels, PrintSettings settings, Printer printer)
    {
        var last = levels.FindLastIndex(l => Array.Exists(l, t => t.Purge > 0));
        var storeys = Storeys(levels.Take(last + 1), settings).ToArray();
        if (storeys.Length == 0) return;
        var depth = Math.Max(LeastDepth, LeastShare * storeys[storeys.Length - 1].Layer.Z);
        depth = Math.Max(depth, storeys.Max(s => s.Rules.Width + s.Pitch * (1 + s.Visits.Sum(t => s.RowsFor(t, settings.PurgeTowerWidth)))));
        var objects = levels.SelectMany(l => l).SelectMany(t => t.Layers).GroupBy(l => l.Layer.Object, StringComparer.Ordinal);
        var obstacles = objects.Select(o => o.Aggregate(Bounds.Empty, (all, l) => all.Include(l.Region.Bounds).Include(l.Support.Bounds)));
        var tower = new PurgeTower(TowerPlace.Find(depth, [.. obstacles.Select(Footprint.Of)], settings, printer), settings.PurgeTowerBrimWidth);
        foreach (var storey in storeys) tower.Print(storey, storey == storeys[0]);
    }

    private static IEnumerable<Storey> Storeys(IEnumerable<ToolTurn[]> levels, PrintSettings settings)
    {
        const double Rounding = 1e-6;
        var z = 0.0;
        foreach (var level in levels)
        {
            var layer = level[0].Layers[0].Layer;
            var (gap, most) = (layer.Z - z, Math.Max(layer.Thickness, settings.LargerLayerHeight));
            var purges = Array.FindAll(level, t => t.Purge > 0);
            // Between the layers of models with other heights it waits for the next one.
            if (purges.Length == 0 && gap < layer.Thickness - Rounding) continue;
            if (gap < layer.Thickness / 4)
            {
                var place = $"z = {NumberFormatter.Format(layer.Z, 3)} mm, only {NumberFormatter.Format(gap, 3)} mm above the purge tower";
                throw TowerPlace.Problem($"Tools change at {place}. Print all models with the same layer heights.");
            }
            // Where it has waited, and beside the gap above a raft, it grows in several layers.
            var pieces = (int)Math.Ceiling(gap / most - Rounding);
            for (var k = 1; k <= pieces; k++)
            {
                var isTop = k == pieces && purges.Length > 0;
                var own = new Layer(layer.Index, k == pieces ? layer.Z : z + gap * k / pieces, gap / pieces, "");
                yield return new Storey(own, SliceRules.Of(settings, gap / pieces), isTop ? purges : [level[0]], isTop);
            }
            z = layer.Z;
        }
    }

    private void Print(Storey storey, bool isFirst)
    {
        var (pitch, half) = (storey.Pitch, storey.Rules.Width / 2);
        double left = box.Min.X + storey.Inset, right = box.Max.X - storey.Inset, y = box.Min.Y + half + pitch, rear = box.Max.Y - half - pitch;
        foreach (var turn in storey.Visits)
        {
            var paths = new List<PrintPath>();
            void Add(Vec3[] points, bool closed) => paths.Add(PrintPath.Own(
                Array.ConvertAll(points, p => p.WithZ(storey.Layer.Z)), [storey.Rules.Bead(storey.Rules.Width)], closed));

            var loops = isFirst && turn == storey.Visits[0] ? (int)Math.Round(brim / pitch) : 0;
            for (; loops > 0; loops--) Add(Rectangle(loops * pitch - half), true);
            var rows = storey.RowsFor(turn, box.Size.X);
            var isLast = turn == storey.Visits[storey.Visits.Length - 1];
            // It stands on a closed layer.
            if (isLast && isFirst) rows = Math.Max(rows, (int)((rear - y) / pitch + 1 + 1e-6));
            if (rows > 0) Add(Zigzag(rows, y, pitch, left, right), false);
            y += rows * pitch;
            var gaps = (int)Math.Ceiling((right - left) / SparseDistance);
            if (isLast && rear - y > pitch) Add(Array.ConvertAll(Zigzag(gaps + 1, left, (right - left) / gaps, y, rear), p => new Vec3(p.Y, p.X)), false);
            if (isLast) Add(Rectangle(-half), true);
            var region = Region.From([new Polyline(Rectangle(0), true)]);
            var steps = paths.Select((p, i) => new PathStep(p with { Role = Role.PrimeTower, Layer = storey.Layer, Tool = turn.Tool }, new StepGroup(0, 0, i))
            {
                KeepStart = true, Region = region,
            });
            // Layers of the tower come first, in their order; but a skirt before them.
            var place = isFirst && !turn.Changes ? turn.Layers.Count : turn.Layers.TakeWhile(l => l.Steps[0].Path.Role == Role.PrimeTower).Count();
            turn.Layers.Insert(place, new SlicedLayer(storey.Layer, region, steps.ToArray()));
        }
    }

    private Vec3[] Rectangle(double grown)
    {
        var (min, max) = (box.Min - new Vec3(grown, grown), box.Max + new Vec3(grown, grown));
        return [min, new Vec3(max.X, min.Y), max, new Vec3(min.X, max.Y)];
    }

    // Rows along X, linked at their ends.
    private static Vec3[] Zigzag(int rows, double first, double distance, double from, double to)
    {
        var points = new Vec3[2 * rows];
        for (var k = 0; k < rows; k++)
        {
            points[2 * k] = new Vec3(k % 2 == 0 ? from : to, first + k * distance);
            points[2 * k + 1] = new Vec3(k % 2 == 0 ? to : from, first + k * distance);
        }
        return points;
    }

    // A layer of the tower, and the turns that print it.
    private sealed record Storey(Layer Layer, SliceRules Rules, ToolTurn[] Visits, bool Purges)
    {
        /// <summary>Distance between rows, and between the wall and the first one.</summary>
        public double Pitch => Rules.Pitch(Rules.Width);

        /// <summary>Distance of the ends of rows from the edge of the tower: closer to the wall than to each other.</summary>
        public double Inset => Rules.Width / 2 + 0.85 * Pitch;

        /// <summary>Number of rows for what a turn purges, with the links between their ends.</summary>
        public int RowsFor(ToolTurn turn, double width)
            => Purges ? Math.Max(1, (int)Math.Ceiling((turn.Purge / Rules.Bead(Rules.Width).Area + Pitch) / (width - 2 * Inset + Pitch) - 1e-9)) : 0;
    }
}

namespace Caterpillar.Curved;

/// <summary>A place of a patch in the grid of cells: the lowest and the highest point of its paths there, mm.</summary>
internal readonly record struct PatchCell(int Column, int Row, double Low, double Top);

/// <summary>A connected piece of a layer: its paths, and the cells in plan that they touch.</summary>
internal sealed class LayerPatch
{
    private LayerPatch(int layer, List<PathStep> steps, PatchCell[] cells)
    {
        (Layer, Steps, Cells) = (layer, steps, cells);
        Box = Bounds.Of(cells.SelectMany(c => new[] { new Vec3(c.Column, c.Row, c.Low), new Vec3(c.Column, c.Row, c.Top) }));
    }

    /// <summary>Its place among the layers.</summary>
    public int Layer { get; }

    public IReadOnlyList<PathStep> Steps { get; }

    public PatchCell[] Cells { get; }

    /// <summary>Its columns, its rows, and its heights, mm.</summary>
    public Bounds Box { get; }

    /// <summary>The patches of a layer, in the order of their first paths. Paths in cells that touch are of one patch.</summary>
    /// <param name="layer">The layer.</param>
    /// <param name="index">Its place among the layers.</param>
    /// <param name="cell">Side of the cells, mm.</param>
    public static IReadOnlyList<LayerPatch> Of(SlicedLayer layer, int index, double cell)
    {
        var numbers = new Dictionary<(int Column, int Row), int>();
        var cells = new List<PatchCell>();
        var sets = new DisjointSets(0);
        var firsts = new int[layer.Steps.Count];
        for (var s = 0; s < firsts.Length; s++)
        {
            var path = layer.Steps[s].Path;
            var before = firsts[s] = Enter(path.Start);
            for (var i = 0; i < path.SegmentCount; i++)
            {
                Vec3 from = path.RawPoints[i], to = path.EndOf(i);
                var parts = Math.Max(1, (int)Math.Ceiling((to - from).LengthXY / (0.5 * cell)));
                for (var k = 1; k <= parts; k++)
                {
                    var next = Enter(Vec3.Lerp(from, to, (double)k / parts));
                    sets.Join(before, next);
                    before = next;
                }
            }
        }
        for (var n = 0; n < cells.Count; n++)
        {
            var (column, row) = (cells[n].Column, cells[n].Row);
            foreach (var (dx, dy) in new[] { (1, 0), (0, 1), (1, 1), (1, -1) })
            {
                if (numbers.TryGetValue((column + dx, row + dy), out var other)) sets.Join(n, other);
            }
        }
        var patches = new List<LayerPatch>();
        foreach (var group in Enumerable.Range(0, firsts.Length).GroupBy(s => sets.Of(firsts[s])))
        {
            var own = cells.Where((_, n) => sets.Of(n) == group.Key).ToArray();
            patches.Add(new LayerPatch(index, group.Select(s => layer.Steps[s]).ToList(), own));
        }
        return patches;

        int Enter(Vec3 p)
        {
            var key = ((int)Math.Floor(p.X / cell), (int)Math.Floor(p.Y / cell));
            if (!numbers.TryGetValue(key, out var n))
            {
                numbers.Add(key, n = cells.Count);
                cells.Add(new PatchCell(key.Item1, key.Item2, p.Z, p.Z));
                sets.Add();
            }
            var old = cells[n];
            if (p.Z < old.Low || p.Z > old.Top) cells[n] = old with { Low = Math.Min(old.Low, p.Z), Top = Math.Max(old.Top, p.Z) };
            return n;
        }
    }
}

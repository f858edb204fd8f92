namespace Caterpillar.Curved;

/// <summary>A place of a patch in the grid of cells: the lowest and the highest point of its paths there, mm.</summary>
internal readonly record struct PatchCell(int Column, int Row, double Low, double Top);

/// <summary>A connected piece of a layer: its paths, and the cells in plan that they touch.</summary>
internal sealed class LayerPatch
{
    private LayerPatch(int layer, List<PathStep> steps, PatchCell[] cells)
    {
        (Layer, Steps, Cells) = (layer, steps, cells);
        foreach (var c in cells) Box = Box.Include(new Vec3(c.Column, c.Row, c.Low)).Include(new Vec3(c.Column, c.Row, c.Top));
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
        var box = layer.Steps.Aggregate(Bounds.Empty, (b, s) => b.Include(s.Path.Bounds));
        int left = Index(box.Min.X) - 1, bottom = Index(box.Min.Y) - 1, columns = Index(box.Max.X) - left + 2;
        // Numbers of cells by row, counted from 1; a column and a row on each side stay empty.
        var numbers = new int[columns * (Index(box.Max.Y) - bottom + 2)];
        int[] around = [-columns - 1, -columns, 1 - columns, -1, 1, columns - 1, columns, columns + 1];
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
                    var next = Enter(k == parts ? to : Vec3.Lerp(from, to, (double)k / parts));
                    sets.Join(before, next);
                    before = next;
                }
            }
        }
        var patches = new List<LayerPatch>();
        foreach (var group in Enumerable.Range(0, firsts.Length).GroupBy(s => sets.Of(firsts[s])))
        {
            var own = cells.Where((_, n) => sets.Of(n) == group.Key).ToArray();
            patches.Add(new LayerPatch(index, group.Select(s => layer.Steps[s]).ToList(), own));
        }
        return patches;

        int Index(double x) => (int)Math.Floor(x / cell);

        int Enter(Vec3 p)
        {
            int column = Index(p.X), row = Index(p.Y), at = (row - bottom) * columns + column - left;
            var n = numbers[at] - 1;
            if (n < 0)
            {
                n = cells.Count;
                numbers[at] = n + 1;
                cells.Add(new PatchCell(column, row, p.Z, p.Z));
                sets.Add();
                foreach (var away in around)
                {
                    if (numbers[at + away] > 0) sets.Join(n, numbers[at + away] - 1);
                }
            }
            var old = cells[n];
            if (p.Z < old.Low || p.Z > old.Top) cells[n] = old with { Low = Math.Min(old.Low, p.Z), Top = Math.Max(old.Top, p.Z) };
            return n;
        }
    }
}

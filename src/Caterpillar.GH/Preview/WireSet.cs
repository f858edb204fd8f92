namespace Caterpillar.GH.Preview;

/// <summary>Something that is drawn as lines.</summary>
internal interface IWires
{
    /// <summary>Bounds of the extrusions, mm.</summary>
    Bounds Bounds { get; }

    int SegmentCount { get; }

    /// <summary>Number of layers up to its last one. 0 without layers.</summary>
    int LayerCount { get; }

    /// <summary>Adds its lines, or some of them. <paramref name="first"/> is the number of its first segment among all that are drawn together.</summary>
    void AddTo(List<Rg.Line> lines, DocumentUnits units, Thinning thinning, int first);
}

/// <summary>Everything that one parameter shows, as lines for a single call and one box, made once for the units of the document.</summary>
internal sealed class WireSet(IReadOnlyList<IWires> items, DocumentUnits units)
{
    private Rg.Line[]? _lines;
    private Rg.BoundingBox? _box;

    public Rg.BoundingBox Box => _box ??= RhinoGeometry.ToBox(items.Aggregate(Bounds.Empty, (all, item) => all.Include(item.Bounds)), units);

    /// <summary>What is drawn if there is too much.</summary>
    public Thinning Thinning { get; } = Thinning.Of(items.Sum(i => (long)i.SegmentCount), items.Select(i => i.LayerCount).DefaultIfEmpty().Max());

    public bool Fits(DocumentUnits other) => other.ToMillimeters == units.ToMillimeters;

    public void Draw(DisplayPipeline display, Color color)
    {
        _lines ??= Lines();
        // An array is what the pipeline draws without a copy.
        if (_lines.Length > 0) display.DrawLines(_lines, color, 1);
    }

    private Rg.Line[] Lines()
    {
        var lines = new List<Rg.Line>();
        var first = 0;
        foreach (var item in items)
        {
            item.AddTo(lines, units, Thinning, first);
            first += item.SegmentCount;
        }
        return lines.ToArray();
    }
}

using System.Drawing;
using Caterpillar.Geometry;
using Caterpillar.GH.Conversion;
using Rhino.Display;

namespace Caterpillar.GH.Preview;

/// <summary>Something that is drawn as lines.</summary>
internal interface IWires
{
    /// <summary>Bounds of the extrusions, mm.</summary>
    Bounds Bounds { get; }

    int SegmentCount { get; }

    void AddTo(List<Rg.Line> lines, DocumentUnits units);
}

/// <summary>Everything that one parameter shows, as lines for a single call and one box, made once for the units of the document.</summary>
internal sealed class WireSet(IReadOnlyList<IWires> items, DocumentUnits units)
{
    /// <summary>Maximum number of segments to draw. With more, nothing is drawn.</summary>
    public const int MaxSegments = 1_000_000;

    private Rg.Line[]? _lines;
    private Rg.BoundingBox? _box;

    public Rg.BoundingBox Box => _box ??= RhinoGeometry.ToBox(items.Aggregate(Bounds.Empty, (all, item) => all.Include(item.Bounds)), units);

    public bool Fits(DocumentUnits other) => other.ToMillimeters == units.ToMillimeters;

    public void Draw(DisplayPipeline display, Color color)
    {
        _lines ??= Lines();
        // An array is what the pipeline draws without a copy.
        if (_lines.Length > 0) display.DrawLines(_lines, color, 1);
    }

    private Rg.Line[] Lines()
    {
        if (items.Sum(i => (long)i.SegmentCount) > MaxSegments) return [];
        var lines = new List<Rg.Line>();
        foreach (var item in items) item.AddTo(lines, units);
        return lines.ToArray();
    }
}

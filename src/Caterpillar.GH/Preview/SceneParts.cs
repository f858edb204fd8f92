namespace Caterpillar.GH.Preview;

/// <summary>The layers that are shown, by their numbers. Null = no limit.</summary>
internal sealed record ShownLayers(int? First, int? Last)
{
    /// <summary>Number of the layer of a move without a layer, which is shown if there are no limits.</summary>
    public const int None = int.MinValue;

    public bool Has(int layer) => (First is null && Last is null) || (layer != None && !(layer < First) && !(layer > Last));
}

/// <summary>What a preview of a toolpath chooses from, made once for a toolpath: another layer or color copies lines only.</summary>
internal sealed class SceneParts
{
    private readonly Dictionary<int, (Rg.BoundingBox Prints, Rg.BoundingBox Travels)> _boxes = [];

    public SceneParts(Toolpath toolpath, DocumentUnits units, CancellationToken cancel)
    {
        Lines = PrintedLines.Of(toolpath, units, cancel);
        Layers = new int[toolpath.Count];
        var travels = new List<(Rg.Line, int)>();
        var retractions = new List<(Rg.Point3d, int)>();
        var lines = new List<Rg.Line>();
        foreach (var move in toolpath.Moves())
        {
            if (move.Index % 65536 == 0) cancel.ThrowIfCancellationRequested();
            var layer = Layers[move.Index] = toolpath.NumberOfLayer(move) ?? ShownLayers.None;
            if (move.Kind == MoveKind.Print)
            {
                var boxes = BoxesOf(layer);
                boxes.Prints.Union(RhinoGeometry.ToBox(move.Bounds, units));
                _boxes[layer] = boxes;
            }
            else if (move.Kind is MoveKind.Travel or MoveKind.Wipe)
            {
                lines.Clear();
                RhinoGeometry.AddLines(lines, move.Start, move.End, move.Arc, units);
                travels.AddRange(lines.Select(line => (line, layer)));
                var boxes = BoxesOf(layer);
                boxes.Travels.Union(RhinoGeometry.ToBox(move.Bounds, units));
                _boxes[layer] = boxes;
            }
            else if (move.Kind == MoveKind.Retract)
            {
                retractions.Add((RhinoGeometry.ToPoint(move.End, units), layer));
            }
        }
        (Travels, Retractions) = (travels, retractions);
        // Where extrusions of walls begin.
        Seams = ToolpathExtrusions.Of(toolpath).Select(e => toolpath[e.First]).Where(m => m.Role is Role.OuterWall or Role.InnerWall)
            .Select(m => (RhinoGeometry.ToPoint(m.Start, units), Layers[m.Index])).ToArray();
    }

    /// <summary>The extrusions.</summary>
    public PrintedLines Lines { get; }

    /// <summary>Number of the layer of each move.</summary>
    public int[] Layers { get; }

    public int LayerCount => _boxes.Count;

    public IReadOnlyList<(Rg.Line Item, int Layer)> Travels { get; }

    public IReadOnlyList<(Rg.Point3d Item, int Layer)> Retractions { get; }

    public IReadOnlyList<(Rg.Point3d Item, int Layer)> Seams { get; }

    /// <summary>Those of the layers that are shown.</summary>
    public static T[] Shown<T>(IReadOnlyList<(T Item, int Layer)> all, ShownLayers layers) => all.Where(a => layers.Has(a.Layer)).Select(a => a.Item).ToArray();

    public Rg.BoundingBox BoxOf(ShownLayers layers, bool travels)
    {
        var box = Rg.BoundingBox.Empty;
        foreach (var layer in _boxes.Where(b => layers.Has(b.Key)))
        {
            box.Union(layer.Value.Prints);
            if (travels) box.Union(layer.Value.Travels);
        }
        return box;
    }

    private (Rg.BoundingBox Prints, Rg.BoundingBox Travels) BoxesOf(int layer)
        => _boxes.TryGetValue(layer, out var boxes) ? boxes : (Rg.BoundingBox.Empty, Rg.BoundingBox.Empty);
}

namespace Caterpillar.GH.Preview;

/// <summary>The layers that are shown, by their numbers. Null = no limit.</summary>
internal sealed record ShownLayers(int? First, int? Last)
{
    /// <summary>Number of the layer of a move without a layer, which is shown if there are no limits.</summary>
    public const int None = int.MinValue;

    public bool Has(int layer) => (First is null && Last is null) || (layer != None && !(layer < First) && !(layer > Last));
}

/// <summary>Lines of one role from moves that follow each other, and the move of each: one call where all have one color.</summary>
internal sealed record SceneBlock(Role Role, Rg.Line[] Lines, int[] Moves);

/// <summary>What a preview of a toolpath chooses from, made once for a toolpath: another layer or color copies few lines.</summary>
internal sealed class SceneParts
{
    private const int MostRanges = 64;
    private const int LeastRange = 16384;
    private readonly Dictionary<int, LayerBoxes> _boxes = [];
    private readonly List<SceneBlock> _blocks = [];
    private readonly List<(Rg.Line, int)> _travels = [];
    private readonly List<(Rg.Point3d, int)> _retractions = [];

    public SceneParts(Toolpath toolpath, DocumentUnits units, CancellationToken cancel)
    {
        Layers = new int[toolpath.Count];
        var range = Math.Max(LeastRange, toolpath.Count / MostRanges + 1);
        var roles = new SortedDictionary<Role, (List<Rg.Line> Lines, List<int> Moves)>();
        var (lines, moves) = (new List<Rg.Line>(), new List<int>());
        Role? role = null;
        LayerBoxes? boxes = null;
        foreach (var move in toolpath.Moves())
        {
            if (move.Index % range == 0)
            {
                cancel.ThrowIfCancellationRequested();
                Close(roles);
            }
            var layer = Layers[move.Index] = toolpath.NumberOfLayer(move) ?? ShownLayers.None;
            if (boxes is null || boxes.Layer != layer) boxes = BoxesOf(layer);
            if (move.Kind == MoveKind.Print)
            {
                if (role != move.Role) (lines, moves) = Of(roles, move.Role);
                role = move.Role;
                RhinoGeometry.AddLines(lines, move.Start, move.End, move.Arc, units);
                while (moves.Count < lines.Count) moves.Add(move.Index);
                boxes.Prints.Union(RhinoGeometry.ToBox(move.Bounds, units));
            }
            else if (move.Kind is MoveKind.Travel or MoveKind.Wipe)
            {
                var travel = new List<Rg.Line>();
                RhinoGeometry.AddLines(travel, move.Start, move.End, move.Arc, units);
                _travels.AddRange(travel.Select(line => (line, layer)));
                boxes.Travels.Union(RhinoGeometry.ToBox(move.Bounds, units));
            }
            else if (move.Kind == MoveKind.Retract)
            {
                _retractions.Add((RhinoGeometry.ToPoint(move.End, units), layer));
            }
        }
        Close(roles);
        // Where extrusions of walls begin.
        Seams = ToolpathExtrusions.Of(toolpath).Select(e => toolpath[e.First]).Where(m => m.Role is Role.OuterWall or Role.InnerWall)
            .Select(m => (RhinoGeometry.ToPoint(m.Start, units), Layers[m.Index])).ToArray();
    }

    /// <summary>The extrusions.</summary>
    public IReadOnlyList<SceneBlock> Blocks => _blocks;

    /// <summary>Number of the layer of each move.</summary>
    public int[] Layers { get; }

    public int LayerCount => _boxes.Count;

    public IReadOnlyList<(Rg.Line Item, int Layer)> Travels => _travels;

    public IReadOnlyList<(Rg.Point3d Item, int Layer)> Retractions => _retractions;

    public IReadOnlyList<(Rg.Point3d Item, int Layer)> Seams { get; }

    /// <summary>Those of the layers that are shown.</summary>
    public static T[] Shown<T>(IReadOnlyList<(T Item, int Layer)> all, ShownLayers layers) => all.Where(a => layers.Has(a.Layer)).Select(a => a.Item).ToArray();

    public Rg.BoundingBox BoxOf(ShownLayers layers, bool travels)
    {
        var box = Rg.BoundingBox.Empty;
        foreach (var layer in _boxes.Values.Where(b => layers.Has(b.Layer)))
        {
            box.Union(layer.Prints);
            if (travels) box.Union(layer.Travels);
        }
        return box;
    }

    private static (List<Rg.Line> Lines, List<int> Moves) Of(SortedDictionary<Role, (List<Rg.Line> Lines, List<int> Moves)> roles, Role role)
    {
        if (!roles.TryGetValue(role, out var open)) roles.Add(role, open = ([], []));
        return open;
    }

    private void Close(SortedDictionary<Role, (List<Rg.Line> Lines, List<int> Moves)> roles)
    {
        foreach (var role in roles.Where(r => r.Value.Lines.Count > 0))
        {
            var (lines, moves) = role.Value;
            _blocks.Add(new SceneBlock(role.Key, lines.ToArray(), moves.ToArray()));
            lines.Clear();
            moves.Clear();
        }
    }

    private LayerBoxes BoxesOf(int layer)
    {
        if (!_boxes.TryGetValue(layer, out var boxes)) _boxes.Add(layer, boxes = new LayerBoxes(layer));
        return boxes;
    }

    private sealed class LayerBoxes(int layer)
    {
        public readonly int Layer = layer;
        public Rg.BoundingBox Prints = Rg.BoundingBox.Empty;
        public Rg.BoundingBox Travels = Rg.BoundingBox.Empty;
    }
}

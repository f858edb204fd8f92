namespace Caterpillar.Toolpaths;

/// <summary>Adds up moves, block by block, so that they need not be kept.</summary>
internal sealed class ToolpathSums
{
    private readonly SortedDictionary<int, (double Deposited, double InPlace)> _tools = [];
    private double _print;
    private double _travel;
    private int _prints;
    private int _travels;
    private int _retractions;
    private readonly GrowingBox _part = new();
    private readonly GrowingBox _others = new();
    private readonly GrowingBox _blobs = new();
    private readonly GrowingBox _partBlobs = new();
    private readonly GrowingBox _all = new();

    /// <summary>Where the next move begins, mm.</summary>
    public Vec3 Position { get; set; }

    /// <summary>True to leave out moves without a layer.</summary>
    public bool OnlyLayers { get; init; }

    /// <summary>The sums of a toolpath.</summary>
    public static ToolpathSums Of(Toolpath toolpath)
    {
        var sums = new ToolpathSums { Position = toolpath.Start ?? Vec3.Zero };
        foreach (var block in toolpath.Blocks) sums.Add(block.Columns);
        return sums;
    }

    /// <summary>Adds the moves of the next block.</summary>
    public void Add(ToolpathColumns c)
    {
        for (var i = 0; i < c.Count;)
        {
            var tool = c.Tool[i];
            _tools.TryGetValue(tool, out var sums);
            for (; i < c.Count && c.Tool[i] == tool; i++)
            {
                if (OnlyLayers && c.Layer[i] < 0)
                {
                    Position = new Vec3(c.X[i], c.Y[i], c.Z[i]);
                    continue;
                }
                sums.Deposited += c.Deposited[i];
                if (!Add(c, i)) sums.InPlace += c.Deposited[i];
            }
            _tools[tool] = sums;
        }
    }

    /// <summary>The sums so far, for these tools.</summary>
    public ToolpathTotals ToTotals(IReadOnlyList<ToolpathTool> tools)
    {
        double deposited = 0, inPlace = 0;
        double? volume = 0;
        foreach (var tool in _tools)
        {
            var area = tool.Key >= 0 && tool.Key < tools.Count ? tools[tool.Key].VolumePerE : null;
            deposited += tool.Value.Deposited;
            if (tool.Value.Deposited != 0) volume += area * tool.Value.Deposited;
            inPlace += area.GetValueOrDefault() * tool.Value.InPlace;
        }
        var printBounds = _part.ToBounds().Include(_others.ToBounds());
        return new ToolpathTotals(
            _print, _travel, deposited, volume, _prints, _travels, _retractions, printBounds.IsEmpty ? _blobs.ToBounds() : printBounds, _all.ToBounds())
        {
            InPlaceVolume = inPlace, PartBounds = (_part.IsEmpty ? _partBlobs : _part).ToBounds(),
        };
    }

    // True for a printing move.
    private bool Add(ToolpathColumns c, int i)
    {
        var start = Position;
        var end = Position = new Vec3(c.X[i], c.Y[i], c.Z[i]);
        var turns = c.TryGetArc(i, out var arc);
        var length = turns ? arc.Length(start, end) : start.DistanceTo(end);
        var kind = c.Kind[i];
        if (length > 0) _all.Include(end);
        if (kind == MoveKind.Print)
        {
            _prints++;
            _print += length;
            var box = c.Role[i] is Role.Skirt or Role.Purge or Role.PrimeTower ? _others : _part;
            box.Include(start);
            box.Include(end);
            if (turns) box.Include(arc, start, end);
            return true;
        }
        if (kind is MoveKind.Retract or MoveKind.Wipe) _retractions++;
        if (kind == MoveKind.Prime) _blobs.Include(end);
        if (kind == MoveKind.Prime && c.Role[i] != Role.Purge) _partBlobs.Include(end);
        if (length > 0) _travels++;
        _travel += length;
        return false;
    }
}

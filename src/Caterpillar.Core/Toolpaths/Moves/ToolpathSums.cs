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
    private Bounds _part = Bounds.Empty;
    private Bounds _others = Bounds.Empty;
    private Bounds _blobs = Bounds.Empty;
    private Bounds _partBlobs = Bounds.Empty;
    private Bounds _all = Bounds.Empty;

    /// <summary>Where the next move begins, mm.</summary>
    public Vec3 Position { get; set; }

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
        var printBounds = _part.Include(_others);
        return new ToolpathTotals(
            _print, _travel, deposited, volume, _prints, _travels, _retractions, printBounds.IsEmpty ? _blobs : printBounds, _all)
        {
            InPlaceVolume = inPlace, PartBounds = _part.IsEmpty ? _partBlobs : _part,
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
        if (length > 0 && !_all.Contains(end)) _all = _all.Include(end);
        if (kind == MoveKind.Print)
        {
            _prints++;
            _print += length;
            ref var box = ref c.Role[i] is Role.Skirt or Role.Purge or Role.PrimeTower ? ref _others : ref _part;
            if (!box.Contains(start) || !box.Contains(end)) box = box.Include(start).Include(end);
            if (turns) box = box.Include(arc.Bounds(start, end));
            return true;
        }
        if (kind is MoveKind.Retract or MoveKind.Wipe) _retractions++;
        if (kind == MoveKind.Prime) _blobs = _blobs.Include(end);
        if (kind == MoveKind.Prime && c.Role[i] != Role.Purge) _partBlobs = _partBlobs.Include(end);
        if (length > 0) _travels++;
        _travel += length;
        return false;
    }
}

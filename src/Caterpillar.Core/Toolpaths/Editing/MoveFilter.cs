namespace Caterpillar.Toolpaths;

/// <summary>Selects moves of a toolpath. A move must meet all conditions that are set. An empty filter selects all moves.</summary>
public sealed record MoveFilter
{
    /// <summary>Roles of extrusions. Null = all.</summary>
    public IReadOnlyCollection<Role>? Roles { get; init; }

    /// <summary>Kinds of moves. Null = all.</summary>
    public IReadOnlyCollection<MoveKind>? Kinds { get; init; }

    /// <summary>
    /// The first layer, by its number in its object (<see cref="Layer.Index"/>). Null = no limit. If a first or last layer is set, moves without a layer are
    /// not selected.
    /// </summary>
    public int? FirstLayer { get; init; }

    /// <summary>The last layer, by its number in its object. Null = no limit.</summary>
    public int? LastLayer { get; init; }

    /// <summary>Names of objects. Null = all.</summary>
    public IReadOnlyCollection<string>? Objects { get; init; }

    /// <summary>Number of the tool. Null = all.</summary>
    public int? Tool { get; init; }

    /// <summary>A box that must contain the end of the move, mm. Null = no limit.</summary>
    public Bounds? Box { get; init; }

    /// <summary>A filter for printing moves.</summary>
    public static MoveFilter Prints { get; } = new() { Kinds = [MoveKind.Print] };

    /// <summary>True if the filter selects this move of this layer.</summary>
    public bool Matches(Move move, Layer? layer)
        => (Roles is null || Roles.Contains(move.Role))
            && (Kinds is null || Kinds.Contains(move.Kind))
            && MatchesNumber(layer)
            && (Tool is null || move.Tool == Tool)
            && (Box is null || Box.Value.Contains(move.End));

    /// <summary>The same filter without moves outside of all layers (start and end G-code), if the toolpath has layers.</summary>
    public MoveFilter InLayersOf(Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        return FirstLayer is null && toolpath.Layers.Count > 0 ? this with { FirstLayer = int.MinValue } : this;
    }

    /// <summary>Bounding box of the selected moves, mm. Empty if the filter selects none.</summary>
    public Bounds BoundsIn(Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        var box = Bounds.Empty;
        var chosen = new MoveChoice(this, toolpath);
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var (c, end) = (toolpath.Blocks[block].Columns, toolpath.StartOf(block));
            for (var i = 0; i < c.Count; i++)
            {
                var start = end;
                end = new Vec3(c.X[i], c.Y[i], c.Z[i]);
                if (!chosen.Has(c, i)) continue;
                if (c.TryGetArc(i, out var arc)) box = box.Include(arc.Bounds(start, end));
                else if (!box.Contains(start) || !box.Contains(end)) box = box.Include(start).Include(end);
            }
        }
        return box;
    }

    /// <summary>True if a whole layer is selected.</summary>
    internal bool MatchesLayer(Layer layer)
        => Roles is null && Kinds is null && Tool is null && Box is null && Matches(default, layer);

    /// <summary>True if the move of a toolpath is selected.</summary>
    internal bool Matches(Toolpath toolpath, Move move) => Matches(move, move.Layer >= 0 ? toolpath.Layers[move.Layer] : null);

    /// <summary>True if number and object of a layer meet the filter. Null = no layer.</summary>
    internal bool MatchesNumber(Layer? layer)
        => (FirstLayer is null || (layer is not null && layer.Index >= FirstLayer))
            && (LastLayer is null || (layer is not null && layer.Index <= LastLayer))
            && (Objects is null || (layer is not null && Objects.Contains(layer.Object)));
}

using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>Chooses moves of a toolpath. All given conditions must hold; without any, all moves are chosen.</summary>
public sealed record MoveFilter
{
    /// <summary>Roles of extrusions; null for all.</summary>
    public IReadOnlyCollection<Role>? Roles { get; init; }

    /// <summary>Kinds of moves; null for all.</summary>
    public IReadOnlyCollection<MoveKind>? Kinds { get; init; }

    /// <summary>
    /// First and last number of the layer in its object (<see cref="Layer.Index"/>); null for no limit. Moves without a layer are excluded as soon as one is
    /// given.
    /// </summary>
    public int? FirstLayer { get; init; }

    /// <summary>The last layer, by its number; null for no limit.</summary>
    public int? LastLayer { get; init; }

    /// <summary>Names of objects; null for all.</summary>
    public IReadOnlyCollection<string>? Objects { get; init; }

    /// <summary>Number of the tool; null for all.</summary>
    public int? Tool { get; init; }

    /// <summary>A box in mm that contains the end of the move; null for everywhere.</summary>
    public Bounds? Box { get; init; }

    /// <summary>Printing moves.</summary>
    public static MoveFilter Prints { get; } = new() { Kinds = [MoveKind.Print] };

    /// <summary>True for a move of a layer that the filter lets through.</summary>
    public bool Matches(Move move, Layer? layer)
        => (Roles is null || Roles.Contains(move.Role))
            && (Kinds is null || Kinds.Contains(move.Kind))
            && MatchesNumber(layer)
            && (Tool is null || move.Tool == Tool)
            && (Box is null || Box.Value.Contains(move.End));

    /// <summary>The same without the moves that belong to no layer (start and end code of a file), if the toolpath has layers.</summary>
    public MoveFilter InLayersOf(Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        return FirstLayer is null && toolpath.Layers.Count > 0 ? this with { FirstLayer = int.MinValue } : this;
    }

    /// <summary>Whether moves of this toolpath are chosen, as a question for each.</summary>
    public Func<Move, bool> MatchesIn(Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        return move => Matches(toolpath, move);
    }

    /// <summary>Box around the chosen moves of a toolpath, mm; empty if there are none.</summary>
    public Bounds BoundsIn(Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        var box = Bounds.Empty;
        var choice = new MoveChoice(this, toolpath);
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var columns = toolpath.Blocks[block].Columns;
            var start = toolpath.StartOf(block);
            for (var i = 0; i < columns.Count; i++)
            {
                var end = new Vec3(columns.X[i], columns.Y[i], columns.Z[i]);
                if (choice.Has(columns, i))
                {
                    if (!box.Contains(start)) box = box.Include(start);
                    if (!box.Contains(end)) box = box.Include(end);
                    if (columns.TryGetArc(i, out var arc)) box = box.Include(arc.Bounds(start, end));
                }
                start = end;
            }
        }
        return box;
    }

    /// <summary>True if a layer is chosen completely.</summary>
    internal bool MatchesLayer(Layer layer)
        => Roles is null && Kinds is null && Tool is null && Box is null && Matches(default, layer);

    /// <summary>True if the move of a toolpath is chosen.</summary>
    internal bool Matches(Toolpath toolpath, Move move) => Matches(move, move.Layer >= 0 ? toolpath.Layers[move.Layer] : null);

    /// <summary>True if the moves of a layer are chosen as far as its number and object go; null for moves without one.</summary>
    internal bool MatchesNumber(Layer? layer)
        => (FirstLayer is null || (layer is not null && layer.Index >= FirstLayer))
            && (LastLayer is null || (layer is not null && layer.Index <= LastLayer))
            && (Objects is null || (layer is not null && Objects.Contains(layer.Object)));
}

namespace Caterpillar.GH.Components.GCode;

/// <summary>The moves of a toolpath with a branch for each layer. Arcs are given as straight moves.</summary>
internal sealed class LayerBranches
{
    private const double ChordTolerance = 0.01;
    private readonly Toolpath _toolpath;
    private readonly GH_Path _root;
    private readonly int _lowest;

    public LayerBranches(Toolpath toolpath, GH_Path root)
    {
        (_toolpath, _root) = (toolpath, root);
        // Numbers of rafts may begin below 0, branches do not.
        var numbers = toolpath.NumbersOfLayers();
        _lowest = numbers.Count > 0 ? Math.Min(numbers[0], 0) : 0;
    }

    /// <summary>The branch of the layer of a move, the first without a layer.</summary>
    public GH_Path PathOf(Move move) => _root.AppendElement(_toolpath.NumberOfLayer(move) is { } number ? number - _lowest : 0);

    /// <summary>All moves. One without a layer is in the branch of the move before it, and the branch stays one object as long as it is the same.</summary>
    public IEnumerable<(Move Move, GH_Path Path)> Moves()
    {
        var (layer, path) = (-1, _root.AppendElement(0));
        foreach (var move in _toolpath.Moves())
        {
            if (move.Layer >= 0 && move.Layer != layer) (layer, path) = (move.Layer, PathOf(move));
            if (move.Arc is not { } arc)
            {
                yield return (move, path);
                continue;
            }
            var count = arc.ChordCount(move.Start, ChordTolerance);
            var part = move with { E = move.E / count, Deposited = move.Deposited / count, Arc = null };
            for (var k = 1; k <= count; k++)
            {
                part = part with { Start = k == 1 ? move.Start : part.End, End = k == count ? move.End : arc.PointAt(move.Start, move.End, (double)k / count) };
                yield return (part, path);
            }
        }
    }
}

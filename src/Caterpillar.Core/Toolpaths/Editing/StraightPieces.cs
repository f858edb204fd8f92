namespace Caterpillar.Toolpaths;

/// <summary>Makes a toolpath of the straight pieces of another one: its moves, and the chords of its arcs.</summary>
internal static class StraightPieces
{
    private const double ChordTolerance = 0.01;

    /// <summary>Number of pieces of a move.</summary>
    public static int Count(in Move move) => move.Arc is { } arc ? arc.ChordCount(move.Start, ChordTolerance) : 1;

    /// <summary>A toolpath with the same layers and events.</summary>
    /// <param name="toolpath">The toolpath.</param>
    /// <param name="start">The new start, mm.</param>
    /// <param name="add">Adds a piece to the new toolpath.</param>
    /// <param name="progress">Receives 0 to 1.</param>
    /// <param name="cancel">Cancels the work.</param>
    public static Toolpath Rebuilt(
        Toolpath toolpath, Vec3? start, Action<ToolpathBuilder, Move> add, IProgress<double>? progress, CancellationToken cancel)
    {
        var builder = new ToolpathBuilder(toolpath.Source, start);
        foreach (var layer in toolpath.Layers) builder.AddLayer(layer);
        var nextEvent = 0;
        foreach (var move in toolpath.Moves())
        {
            if ((move.Index & 0xFFF) == 0)
            {
                cancel.ThrowIfCancellationRequested();
                progress?.Report((double)move.Index / toolpath.Count);
            }
            Events(move.Index);
            var parts = Count(move);
            var last = move.Start;
            for (var k = 1; k <= parts; k++)
            {
                var next = move.PointAt((double)k / parts);
                add(builder, move with { Start = last, End = next, E = move.E / parts, Deposited = move.Deposited / parts, Arc = null });
                last = next;
            }
        }
        Events(toolpath.Count);
        return builder.Build(toolpath.Tools);

        void Events(int move)
        {
            for (; nextEvent < toolpath.Events.Count && toolpath.Events[nextEvent].Move <= move; nextEvent++)
                builder.AddEvent(toolpath.Events[nextEvent].Event);
        }
    }
}

namespace Caterpillar.Toolpaths;

/// <summary>Consecutive moves of a toolpath that are mapped together, divided into pieces if the map curves them.</summary>
internal sealed class MoveRun(Toolpath toolpath, Vec3 start)
{
    public Toolpath Toolpath => toolpath;

    /// <summary>Start of the first piece and end of each, mm.</summary>
    public List<Vec3> Points { get; } = [start];

    /// <summary>For each piece its arc, or null if it is straight.</summary>
    public List<Arc?> Arcs { get; } = [];

    /// <summary>For each piece the move it belongs to, and its share of that move.</summary>
    public List<int> Moves { get; } = [];

    public List<double> Shares { get; } = [];

    /// <summary>For each piece the factor for its material per mm of length, and its speed in mm/s.</summary>
    public List<double> Flows { get; } = [];

    public List<double> Speeds { get; } = [];

    /// <summary>Ends a move: the points added since the last call are its pieces.</summary>
    public void Close(Move move, Arc? arc = null)
    {
        while (Moves.Count < Points.Count - 1)
        {
            Moves.Add(move.Index);
            Arcs.Add(arc);
            Flows.Add(1);
            Speeds.Add(move.Speed);
        }
        if (Shares.Count < Moves.Count) Shares.Add(1);
    }
}

/// <summary>A map of runs of moves.</summary>
internal abstract class RunMap
{
    /// <summary>True if each point is mapped on its own, so that runs can be cut anywhere.</summary>
    public virtual bool IsLocal => false;

    /// <summary>Adds the pieces of a move to a run, before the mapping.</summary>
    public abstract void Divide(Move move, MoveRun run);

    /// <summary>Maps a run in place.</summary>
    public abstract void Map(MoveRun run);

    /// <summary>
    /// The image of a whole block whose first move begins at <paramref name="start"/>, while the head is at <paramref name="position"/>. Null if its moves
    /// must be mapped one by one.
    /// </summary>
    public virtual ToolpathColumns? MapBlock(ToolpathColumns block, Vec3 start, Vec3 position) => null;

    /// <summary>Divides printed moves and arcs so that straight pieces match their images within the tolerance (mm). Other moves stay whole.</summary>
    protected static void DivideSmoothly(Move move, MoveRun run, double tolerance, Func<Vec3[], Vec3[]> map)
    {
        if (move.Kind == MoveKind.Print || move.Arc is not null) SmoothDivision.Divide(move.Start, move.End, move.Arc, tolerance, map, run.Points, run.Shares);
        else run.Points.Add(move.End);
        run.Close(move);
    }
}

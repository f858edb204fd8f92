namespace Caterpillar.Toolpaths;

/// <summary>Toolpaths of the same machine in other coordinates, read from a file move by move.</summary>
internal static class RotaryColumns
{
    /// <summary>The words A, B and C at the end of a move, degrees; those before where a block has none.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3 TurnsAt(this ToolpathColumns columns, int i, Vec3 before)
        => columns.Turns is null ? before : columns.Turns[i];

    /// <summary>
    /// The toolpath with each position mapped, given the rotary words there. A move that only turns the machine prints or travels like others where it turns
    /// out to move; speeds keep the time of each move.
    /// </summary>
    /// <param name="toolpath">The toolpath as it was read.</param>
    /// <param name="map">Gives the place for a position and the rotary words.</param>
    /// <param name="keepsTurns">Whether the rotary words stay with the moves.</param>
    /// <param name="cancel">Cancels.</param>
    public static Toolpath Mapped(Toolpath toolpath, Func<Vec3, Vec3, Vec3> map, bool keepsTurns, CancellationToken cancel)
    {
        var blocks = new List<ToolpathBlock>(toolpath.Blocks.Count);
        Vec3 last = toolpath.Start ?? Vec3.Zero, lastTurn = Vec3.Zero;
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            cancel.ThrowIfCancellationRequested();
            var read = toolpath.Blocks[block].Columns;
            var columns = read.Copy(read.Count);
            for (var i = 0; i < read.Count; i++)
            {
                Vec3 at = new(read.X[i], read.Y[i], read.Z[i]), turn = read.TurnsAt(i, lastTurn);
                Vec3 start = map(last, lastTurn), end = map(at, turn);
                (columns.X[i], columns.Y[i], columns.Z[i]) = (end.X, end.Y, end.Z);
                double length = start.DistanceTo(end), moved = last.DistanceTo(at), turned = lastTurn.DistanceTo(turn);
                if ((length > 0 || turned > 0) && !read.TryGetArc(i, out _))
                {
                    columns.Speed[i] *= Share(length, turned) / Share(moved, turned);
                    if (moved == 0 && length > 0) columns.Kind[i] = Moving(read.Kind[i], read.Deposited[i]);
                }
                (last, lastTurn) = (at, turn);
            }
            if (!keepsTurns) columns.Turns = null;
            blocks.Add(new ToolpathBlock(columns, toolpath.Blocks[block].File));
        }
        Vec3? first = toolpath.Start is { } known ? map(known, Vec3.Zero) : null;
        return toolpath.With(blocks).With(first, toolpath.Layers);
    }

    /// <summary>What the speed of a move is measured along: mm of X, Y and Z, or degrees where none of them moves (RS274/NGC section 2.1.2.5).</summary>
    public static double Share(double length, double degrees) => length > 0 ? length : degrees;

    // The kind of a move in place that turned out to be one along the surface.
    private static MoveKind Moving(MoveKind kind, double deposited) => kind switch
    {
        MoveKind.Prime => MoveKind.Print,
        MoveKind.Deretract => deposited > 0 ? MoveKind.Print : MoveKind.MovingDeretract,
        MoveKind.Retract => MoveKind.Wipe,
        _ => kind,
    };
}

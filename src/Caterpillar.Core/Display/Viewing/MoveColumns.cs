namespace Caterpillar.Display;

/// <summary>
/// The moves of a toolpath as columns of a viewer page, a row for each straight piece. Arcs are divided. Moves in place have a row without length,
/// and the volume of what they extrude as area. Lengths in µm, areas in 10⁻⁴ mm², speeds in 0.01 mm/s, times in ms. 5 to 10 bytes per move after packing.
/// </summary>
internal sealed class MoveColumns(ViewerContent content)
{
    /// <summary>Maximum deviation of chords from arcs, mm, and for arcs larger than any printer as a share of the radius.</summary>
    private const double ChordError = 0.02, ShareOfRadius = 2e-6;

    private readonly Toolpath _toolpath = content.Toolpath!;
    private readonly PackedColumn _x = new("x"), _y = new("y"), _z = new("z"), _area = new("area"), _time = new("time"), _line = new("line");
    private readonly PackedColumn _what = new("what", true), _layer = new("layer", true), _tool = new("tool", true), _speed = new("speed", true);
    private readonly PackedColumn _move = new("move");

    // Axes Z and X of a head that turns over the part.
    private readonly PackedColumn[] _head = [.. new[] { "zx", "zy", "zz", "xx", "xy", "xz" }.Select(name => new PackedColumn(name))];
    private readonly Kinematics? _kinematics = content.Toolpath!.HasTurns ? content.Printer?.Kinematics ?? Kinematics.Guess(content.Toolpath!) : null;
    private readonly int[] _firstRow = new int[content.Toolpath!.Count + 1];

    /// <summary>The columns in the order of the page.</summary>
    public IEnumerable<PackedColumn> All => [_x, _y, _z, _what, _layer, _tool, _line, _move, _speed, _area, _time, .. _kinematics is null ? [] : _head];

    /// <summary>Number of rows.</summary>
    public int Rows => _x.Count;

    /// <summary>The first row of a move. Number of moves = number of rows.</summary>
    public int RowOf(int move) => _firstRow[Math.Max(0, Math.Min(move, _toolpath.Count))];

    public static MoveColumns Of(ViewerContent content, IProgress<double>? progress, CancellationToken cancel)
    {
        var columns = new MoveColumns(content);
        columns.Fill(progress, cancel);
        return columns;
    }

    private void Fill(IProgress<double>? progress, CancellationToken cancel)
    {
        foreach (var move in _toolpath.Moves())
        {
            if ((move.Index & 0xFFFF) == 0)
            {
                cancel.ThrowIfCancellationRequested();
                progress?.Report((double)move.Index / _toolpath.Count);
            }
            _firstRow[move.Index] = Rows;
            var length = move.Length;
            var extrudes = move.Kind is MoveKind.Print or MoveKind.Prime;
            var area = extrudes && _toolpath.VolumeOf(move) is > 0 and var volume ? length > 0 ? volume / length : volume : 0;
            var begin = move.Index > 0 ? End(move.Index - 1) : 0;
            var chords = move.Arc is { } arc
                ? arc.ChordCount(move.Start, move.End, Math.Max(ChordError, arc.Radius(move.Start) * ShareOfRadius)) : 1;
            for (var i = 1; i <= chords; i++)
            {
                if ((i & 0xFFF) == 2) cancel.ThrowIfCancellationRequested();
                var part = (double)i / chords;
                Row(move, move.PointAt(part), area, begin + (End(move.Index) - begin) * part);
            }
        }
        _firstRow[_toolpath.Count] = Rows;
    }

    private double End(int move) => content.EndOf?.Invoke(move) ?? 0;

    private void Row(in Move move, Vec3 end, double area, double time)
    {
        _x.Add(end.X, 1e-3);
        _y.Add(end.Y, 1e-3);
        _z.Add(end.Z, 1e-3);
        _what.Add(((int)move.Kind << 5) | (int)move.Role);
        _layer.Add(move.Layer);
        _tool.Add(move.Tool);
        _line.Add(move.Source);
        _move.Add(move.Index);
        _speed.Add(move.Speed, 1e-2);
        _area.Add(area, 1e-4);
        _time.Add(time, 1e-3);
        if (_kinematics is null) return;
        var pose = _kinematics.Pose(end, _toolpath.WordsAt(move.Index));
        double[] axes = [pose.ZAxis.X, pose.ZAxis.Y, pose.ZAxis.Z, pose.XAxis.X, pose.XAxis.Y, pose.XAxis.Z];
        for (var i = 0; i < axes.Length; i++) _head[i].Add(axes[i], 1e-4);
    }
}

namespace Caterpillar.Simulation;

/// <summary>Sums over the moves before some move.</summary>
/// <param name="Length">Path length of the head, mm.</param>
/// <param name="Filament">Deposited E in the units of the tools.</param>
/// <param name="Volume">Deposited material whose volume is known, mm³.</param>
internal readonly record struct PathSums(double Length, double Filament, double Volume);

/// <summary>
/// What makes a toolpath quick to search: running sums at every <see cref="Step"/>th move of a block, where layers begin, where prints first reach a
/// height, whether sources ascend.
/// </summary>
internal sealed class PathIndex
{
    /// <summary>Moves between two kept sums.</summary>
    public const int Step = 128;

    private readonly Toolpath _toolpath;
    private readonly PathSums[][] _sums;
    private readonly int[] _layerStarts;
    private readonly List<double> _heights = [];
    private readonly List<int> _heightMoves = [];
    private readonly List<(int Move, double Speed)> _fans = [];
    private double _top = double.NegativeInfinity;

    public PathIndex(Toolpath toolpath)
    {
        _toolpath = toolpath;
        _sums = new PathSums[toolpath.Blocks.Count][];
        _layerStarts = [.. Enumerable.Repeat(toolpath.Count, toolpath.Layers.Count)];
        var before = int.MinValue;
        for (var block = 0; block < _sums.Length; block++) before = Scan(block, before);
        foreach (var (move, what) in toolpath.Events)
        {
            if (what is FanEvent fan) _fans.Add((move, fan.Speed));
        }
    }

    /// <summary>Sums over all moves.</summary>
    public PathSums Total { get; private set; }

    /// <summary>No source is smaller than one before it (those of moves without a source are skipped).</summary>
    public bool SourcesAscend { get; private set; } = true;

    /// <summary>The moves up to the last that has a source.</summary>
    public int SourcedMoves { get; private set; }

    /// <summary>First move of a layer of the toolpath; the number of moves if it has none.</summary>
    public int StartOfLayer(int layer) => _layerStarts[layer];

    /// <summary>The first printing move that ends at a height or above, mm; the number of moves where none does.</summary>
    public int FirstAbove(double z)
    {
        var at = _heights.BinarySearch(z);
        if (at < 0) at = ~at;
        return at < _heights.Count ? _heightMoves[at] : _toolpath.Count;
    }

    /// <summary>The fan during a move, 0 to 1.</summary>
    public double FanAt(int move)
    {
        var next = Search.First(0, _fans.Count, (_fans, move), static (s, i) => s._fans[i].Move > s.move);
        return next > 0 ? _fans[next - 1].Speed : 0;
    }

    /// <summary>Sums over the moves before a move; at most <see cref="Step"/> moves are added up.</summary>
    public PathSums Before(int move)
    {
        if (move >= _toolpath.Count) return Total;
        var block = _toolpath.BlockOf(move);
        var i = move - _toolpath.FirstOf(block);
        return Add(block, i / Step * Step, i, _sums[block][i / Step], double.PositiveInfinity, out _);
    }

    /// <summary>The move in which the path of the head reaches a length, mm, and the sums before it.</summary>
    public (int Move, PathSums Before) AtLength(double length)
    {
        if (!(length < Total.Length)) return (_toolpath.Count, Total);
        // The last block, and the last kept sum of it, that begins at the length or before.
        var block = Search.First(1, _sums.Length, (_sums, length), static (s, i) => s._sums[i][0].Length > s.length) - 1;
        var sums = _sums[block];
        var sum = Search.First(1, sums.Length, (sums, length), static (s, i) => s.sums[i].Length > s.length) - 1;
        var before = Add(block, sum * Step, _toolpath.Blocks[block].Count, sums[sum], length, out var at);
        return (_toolpath.FirstOf(block) + at, before);
    }

    private int Scan(int block, int source)
    {
        var columns = _toolpath.Blocks[block].Columns;
        var first = _toolpath.FirstOf(block);
        var sums = _sums[block] = new PathSums[(columns.Count + Step - 1) / Step];
        var running = Total;
        for (var i = 0; i < columns.Count; i += Step)
        {
            sums[i / Step] = running;
            running = Add(block, i, Math.Min(i + Step, columns.Count), running, double.PositiveInfinity, out _);
        }
        Total = running;
        for (var i = 0; i < columns.Count; i++)
        {
            if (columns.Layer[i] is >= 0 and var layer && _layerStarts[layer] == _toolpath.Count) _layerStarts[layer] = first + i;
            if (columns.Kind[i] == MoveKind.Print && columns.Z[i] > _top)
            {
                _top = columns.Z[i];
                _heights.Add(_top);
                _heightMoves.Add(first + i);
            }
            var own = columns.Source[i];
            if (own < 0) continue;
            if (own < source) SourcesAscend = false;
            source = own;
            SourcedMoves = first + i + 1;
        }
        return source;
    }

    // Sums over moves of a block, up to the one that reaches a length.
    private PathSums Add(int block, int from, int to, PathSums sums, double length, out int at)
    {
        var c = _toolpath.Blocks[block].Columns;
        var start = from > 0 ? new Vec3(c.X[from - 1], c.Y[from - 1], c.Z[from - 1]) : _toolpath.StartOf(block);
        double path = sums.Length, filament = sums.Filament, volume = sums.Volume;
        for (at = from; at < to; at++)
        {
            var end = new Vec3(c.X[at], c.Y[at], c.Z[at]);
            var own = c.TryGetArc(at, out var arc) ? arc.Length(start, end) : start.DistanceTo(end);
            if (path + own > length) break;
            path += own;
            filament += c.Deposited[at];
            volume += c.Deposited[at] * _toolpath.VolumePerE(c.Tool[at]).GetValueOrDefault();
            start = end;
        }
        return new PathSums(path, filament, volume);
    }
}

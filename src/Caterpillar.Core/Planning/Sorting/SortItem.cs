namespace Caterpillar.Planning;

/// <summary>A path for sorting, and how it may be changed; or several that stay together, of which this is the first.</summary>
internal readonly struct SortItem(PrintPath path, bool reverse, bool rotate, PrintPath? tail = null)
{
    public readonly PrintPath Path = path;

    /// <summary>The last of the paths that stay together.</summary>
    public readonly PrintPath? Tail = tail;

    /// <summary>Whether an order that goes past it in the other direction is about as long.</summary>
    public bool CanTurn => Tail is null ? Reverse || Path.IsClosed : Path.IsClosed && Tail.IsClosed;

    public readonly bool Reverse = reverse && !path.IsClosed && tail is null;

    public readonly bool Rotate = rotate && path.IsClosed;

    public Vec3 Entry(PathPlacement at) => at.Reversed ? Path.End : Path.RawPoints[at.Vertex];

    public Vec3 Exit(PathPlacement at) => Tail is not null ? TailExit(at) : at.Reversed ? Path.Start : Path.IsClosed ? Path.RawPoints[at.Vertex] : Path.End;

    /// <summary>The end, or the vertex of a loop, that is nearest to a point; the first among equals.</summary>
    public PathPlacement NearestEntry(int index, Vec3 from)
    {
        if (Reverse && (Path.End - from).LengthSquared < (Path.Start - from).LengthSquared) return new PathPlacement(index, true);
        return new PathPlacement(index, false, Rotate ? BestVertex(p => (p - from).LengthSquared) : 0);
    }

    /// <summary>The vertex of a loop that gives the shortest travel from one point via the loop to another.</summary>
    public PathPlacement Between(int index, Vec3 from, Vec3 to) => new(index, false, BestVertex(p => p.DistanceTo(from) + p.DistanceTo(to)));

    // The first vertex with the smallest value.
    private int BestVertex(Func<Vec3, double> valueOf)
    {
        var best = 0;
        var least = double.PositiveInfinity;
        for (var i = 0; i < Path.RawPoints.Length; i++)
        {
            var value = valueOf(Path.RawPoints[i]);
            if (value >= least) continue;
            best = i;
            least = value;
        }
        return best;
    }

    // Loops that may start anywhere start side by side.
    private Vec3 TailExit(PathPlacement at) => !Tail!.IsClosed ? Tail.End : Rotate ? Path.RawPoints[at.Vertex] : Tail.Start;
}

/// <summary>The points at which paths may start, with the path or island that each belongs to.</summary>
internal sealed class EntryPoints
{
    // For loops of more vertices only a selection is searched first; the chosen loop then starts at its nearest vertex.
    private const int MaxPerLoop = 128;
    private readonly List<Vec3> _points = [];
    private readonly List<int> _owners = [];
    private readonly List<int> _firsts = [];
    private readonly EntryTree _tree;

    /// <param name="items">The paths, in the order of their owners, which are numbered from 0.</param>
    public EntryPoints(IEnumerable<(SortItem Item, int Owner)> items)
    {
        foreach (var (item, owner) in items)
        {
            if (owner == _firsts.Count) _firsts.Add(_points.Count);
            AddEntries(item, owner);
        }
        _firsts.Add(_points.Count);
        _tree = new EntryTree(_points.ToArray());
    }

    /// <summary>The owner of the nearest point that remains.</summary>
    public int NearestOwner(Vec3 at) => _owners[_tree.Nearest(at)];

    public void Remove(int owner)
    {
        for (var i = _firsts[owner]; i < _firsts[owner + 1]; i++) _tree.Remove(i);
    }

    private void AddEntries(SortItem item, int owner)
    {
        if (item.Rotate)
        {
            var points = item.Path.RawPoints;
            var step = (points.Length + MaxPerLoop - 1) / MaxPerLoop;
            for (var i = 0; i < points.Length; i += step) Add(points[i], owner);
            return;
        }
        Add(item.Path.Start, owner);
        if (item.Reverse) Add(item.Path.End, owner);
    }

    private void Add(Vec3 point, int owner)
    {
        _points.Add(point);
        _owners.Add(owner);
    }
}

namespace Caterpillar.Toolpaths;

/// <summary>
/// A path that is printed without a stop: vertices in mm, and a bead for each segment. Segments are straight, or arcs in the XY plane with linear Z. A closed
/// path does not repeat its first vertex and has a segment back to it. Immutable, and equal only to itself.
/// </summary>
public sealed record PrintPath
{
    private readonly Vec3[] _points;
    private readonly Bead[] _beads;
    private readonly Arc?[]? _arcs;

    /// <summary>A path with one bead for all its segments.</summary>
    /// <exception cref="ArgumentException">Fewer than two vertices (three for a closed path without arcs), or a vertex is not finite.</exception>
    public PrintPath(IEnumerable<Vec3> points, Bead bead, bool closed = false)
        : this((points ?? throw new ArgumentNullException(nameof(points))).ToArray(), [bead], closed, null)
    {
    }

    /// <summary>A path with a bead for each segment, and optionally an arc for each (null if it is straight).</summary>
    /// <exception cref="ArgumentException">As above, or the number of beads or arcs is not the number of segments, or an arc is not in the XY
    /// plane.</exception>
    public PrintPath(IEnumerable<Vec3> points, IEnumerable<Bead> beads, bool closed = false, IEnumerable<Arc?>? arcs = null)
        : this((points ?? throw new ArgumentNullException(nameof(points))).ToArray(),
            (beads ?? throw new ArgumentNullException(nameof(beads))).ToArray(), closed, arcs?.ToArray(), perSegment: true)
    {
    }

    private PrintPath(Vec3[] points, Bead[] beads, bool closed, Arc?[]? arcs, bool perSegment = false)
    {
        if (arcs is not null && Array.TrueForAll(arcs, a => a is null)) arcs = null;
        if (points.Length < (closed && arcs is null ? 3 : 2))
            throw new ArgumentException("A path needs at least two vertices, a closed path at least three.", nameof(points));
        foreach (var p in points)
        {
            if (!p.IsFinite) throw new ArgumentException("A vertex is not finite.", nameof(points));
        }
        var segments = closed ? points.Length : points.Length - 1;
        if (perSegment && beads.Length != segments)
            throw new ArgumentException($"A path of {segments} segments needs {segments} beads, not {beads.Length}.", nameof(beads));
        if (arcs is not null && arcs.Length != segments)
            throw new ArgumentException($"A path of {segments} segments needs {segments} arcs or nulls, not {arcs.Length}.", nameof(arcs));
        if (arcs is not null && Array.Exists(arcs, a => a is { Plane: not ArcPlane.XY }))
            throw new ArgumentException("Arcs of a path must be in the XY plane.", nameof(arcs));
        _points = points;
        _beads = beads;
        _arcs = arcs;
        IsClosed = closed;
    }

    /// <summary>The vertices, mm. A closed path does not repeat the first one at its end.</summary>
    public IReadOnlyList<Vec3> Points => _points;

    /// <summary>True if a segment joins the last point to the first.</summary>
    public bool IsClosed { get; }

    /// <summary>Number of segments.</summary>
    public int SegmentCount => IsClosed ? _points.Length : _points.Length - 1;

    /// <summary>True if the path has arcs.</summary>
    public bool HasArcs => _arcs is not null;

    /// <summary>Role of the extrusion.</summary>
    public Role Role { get; init; }

    /// <summary>Layer of the path. Null = no layer.</summary>
    public Layer? Layer { get; init; }

    /// <summary>Number of the tool, from 0.</summary>
    public int Tool { get; init; }

    /// <summary>Display name. May be empty.</summary>
    public string Name { get; init; } = "";

    /// <summary>Color for images and baking, 0xRRGGBB. Null = none.</summary>
    public int? Color { get; init; }

    /// <summary>Temperature, fan speed and acceleration while the path is printed.</summary>
    public PathOverrides? Overrides { get; init; }

    /// <summary>The first point, mm.</summary>
    public Vec3 Start => _points[0];

    /// <summary>The end, mm. The end of a closed path is its first point.</summary>
    public Vec3 End => IsClosed ? _points[0] : _points[_points.Length - 1];

    /// <summary>The bead of a segment.</summary>
    public Bead BeadOf(int segment) => _beads.Length == 1 ? _beads[0] : _beads[segment];

    /// <summary>The arc of a segment, or null if it is straight.</summary>
    public Arc? ArcOf(int segment) => _arcs?[segment];

    /// <summary>True if all segments share one bead.</summary>
    public bool IsUniform => _beads.Length == 1 || Array.TrueForAll(_beads, b => b == _beads[0]);

    /// <summary>End vertex of a segment.</summary>
    public Vec3 EndOf(int segment) => segment + 1 == _points.Length ? _points[0] : _points[segment + 1];

    /// <summary>Length of a segment in mm.</summary>
    public double LengthOf(int segment)
        => ArcOf(segment) is { } arc ? arc.Length(_points[segment], EndOf(segment)) : _points[segment].DistanceTo(EndOf(segment));

    /// <summary>Length in mm.</summary>
    public double Length
    {
        get
        {
            var sum = 0.0;
            for (var i = 0; i < SegmentCount; i++) sum += LengthOf(i);
            return sum;
        }
    }

    /// <summary>Deposited volume in mm³.</summary>
    public double Volume
    {
        get
        {
            var sum = 0.0;
            for (var i = 0; i < SegmentCount; i++) sum += LengthOf(i) * BeadOf(i).Area;
            return sum;
        }
    }

    /// <summary>Bounding box of the path, arcs included, mm.</summary>
    public Bounds Bounds
    {
        get
        {
            var bounds = Bounds.Of(_points);
            for (var i = 0; _arcs is not null && i < SegmentCount; i++)
            {
                if (_arcs[i] is { } arc) bounds = bounds.Include(arc.Bounds(_points[i], EndOf(i)));
            }
            return bounds;
        }
    }

    /// <summary>The path in reverse direction. A closed path keeps its first vertex.</summary>
    public PrintPath Reversed()
    {
        var points = (Vec3[])_points.Clone();
        Array.Reverse(points, IsClosed ? 1 : 0, points.Length - (IsClosed ? 1 : 0));
        var beads = (Bead[])_beads.Clone();
        Array.Reverse(beads);
        var arcs = _arcs is null ? null : Array.ConvertAll(_arcs, a => a?.Reversed());
        if (arcs is not null) Array.Reverse(arcs);
        return With(points, beads, arcs);
    }

    /// <summary>The same closed path with another start vertex.</summary>
    /// <exception cref="InvalidOperationException">The path is open.</exception>
    public PrintPath StartingAt(int vertex)
    {
        if (!IsClosed) throw new InvalidOperationException("Only a closed path can start at another vertex.");
        return vertex == 0 ? this : With(Rotated(_points, vertex), _beads.Length == 1 ? _beads : Rotated(_beads, vertex), _arcs is null ? null
            : Rotated(_arcs, vertex));
    }

    /// <summary>The same path with a new bead for each segment.</summary>
    public PrintPath WithBeads(Func<int, Bead> beadOfSegment)
    {
        var beads = new Bead[SegmentCount];
        for (var i = 0; i < beads.Length; i++) beads[i] = beadOfSegment(i);
        return With(_points, beads, _arcs);
    }

    /// <summary>A path with the same properties and other geometry.</summary>
    /// <inheritdoc cref="PrintPath(IEnumerable{Vec3}, IEnumerable{Bead}, bool, IEnumerable{Arc?})" path="/exception"/>
    public PrintPath WithGeometry(IEnumerable<Vec3> points, IEnumerable<Bead> beads, bool closed, IEnumerable<Arc?>? arcs = null)
        => Settings(new PrintPath(points, beads, closed, arcs));

    /// <summary>Takes ownership of the arrays without a copy, for code that has just made them.</summary>
    internal static PrintPath Own(Vec3[] points, Bead[] beads, bool closed, Arc?[]? arcs = null) => new(points, beads, closed, arcs, beads.Length != 1);

    /// <summary>A path with the same properties and other geometry. Takes ownership of the arrays. One bead applies to all segments.</summary>
    internal PrintPath WithOwn(Vec3[] points, Bead[] beads, bool closed) => Settings(Own(points, beads, closed));

    internal Vec3[] RawPoints => _points;

    /// <summary>The bead of all segments. Null if each segment has its own.</summary>
    internal Bead? OnlyBead => _beads.Length == 1 ? _beads[0] : null;

    public bool Equals(PrintPath? other) => ReferenceEquals(this, other);

    public override int GetHashCode() => RuntimeHelpers.GetHashCode(this);

    private PrintPath With(Vec3[] points, Bead[] beads, Arc?[]? arcs) => Settings(new PrintPath(points, beads, IsClosed, arcs, beads.Length != 1));

    private PrintPath Settings(PrintPath geometry)
        => geometry with { Role = Role, Layer = Layer, Tool = Tool, Name = Name, Color = Color, Overrides = Overrides };

    private static T[] Rotated<T>(T[] items, int first)
    {
        var rotated = new T[items.Length];
        Array.Copy(items, first, rotated, 0, items.Length - first);
        Array.Copy(items, 0, rotated, items.Length - first, first);
        return rotated;
    }
}

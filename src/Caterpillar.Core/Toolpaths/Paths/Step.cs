namespace Caterpillar.Toolpaths;

/// <summary>One entry of a design: a path to print, a drawn travel move, or an event. Every source produces an ordered list of steps.</summary>
public abstract record Step
{
    private protected Step()
    {
    }

    /// <summary>Place in the design: script and line, or curve file and entry. Null if unknown.</summary>
    public SourceLocation? Source { get; init; }

    public static implicit operator Step(PrintPath path) => new PathStep(path);

    public static implicit operator Step(PrinterEvent what) => new EventStep(what);
}

/// <summary>
/// Paths of the same group may be sorted. Groups keep the order in which they first appear: layers from below, islands in each layer, walls before infill in
/// each island.
/// </summary>
/// <param name="Layer">Number of the layer in the whole print.</param>
/// <param name="Island">Number of the island in its layer. Planning may reorder the islands of a layer. Islands below 0 (a skirt) come first and keep their
/// order.</param>
/// <param name="Rank">Rank of the role in its island. The lowest comes first.</param>
public readonly record struct StepGroup(int Layer, int Island = 0, int Rank = 0);

/// <summary>A path to print.</summary>
public sealed record PathStep : Step
{
    /// <summary>A path and the group within which it may be sorted.</summary>
    public PathStep(PrintPath path, StepGroup? group = null) => (Path, Group) = (path, group);

    /// <summary>The path.</summary>
    public PrintPath Path { get; init => field = value ?? throw new ArgumentNullException(nameof(value)); }

    /// <summary>Group for sorting. Null = the path keeps its position.</summary>
    public StepGroup? Group { get; init; }

    /// <summary>True if start and direction of the path are fixed (a selected seam). Sorting may only change its position in the order.</summary>
    public bool KeepStart { get; init; }

    /// <summary>True if the path follows the previous step of the same group directly. Sorting keeps both together.</summary>
    public bool Joined { get; init; }

    /// <summary>True if the wall continues in the layer above (spiral vase). The flow does not stop if nothing comes between.</summary>
    internal bool GoesOn { get; init; }

    /// <summary>Region of the layer, seen from above. Travel moves inside it stay over the part. Null if unknown.</summary>
    public Region? Region { get; init; }

    /// <summary>Line of each segment in the script of <see cref="Step.Source"/>, from 1. Null if unknown, as after a change of the segments.</summary>
    internal int[]? Lines { get => field?.Length == Path.SegmentCount ? field : null; init; }
}

/// <summary>Intent of a drawn travel move.</summary>
public enum TravelIntent : byte
{
    /// <summary>Exactly as drawn.</summary>
    AsDrawn,

    /// <summary>Reach the last point safely. Planning chooses the path (a turtle's pop).</summary>
    Return,
}

/// <summary>A drawn travel move from the current position through these points, mm.</summary>
public sealed record TravelStep : Step
{
    private readonly Vec3[] _points;

    /// <exception cref="ArgumentException">No points, or a point is not finite.</exception>
    public TravelStep(IEnumerable<Vec3> points, double speed = 0, TravelIntent intent = TravelIntent.AsDrawn)
    {
        _points = (points ?? throw new ArgumentNullException(nameof(points))).ToArray();
        if (_points.Length == 0 || !_points.All(p => p.IsFinite)) throw new ArgumentException("A travel move needs one or more finite points.", nameof(points));
        Speed = speed;
        Intent = intent;
    }

    /// <summary>A travel move to a point (mm) at a speed in mm/s. 0 = travel speed of the settings.</summary>
    public TravelStep(Vec3 to, double speed = 0, TravelIntent intent = TravelIntent.AsDrawn)
        : this([to], speed, intent)
    {
    }

    /// <summary>The points, mm.</summary>
    public IReadOnlyList<Vec3> Points => _points;

    /// <summary>Speed, mm/s. 0 = travel speed of the settings.</summary>
    public double Speed { get; }

    /// <summary>Intent of the travel move.</summary>
    public TravelIntent Intent { get; }
}

/// <summary>An event at this position. Sorting never crosses it.</summary>
public sealed record EventStep : Step
{
    /// <summary>An event at its position in the order.</summary>
    public EventStep(PrinterEvent what) => Event = what ?? throw new ArgumentNullException(nameof(what));

    /// <summary>The event.</summary>
    public PrinterEvent Event { get; }
}

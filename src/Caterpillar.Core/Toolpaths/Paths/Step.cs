using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>One entry of a design: a path to deposit, a travel that the designer drew, or an event. Every source ends in an ordered list of steps.</summary>
public abstract class Step
{
    private protected Step()
    {
    }

    /// <summary>Where the design states it: script and line, file of curves and entry; null if unknown.</summary>
    public SourceLocation? Source { get; init; }

    public static implicit operator Step(PrintPath path) => new PathStep(path);

    public static implicit operator Step(PrinterEvent what) => new EventStep(what);
}

/// <summary>
/// Paths of the same group may be sorted among themselves. Groups keep the order in which they first appear: the layers from below, in each layer the
/// islands, in each island walls before infill.
/// </summary>
/// <param name="Layer">Number of the layer in the whole print.</param>
/// <param name="Island">Number of the island in its layer. Planning may take the islands of a layer in another order; those below 0 (a skirt) come first and in
/// their order.</param>
/// <param name="Rank">Rank of the role in its island, lowest first.</param>
public readonly record struct StepGroup(int Layer, int Island = 0, int Rank = 0);

/// <summary>A path to deposit.</summary>
public sealed class PathStep : Step
{
    /// <summary>A path, and the group within which it may be sorted.</summary>
    public PathStep(PrintPath path, StepGroup? group = null)
    {
        Path = path ?? throw new ArgumentNullException(nameof(path));
        Group = group;
    }

    /// <summary>What is laid down.</summary>
    public PrintPath Path { get; }

    /// <summary>Paths of one group may be sorted; without a group the path stays where it is.</summary>
    public StepGroup? Group { get; }

    /// <summary>The start and direction of the path are fixed (a chosen seam): sorting may only change its position in the order.</summary>
    public bool KeepStart { get; init; }

    /// <summary>Printed right after the step before it, which has the same group: sorting moves both as one.</summary>
    public bool Joined { get; init; }

    /// <summary>The wall goes on from its end in the layer above (a vase): where nothing comes between, the flow does not stop there.</summary>
    internal bool GoesOn { get; init; }

    /// <summary>The region that its layer covers, seen from above: travels inside it stay over the part. Null if unknown.</summary>
    public Region? Region { get; init; }

    /// <summary>The line of each segment in the script of <see cref="Step.Source"/>, from 1; null if they are unknown.</summary>
    internal int[]? Lines { get; init; }

    /// <summary>The same step with another path.</summary>
    public PathStep With(PrintPath path) => With(path, Region);

    /// <summary>The same step with another path, in a layer that covers another region.</summary>
    public PathStep With(PrintPath path, Region? region)
        => new(path, Group)
        {
            KeepStart = KeepStart, Joined = Joined, GoesOn = GoesOn, Region = region, Source = Source,
            Lines = path.SegmentCount == Lines?.Length ? Lines : null,
        };
}

/// <summary>The intent of a drawn travel.</summary>
public enum TravelIntent : byte
{
    /// <summary>Exactly as drawn.</summary>
    AsDrawn,

    /// <summary>Reach the last point safely: planning chooses the path (a turtle's pop).</summary>
    Return,
}

/// <summary>A travel that the designer drew: from the current position through these points, mm.</summary>
public sealed class TravelStep : Step
{
    private readonly Vec3[] _points;

    /// <exception cref="ArgumentException">No point, or one that is not finite.</exception>
    public TravelStep(IEnumerable<Vec3> points, double speed = 0, TravelIntent intent = TravelIntent.AsDrawn)
    {
        _points = (points ?? throw new ArgumentNullException(nameof(points))).ToArray();
        if (_points.Length == 0 || !_points.All(p => p.IsFinite)) throw new ArgumentException("A travel move needs one or more finite points.", nameof(points));
        Speed = speed;
        Intent = intent;
    }

    /// <summary>A travel to a point (mm), at a speed in mm/s; 0 for that of the settings.</summary>
    public TravelStep(Vec3 to, double speed = 0, TravelIntent intent = TravelIntent.AsDrawn)
        : this([to], speed, intent)
    {
    }

    /// <summary>Where it goes, mm.</summary>
    public IReadOnlyList<Vec3> Points => _points;

    /// <summary>Speed in mm/s, or 0 for the travel speed of the settings.</summary>
    public double Speed { get; }

    /// <summary>Why the head goes there.</summary>
    public TravelIntent Intent { get; }
}

/// <summary>An event at this position. Sorting never crosses it.</summary>
public sealed class EventStep : Step
{
    /// <summary>An event at its place in the order.</summary>
    public EventStep(PrinterEvent what) => Event = what ?? throw new ArgumentNullException(nameof(what));

    /// <summary>What happens.</summary>
    public PrinterEvent Event { get; }
}

using Caterpillar.Toolpaths;

namespace Caterpillar.Planning;

/// <summary>Counts how often each rule of planning had an effect. Filled while planning runs and not changed afterwards.</summary>
public sealed record PlanReport
{
    /// <summary>Paths printed.</summary>
    public int Paths { get; internal set; }

    /// <summary>Travels between paths that the planner chose, and travels that the designer drew.</summary>
    public int Travels { get; internal set; }

    /// <inheritdoc cref="Travels"/>
    public int DrawnTravels { get; internal set; }

    /// <summary>Travels above everything printed so far.</summary>
    public int Lifts { get; internal set; }

    /// <summary>Travels lifted only above what lies below them.</summary>
    public int CorridorLifts { get; internal set; }

    /// <summary>Travels without a lift: too short, or without an obstacle.</summary>
    public int SkippedLifts { get; internal set; }

    /// <summary>Travels led around printed parts.</summary>
    public int Detours { get; internal set; }

    /// <summary>Travels inside the part, without lift and retraction; and those of them that went around corners.</summary>
    public int Combed { get; internal set; }

    /// <inheritdoc cref="Combed"/>
    public int CombedAround { get; internal set; }

    /// <summary>Retractions, in place or while wiping.</summary>
    public int Retractions { get; internal set; }

    /// <summary>Travels too short for a retraction.</summary>
    public int SkippedRetractions { get; internal set; }

    /// <summary>Travels that began with the filament already retracted.</summary>
    public int AlreadyRetracted { get; internal set; }

    /// <summary>Deretractions of retracted filament.</summary>
    public int Deretractions { get; internal set; }

    /// <summary>Retractions while the head wiped along what it had printed.</summary>
    public int Wipes { get; internal set; }

    /// <summary>Paths whose extrusion was started or stopped early to compensate for the pressure lag.</summary>
    public int LaggedPaths { get; internal set; }

    /// <summary>Changes to another tool.</summary>
    public int ToolChanges { get; internal set; }

    /// <summary>Waits for layers to cool.</summary>
    public int Waits { get; internal set; }

    /// <summary>Returns of a turtle over the top, along the branch, and those whose goal has been printed over.</summary>
    public int ReturnsOver { get; internal set; }

    /// <inheritdoc cref="ReturnsOver"/>
    public int ReturnsAlong { get; internal set; }

    /// <inheritdoc cref="ReturnsOver"/>
    public int BlockedReturns { get; internal set; }

    /// <summary>Segments without length, which were dropped.</summary>
    public int EmptySegments { get; internal set; }

    /// <summary>Length of all travels, mm.</summary>
    public double TravelLength { get; internal set; }

    /// <summary>Travel between the paths in the given order and after sorting, mm.</summary>
    public double UnsortedTravel { get; internal set; }

    /// <inheritdoc cref="UnsortedTravel"/>
    public double SortedTravel { get; internal set; }

    /// <summary>All counts by their key in JSON, in a fixed order; lengths in mm.</summary>
    public IReadOnlyList<KeyValuePair<string, double>> ToValues() =>
    [
        new("paths", Paths), new("travels", Travels), new("drawn_travels", DrawnTravels), new("lifts", Lifts), new("corridor_lifts", CorridorLifts),
        new("skipped_lifts", SkippedLifts), new("detours", Detours), new("combed", Combed), new("combed_around", CombedAround), new("retractions", Retractions),
        new("skipped_retractions", SkippedRetractions),
        new("already_retracted", AlreadyRetracted), new("restores", Deretractions), new("wipes", Wipes), new("lagged_paths", LaggedPaths),
        new("tool_changes", ToolChanges), new("waits", Waits),
        new("returns_over", ReturnsOver), new("returns_along", ReturnsAlong), new("blocked_returns", BlockedReturns), new("empty_segments", EmptySegments),
        new("travel_length_mm", TravelLength), new("unsorted_travel_mm", UnsortedTravel), new("sorted_travel_mm", SortedTravel),
    ];
}

/// <summary>A planned toolpath and the effects of the rules.</summary>
public sealed record Plan(Toolpath Toolpath, PlanReport Report);

namespace Caterpillar.Planning;

/// <summary>Counts of the effects of each rule of planning. Final when planning ends.</summary>
public sealed record PlanReport
{
    /// <summary>Printed paths.</summary>
    public int Paths { get; internal set; }

    /// <summary>Travel moves between paths that the planner added, and travel moves that are part of the design.</summary>
    public int Travels { get; internal set; }

    /// <inheritdoc cref="Travels"/>
    public int DrawnTravels { get; internal set; }

    /// <summary>Travel moves with Z-hop over everything printed so far.</summary>
    public int ZHops { get; internal set; }

    /// <summary>Travel moves with Z-hop over only the print below them.</summary>
    public int LocalZHops { get; internal set; }

    /// <summary>Travel moves without Z-hop: too short, or without an obstacle.</summary>
    public int SkippedZHops { get; internal set; }

    /// <summary>Travel moves around printed parts.</summary>
    public int Detours { get; internal set; }

    /// <summary>Travel moves inside the part, without Z-hop and retraction, and the number of them that go around corners.</summary>
    public int Combed { get; internal set; }

    /// <inheritdoc cref="Combed"/>
    public int CombedAround { get; internal set; }

    /// <summary>Retractions, in place or while wiping.</summary>
    public int Retractions { get; internal set; }

    /// <summary>Travel moves too short for a retraction.</summary>
    public int SkippedRetractions { get; internal set; }

    /// <summary>Travel moves that started with the filament already retracted.</summary>
    public int AlreadyRetracted { get; internal set; }

    /// <summary>Deretractions.</summary>
    public int Deretractions { get; internal set; }

    /// <summary>Retractions during a wipe back along the path.</summary>
    public int Wipes { get; internal set; }

    /// <summary>Paths whose extrusion starts or stops early to compensate for pressure lag.</summary>
    public int LaggedPaths { get; internal set; }

    /// <summary>Tool changes.</summary>
    public int ToolChanges { get; internal set; }

    /// <summary>Waits to let layers cool.</summary>
    public int Waits { get; internal set; }

    /// <summary>Returns of a turtle over the top, along the branch, and to a point that has been printed over.</summary>
    public int ReturnsOver { get; internal set; }

    /// <inheritdoc cref="ReturnsOver"/>
    public int ReturnsAlong { get; internal set; }

    /// <inheritdoc cref="ReturnsOver"/>
    public int BlockedReturns { get; internal set; }

    /// <summary>Segments without length, which were left out.</summary>
    public int EmptySegments { get; internal set; }

    /// <summary>Length of all travel moves, mm.</summary>
    public double TravelLength { get; internal set; }

    /// <summary>Travel length between the paths before and after sorting, mm.</summary>
    public double UnsortedTravel { get; internal set; }

    /// <inheritdoc cref="UnsortedTravel"/>
    public double SortedTravel { get; internal set; }

    /// <summary>All counts by JSON key, in a fixed order; lengths in mm.</summary>
    public IReadOnlyList<KeyValuePair<string, double>> ToValues() =>
    [
        new("paths", Paths), new("travels", Travels), new("drawn_travels", DrawnTravels),
        new("z_hops", ZHops), new("local_z_hops", LocalZHops), new("skipped_z_hops", SkippedZHops),
        new("detours", Detours), new("combed", Combed), new("combed_around", CombedAround),
        new("retractions", Retractions), new("skipped_retractions", SkippedRetractions), new("already_retracted", AlreadyRetracted),
        new("deretractions", Deretractions), new("wipes", Wipes), new("lagged_paths", LaggedPaths),
        new("tool_changes", ToolChanges), new("waits", Waits),
        new("returns_over", ReturnsOver), new("returns_along", ReturnsAlong), new("blocked_returns", BlockedReturns), new("empty_segments", EmptySegments),
        new("travel_length_mm", TravelLength), new("unsorted_travel_mm", UnsortedTravel), new("sorted_travel_mm", SortedTravel),
    ];
}

/// <summary>A planned toolpath and the effects of the rules.</summary>
public sealed record Plan(Toolpath Toolpath, PlanReport Report);

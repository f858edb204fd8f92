using System.Collections.Generic;
using Caterpillar.Toolpaths;

namespace Caterpillar.Planning;

/// <summary>How often each rule of planning had an effect.</summary>
public sealed record PlanReport
{
    /// <summary>Paths printed.</summary>
    public int Paths { get; init; }

    /// <summary>Ways between paths that the planner chose, and that the designer drew.</summary>
    public int Travels { get; init; }

    /// <inheritdoc cref="Travels"/>
    public int DrawnTravels { get; init; }

    /// <summary>Travels above everything printed so far.</summary>
    public int Lifts { get; init; }

    /// <summary>Travels lifted only as far as what lies below the way.</summary>
    public int CorridorLifts { get; init; }

    /// <summary>Travels without a lift: too short, or nothing in the way.</summary>
    public int SkippedLifts { get; init; }

    /// <summary>Travels led around printed parts.</summary>
    public int Detours { get; init; }

    /// <summary>Travels inside the part, without a lift and a retraction.</summary>
    public int Combed { get; init; }

    /// <summary>Retractions, in place or while wiping.</summary>
    public int Retractions { get; init; }

    /// <summary>Travels too short for a retraction.</summary>
    public int SkippedRetractions { get; init; }

    /// <summary>Travels that began with the filament already retracted.</summary>
    public int AlreadyRetracted { get; init; }

    /// <summary>Restores of retracted filament.</summary>
    public int Restores { get; init; }

    /// <summary>Retractions while the head wiped along what it had printed.</summary>
    public int Wipes { get; init; }

    /// <summary>Paths whose extrusion was started or stopped early for the lag of the pressure.</summary>
    public int LaggedPaths { get; init; }

    public int ToolChanges { get; init; }

    /// <summary>Returns of a turtle over the top, back along the branch, and those whose goal has been printed over.</summary>
    public int ReturnsOver { get; init; }

    /// <inheritdoc cref="ReturnsOver"/>
    public int ReturnsAlong { get; init; }

    /// <inheritdoc cref="ReturnsOver"/>
    public int BlockedReturns { get; init; }

    /// <summary>Segments without a length, left out.</summary>
    public int EmptySegments { get; init; }

    /// <summary>Way of all travels, mm.</summary>
    public double TravelLength { get; init; }

    /// <summary>Way that sorting had to cover between the paths as given and as sorted, mm.</summary>
    public double GivenWay { get; init; }

    /// <inheritdoc cref="GivenWay"/>
    public double SortedWay { get; init; }

    /// <summary>All counts by their key in JSON, in a fixed order; lengths in mm.</summary>
    public IReadOnlyList<KeyValuePair<string, double>> ToValues() =>
    [
        new("paths", Paths), new("travels", Travels), new("drawn_travels", DrawnTravels), new("lifts", Lifts), new("corridor_lifts", CorridorLifts),
        new("skipped_lifts", SkippedLifts), new("detours", Detours), new("combed", Combed), new("retractions", Retractions),
            new("skipped_retractions", SkippedRetractions),
        new("already_retracted", AlreadyRetracted), new("restores", Restores), new("wipes", Wipes), new("lagged_paths", LaggedPaths),
            new("tool_changes", ToolChanges),
        new("returns_over", ReturnsOver), new("returns_along", ReturnsAlong), new("blocked_returns", BlockedReturns), new("empty_segments", EmptySegments),
        new("travel_length_mm", TravelLength), new("given_way_mm", GivenWay), new("sorted_way_mm", SortedWay),
    ];
}

/// <summary>A planned toolpath and what the rules did.</summary>
public sealed record Plan(Toolpath Toolpath, PlanReport Report);

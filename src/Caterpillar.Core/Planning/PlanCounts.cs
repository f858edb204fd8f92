namespace Caterpillar.Planning;

/// <summary>The counters behind a <see cref="PlanReport"/>, while planning runs.</summary>
internal sealed class PlanCounts
{
    public int Paths, Travels, DrawnTravels, Lifts, CorridorLifts, SkippedLifts, Detours, Combed, Retractions, SkippedRetractions, AlreadyRetracted, Restores,
        Wipes, LaggedPaths,
        ToolChanges, ReturnsOver, ReturnsAlong, BlockedReturns, EmptySegments;

    public double TravelLength, GivenWay, SortedWay;

    public PlanReport ToReport() => new()
    {
        Paths = Paths,
        Travels = Travels,
        DrawnTravels = DrawnTravels,
        Lifts = Lifts,
        CorridorLifts = CorridorLifts,
        SkippedLifts = SkippedLifts,
        Detours = Detours,
        Combed = Combed,
        Retractions = Retractions,
        SkippedRetractions = SkippedRetractions,
        AlreadyRetracted = AlreadyRetracted,
        Restores = Restores,
        Wipes = Wipes,
        LaggedPaths = LaggedPaths,
        ToolChanges = ToolChanges,
        ReturnsOver = ReturnsOver,
        ReturnsAlong = ReturnsAlong,
        BlockedReturns = BlockedReturns,
        EmptySegments = EmptySegments,
        TravelLength = TravelLength,
        GivenWay = GivenWay,
        SortedWay = SortedWay,
    };
}

namespace Caterpillar.Machines;

// How the head gets from path to path, and what it does while a layer cools.
public sealed partial record PrintSettings
{
    /// <summary>Maximum detour to avoid crossing walls; 0 = straight travel moves only.</summary> <value>mm.</value>
    public double AvoidCrossingMaxDetour { get; init => field = TravelKeys.AvoidCrossingMaxDetour.Check(value); } = 15;

    /// <summary>What to do if a layer takes less than min_layer_time_s even at min_print_speed_mm_s: nothing, wait above it, or wait next to it.</summary>
    public LayerTimeWait LayerTimeWait { get; init; } = LayerTimeWait.None;
}

/// <summary>Keys of print settings: travel moves, and waits for layers to cool.</summary>
internal static class TravelKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly NumberKey AvoidCrossingMaxDetour
        = All.Number("avoid_crossing_max_detour_mm", 0, 10_000, s => s.AvoidCrossingMaxDetour, (s, v) => s with { AvoidCrossingMaxDetour = v });
    public static readonly ProfileKey<PrintSettings, LayerTimeWait> LayerTimeWait
        = All.Choice("layer_time_wait", s => s.LayerTimeWait, (s, v) => s with { LayerTimeWait = v });
}

namespace Caterpillar.Machines;

// How the head gets from path to path, and what it does while a layer cools.
public sealed partial record PrintSettings
{
    /// <summary>Maximum detour to avoid crossing walls; 0 = straight travel moves only.</summary> <value>mm.</value>
    public double AvoidCrossingMaxDetour { get; init => field = Keys.Check(value); } = 15;

    /// <summary>What to do if a layer takes less than min_layer_time_s even at min_print_speed_mm_s: nothing, wait above it, or wait next to it.</summary>
    public LayerTimeWait LayerTimeWait { get; init; } = LayerTimeWait.None;
}

using System.Collections.Generic;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.PrintSettings>;

namespace Caterpillar.Machines;

/// <summary>Keys of print settings: travels and waits.</summary>
internal static class TravelKeys
{
    public static readonly ProfileKey<PrintSettings, double> CombDetour = K.Number(
        "comb_detour_mm", 0, 10_000, s => s.CombDetour, (s, v) => s with { CombDetour = v },
        "So much longer than straight a travel inside the part may be, around its corners, to avoid a retraction; 0 for straight ones only.");

    public static readonly ProfileKey<PrintSettings, LayerWait> LayerWait = K.Choice(
        "layer_wait", s => s.LayerWait, (s, v) => s with { LayerWait = v },
        "What happens where a layer takes less than min_layer_time_s even at min_speed_mm_s: nothing, the head waits above it, or beside it.",
        ("none", Machines.LayerWait.None), ("pause", Machines.LayerWait.Pause), ("away", Machines.LayerWait.Away));

    public static readonly IReadOnlyList<ProfileKey<PrintSettings>> All = [CombDetour, LayerWait];
}

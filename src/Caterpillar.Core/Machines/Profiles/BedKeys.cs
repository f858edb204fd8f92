using System.Collections.Generic;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.PrintSettings>;

namespace Caterpillar.Machines;

/// <summary>Keys of print settings: what is printed around and below a part.</summary>
internal static class BedKeys
{
    public static readonly ProfileKey<PrintSettings, int> SkirtLoops = K.Whole(
        "skirt_loops", 0, 1000, s => s.SkirtLoops, (s, v) => s with { SkirtLoops = v },
        "Loops around the first layer; 0 for none.");

    public static readonly ProfileKey<PrintSettings, double> SkirtDistance = K.Number(
        "skirt_distance_mm", 0, 1000, s => s.SkirtDistance, (s, v) => s with { SkirtDistance = v },
        "Distance of the skirt from the part.");

    public static readonly IReadOnlyList<ProfileKey<PrintSettings>> All =
    [
        SkirtLoops, SkirtDistance,
    ];
}

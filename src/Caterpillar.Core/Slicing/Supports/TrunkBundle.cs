using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>Trunks that touch each other on a level, or a single one. Nothing else is near them.</summary>
/// <param name="trunks">The trunks.</param>
/// <param name="engine">Clips.</param>
internal sealed class TrunkBundle(IReadOnlyList<Trunk> trunks, RegionEngine engine)
{
    public IReadOnlyList<Trunk> Trunks { get; } = trunks;

    /// <summary>What they cover together.</summary>
    public Region Region { get; } = Region.Union(trunks.Select(t => t.Region), engine);

    /// <summary>Divides trunks into those that touch each other.</summary>
    public static List<TrunkBundle> Of(IReadOnlyList<Trunk> trunks, RegionEngine engine)
    {
        var bundles = new List<TrunkBundle>();
        var taken = new bool[trunks.Count];
        for (var first = 0; first < taken.Length; first++)
        {
            if (taken[first]) continue;
            taken[first] = true;
            var members = new List<Trunk> { trunks[first] };
            for (var m = 0; m < members.Count; m++)
            {
                for (var i = first + 1; i < taken.Length; i++)
                {
                    if (taken[i] || members[m].IsApartFrom(trunks[i])) continue;
                    taken[i] = true;
                    members.Add(trunks[i]);
                }
            }
            bundles.Add(new TrunkBundle(members, engine));
        }
        return bundles;
    }
}

namespace Caterpillar.Slicing;

/// <summary>Trunks that touch each other on a level, or a single one. Nothing else is near them.</summary>
/// <param name="Trunks">The trunks.</param>
/// <param name="Region">Area of all trunks.</param>
internal sealed record TrunkBundle(IReadOnlyList<Trunk> Trunks, Region Region)
{
    /// <summary>Divides trunks into those that touch each other, directly or through others.</summary>
    public static List<List<Trunk>> Groups(IReadOnlyList<Trunk> trunks)
    {
        var groups = new List<List<Trunk>>();
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
            groups.Add(members);
        }
        return groups;
    }
}

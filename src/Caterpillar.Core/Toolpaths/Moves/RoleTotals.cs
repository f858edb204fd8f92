namespace Caterpillar.Toolpaths;

/// <summary>Sums over the printing moves of one role.</summary>
/// <param name="Role">The role.</param>
/// <param name="Length">Length of motion, mm.</param>
/// <param name="Area">Mean cross-section of the extrusions, mm². Null if the volume per E of a tool is unknown.</param>
/// <param name="Width">Mean width in mm of extrusions with round sides and the height of their layer. Null if unknown.</param>
internal sealed record RoleTotals(Role Role, double Length, double? Area, double? Width)
{
    /// <summary>The sums of the roles of a toolpath, in the order of roles.</summary>
    public static IReadOnlyList<RoleTotals> Of(Toolpath toolpath)
    {
        var count = Enum.GetValues(typeof(Role)).Length;
        var lengths = new double[count];
        var volumes = new double[count];
        var widths = new double[count];
        var unknown = new bool[count];
        foreach (var move in toolpath.Moves())
        {
            if (move.Kind != MoveKind.Print) continue;
            var (role, length) = ((int)move.Role, move.Length);
            lengths[role] += length;
            if (toolpath.BeadOf(move) is { } bead)
            {
                volumes[role] += toolpath.VolumeOf(move)!.Value;
                widths[role] += length * bead.Width(BeadShape.Stadium);
            }
            else if (length > 0)
            {
                unknown[role] = true;
            }
        }
        var totals = new List<RoleTotals>();
        for (var role = 0; role < count; role++)
        {
            if (lengths[role] == 0) continue;
            totals.Add(unknown[role] ? new RoleTotals((Role)role, lengths[role], null, null)
                : new RoleTotals((Role)role, lengths[role], volumes[role] / lengths[role], widths[role] / lengths[role]));
        }
        return totals;
    }
}

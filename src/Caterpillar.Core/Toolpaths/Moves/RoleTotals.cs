using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>What is printed in one role.</summary>
/// <param name="Role">The role.</param>
/// <param name="Length">Length of motion, mm.</param>
/// <param name="Area">Cross-section of the extrusions in mm², averaged over the length; null if the factor of a tool is unknown.</param>
/// <param name="Width">Width in mm of extrusions with round sides and the height of their layer, averaged and null likewise.</param>
internal sealed record RoleTotals(Role Role, double Length, double? Area, double? Width)
{
    /// <summary>The roles that print, in their order.</summary>
    public static IReadOnlyList<RoleTotals> Of(Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        var count = Enum.GetValues(typeof(Role)).Length;
        var lengths = new double[count];
        var volumes = new double[count];
        var widths = new double[count];
        var unknown = new bool[count];
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var c = toolpath.Blocks[block].Columns;
            var start = toolpath.StartOf(block);
            for (var i = 0; i < c.Count; i++)
            {
                var end = new Vec3(c.X[i], c.Y[i], c.Z[i]);
                if (c.Kind[i] == MoveKind.Print)
                {
                    var role = (int)c.Role[i];
                    var length = c.ArcMoves.Length > 0 && c.TryGetArc(i, out var arc) ? arc.Length(start, end) : start.DistanceTo(end);
                    lengths[role] += length;
                    if (length > 0 && toolpath.VolumePerE(c.Tool[i]) * c.Deposited[i] is >= 0 and < 1e12 and var volume)
                    {
                        volumes[role] += volume;
                        widths[role] += length * new Bead(volume / length, toolpath.ThicknessOf(c.Layer[i])).Width(BeadShape.Stadium);
                    }
                    else if (length > 0)
                    {
                        unknown[role] = true;
                    }
                }
                start = end;
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

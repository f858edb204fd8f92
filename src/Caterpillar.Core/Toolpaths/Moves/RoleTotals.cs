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

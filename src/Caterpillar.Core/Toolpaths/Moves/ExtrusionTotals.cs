using Caterpillar.Geometry;

namespace Caterpillar.Toolpaths;

/// <summary>Sums over the printing moves of a toolpath.</summary>
/// <param name="Length">Length of motion, mm.</param>
/// <param name="Deposited">Deposited material in the units of E of the tools.</param>
/// <param name="Volume">Deposited material in mm³. Null if the volume per E of a tool is unknown.</param>
/// <param name="PartBounds">Bounding box of the part, without skirts, purge lines and prime towers, mm.</param>
internal sealed record ExtrusionTotals(double Length, double Deposited, double? Volume, Bounds PartBounds)
{
    /// <summary>The sums of a toolpath.</summary>
    public static ExtrusionTotals Of(Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        double length = 0, deposited = 0;
        double? volume = 0;
        var box = Bounds.Empty;
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var c = toolpath.Blocks[block].Columns;
            var end = toolpath.StartOf(block);
            for (var i = 0; i < c.Count; i++)
            {
                var start = end;
                end = new Vec3(c.X[i], c.Y[i], c.Z[i]);
                if (c.Kind[i] != MoveKind.Print) continue;
                var turns = c.TryGetArc(i, out var arc);
                length += turns ? arc.Length(start, end) : start.DistanceTo(end);
                deposited += c.Deposited[i];
                if (c.Deposited[i] != 0) volume += toolpath.VolumePerE(c.Tool[i]) * c.Deposited[i];
                if (c.Role[i] is Role.Skirt or Role.Purge or Role.PrimeTower) continue;
                if (!box.Contains(start)) box = box.Include(start);
                if (!box.Contains(end)) box = box.Include(end);
                if (turns) box = box.Include(arc.Bounds(start, end));
            }
        }
        return new ExtrusionTotals(length, deposited, volume, box);
    }
}

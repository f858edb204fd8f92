namespace Caterpillar.Toolpaths;

/// <summary>Sums over all that a toolpath extrudes.</summary>
/// <param name="Length">Length of the printing moves, mm.</param>
/// <param name="Deposited">Deposited material in the units of E of the tools.</param>
/// <param name="Volume">Deposited material in mm³. Null if the volume per E of a tool is unknown.</param>
/// <param name="InPlace">Part of the volume that is deposited while the head does not move, mm³.</param>
/// <param name="PartBounds">Bounding box of the part, without skirts, purge lines and prime towers, mm; of the blobs where nothing else is printed.</param>
internal sealed record ExtrusionTotals(double Length, double Deposited, double? Volume, double InPlace, Bounds PartBounds)
{
    /// <summary>The sums of a toolpath.</summary>
    public static ExtrusionTotals Of(Toolpath toolpath)
    {
        if (toolpath is null) throw new ArgumentNullException(nameof(toolpath));
        double length = 0, deposited = 0, inPlace = 0;
        double? volume = 0;
        Bounds box = Bounds.Empty, blobs = Bounds.Empty;
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var c = toolpath.Blocks[block].Columns;
            var end = toolpath.StartOf(block);
            for (var i = 0; i < c.Count; i++)
            {
                var start = end;
                end = new Vec3(c.X[i], c.Y[i], c.Z[i]);
                deposited += c.Deposited[i];
                if (c.Deposited[i] != 0) volume += toolpath.VolumePerE(c.Tool[i]) * c.Deposited[i];
                if (c.Kind[i] == MoveKind.Prime && c.Role[i] != Role.Purge) blobs = blobs.Include(end);
                if (c.Kind[i] != MoveKind.Print)
                {
                    inPlace += c.Deposited[i] * toolpath.VolumePerE(c.Tool[i]).GetValueOrDefault();
                    continue;
                }
                var turns = c.TryGetArc(i, out var arc);
                length += turns ? arc.Length(start, end) : start.DistanceTo(end);
                if (c.Role[i] is Role.Skirt or Role.Purge or Role.PrimeTower) continue;
                if (!box.Contains(start)) box = box.Include(start);
                if (!box.Contains(end)) box = box.Include(end);
                if (turns) box = box.Include(arc.Bounds(start, end));
            }
        }
        return new ExtrusionTotals(length, deposited, volume, inPlace, box.IsEmpty ? blobs : box);
    }
}

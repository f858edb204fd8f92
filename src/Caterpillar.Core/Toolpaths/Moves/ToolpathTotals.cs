namespace Caterpillar.Toolpaths;

/// <summary>Sums over a toolpath, independent of the machine's accelerations.</summary>
/// <param name="PrintLength">Length of printing motion, mm.</param>
/// <param name="TravelLength">Length of motion without printing, mm.</param>
/// <param name="DepositedE">Deposited material in the units of E of the tools.</param>
/// <param name="DepositedVolume">Deposited material in mm³. Null if the volume per E of a tool is unknown.</param>
/// <param name="PrintMoves">Number of printing moves.</param>
/// <param name="TravelMoves">Number of moves of the head that do not print.</param>
/// <param name="Retractions">Number of retractions, in place or in motion.</param>
/// <param name="PrintBounds">Bounding box of the printing moves, arcs included, mm; of the extrusions in place where there are no others.</param>
/// <param name="AllBounds">Bounding box of the ends of all moves, mm.</param>
public sealed record ToolpathTotals(
    double PrintLength, double TravelLength, double DepositedE, double? DepositedVolume, int PrintMoves, int TravelMoves, int Retractions, Bounds PrintBounds,
        Bounds AllBounds)
{
    /// <summary>Part of the volume that is deposited while the head does not move, mm³, of tools whose volume per E is known.</summary>
    internal double InPlaceVolume { get; private init; }

    /// <summary>Bounding box of the part, without skirts, purge lines and prime towers, mm; of the blobs where nothing else is printed.</summary>
    internal Bounds PartBounds { get; private init; }

    /// <summary>The sums of a toolpath.</summary>
    public static ToolpathTotals Of(Toolpath toolpath)
    {
        double print = 0, travel = 0, deposited = 0, inPlace = 0;
        double? volume = 0;
        int prints = 0, travels = 0, retractions = 0;
        Bounds part = Bounds.Empty, others = Bounds.Empty, blobs = Bounds.Empty, allBounds = Bounds.Empty, partBlobs = Bounds.Empty;
        // Whether the last move has printed, and the part: its end is in their box.
        bool follows = false, wasPart = false;
        (int Tool, double? PerE) last = (-1, null);
        for (var block = 0; block < toolpath.Blocks.Count; block++)
        {
            var c = toolpath.Blocks[block].Columns;
            var end = toolpath.StartOf(block);
            for (var i = 0; i < c.Count; i++)
            {
                var start = end;
                end = new Vec3(c.X[i], c.Y[i], c.Z[i]);
                var turns = c.TryGetArc(i, out var arc);
                var length = turns ? arc.Length(start, end) : start.DistanceTo(end);
                deposited += c.Deposited[i];
                if (c.Tool[i] != last.Tool) last = (c.Tool[i], toolpath.VolumePerE(c.Tool[i]));
                if (c.Deposited[i] != 0) volume += last.PerE * c.Deposited[i];
                if (c.Kind[i] is MoveKind.Retract or MoveKind.Wipe) retractions++;
                if (c.Kind[i] == MoveKind.Prime) blobs = blobs.Include(end);
                if (c.Kind[i] == MoveKind.Prime && c.Role[i] != Role.Purge) partBlobs = partBlobs.Include(end);
                if (length > 0 && !allBounds.Contains(end)) allBounds = allBounds.Include(end);
                if (c.Kind[i] == MoveKind.Print)
                {
                    prints++;
                    print += length;
                    var isPart = c.Role[i] is not (Role.Skirt or Role.Purge or Role.PrimeTower);
                    ref var box = ref isPart ? ref part : ref others;
                    if (!follows || isPart != wasPart) box = box.Include(start);
                    if (!box.Contains(end)) box = box.Include(end);
                    if (turns) box = box.Include(arc.Bounds(start, end));
                    (follows, wasPart) = (true, isPart);
                    continue;
                }
                follows = false;
                inPlace += c.Deposited[i] * last.PerE.GetValueOrDefault();
                if (!(length > 0)) continue;
                travels++;
                travel += length;
            }
        }
        var printBounds = part.Include(others);
        return new ToolpathTotals(
            print, travel, deposited, volume, prints, travels, retractions, printBounds.IsEmpty ? blobs : printBounds, allBounds)
        {
            InPlaceVolume = inPlace, PartBounds = part.IsEmpty ? partBlobs : part,
        };
    }
}

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
    /// <summary>The sums of a toolpath.</summary>
    public static ToolpathTotals Of(Toolpath toolpath)
    {
        double print = 0, travel = 0, deposited = 0;
        double? volume = 0;
        int prints = 0, travels = 0, retractions = 0;
        Bounds printBounds = Bounds.Empty, blobs = Bounds.Empty;
        var allBounds = Bounds.Empty;
        foreach (var move in toolpath.Moves())
        {
            var length = move.Length;
            deposited += move.Deposited;
            if (move.Deposited != 0) volume += toolpath.VolumeOf(move);
            if (move.Kind is MoveKind.Retract or MoveKind.Wipe) retractions++;
            if (move.Kind == MoveKind.Prime) blobs = blobs.Include(move.End);
            if (length > 0) allBounds = allBounds.Include(move.End);
            if (move.Kind == MoveKind.Print)
            {
                prints++;
                print += length;
                printBounds = printBounds.Include(move.Bounds);
            }
            else if (length > 0)
            {
                travels++;
                travel += length;
            }
        }
        return new ToolpathTotals(
            print, travel, deposited, volume, prints, travels, retractions, printBounds.IsEmpty ? blobs : printBounds, allBounds);
    }
}

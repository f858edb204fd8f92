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
    internal double InPlaceVolume { get; init; }

    /// <summary>Bounding box of the part, without skirts, purge lines and prime towers, mm; of the blobs where nothing else is printed.</summary>
    internal Bounds PartBounds { get; init; }

    /// <summary>The sums of a toolpath.</summary>
    public static ToolpathTotals Of(Toolpath toolpath) => toolpath.Totals;
}

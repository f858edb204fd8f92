namespace Caterpillar.GCode;

/// <summary>
/// Counts and sums of a file, with start and end G-code. Lengths are in mm, E is in mm of filament (mm³ in volumetric files), and positions are as written in
/// the file.
/// </summary>
public sealed record DecodeReport
{
    private const int Decimals = 5;

    internal DecodeReport(GCodeInterpreter interpreter)
    {
        var machine = interpreter.Machine;
        Counters = machine.Counters;
        EUsedByTool = machine.Extruders.UsedByTool();
        foreach (var tool in EUsedByTool) EUsed += tool.Value;
        if (machine.State.Extrusion.HasMarlin2E && Math.Abs(Counters.EMarlin2 - Counters.ENet) > 1e-3) EByMarlin2Rule = Counters.EMarlin2;
        var (prints, all) = (new GrowingBox(), new GrowingBox());
        prints.Include(Counters.PrintStarts);
        prints.Include(Counters.PrintEnds);
        all.Include(Counters.PrintEnds);
        all.Include(Counters.TravelEnds);
        (PrintBounds, AllBounds) = (prints.ToBounds(), all.ToBounds());
        EndPosition = machine.State.Head.Written;
        Features = machine.Features.ToList();
        Thumbnails = interpreter.Comments.Thumbnails;
        Setup = FileSetup.In(interpreter.Comments.Settings);
        PrintedLayers = machine.Moves.Layers.CountPrinted();
    }

    /// <summary>The sums of decoding.</summary>
    internal DecodeCounters Counters { get; }

    /// <summary>Number of layers that have extrusions, or of all if none has any. Layers of several objects with the same number count once.</summary>
    internal int PrintedLayers { get; }

    /// <summary>Name of the file, or empty.</summary>
    public string File { get; init; } = "";

    /// <summary>SHA-256 of the unpacked bytes, hexadecimal. Empty if not requested.</summary>
    public string Sha256 { get; init; } = "";

    /// <summary>Length of the unpacked text, bytes.</summary>
    public long Bytes { get; init; }

    /// <summary>E, A, B, A+B, M101 (a switch without E values) or none.</summary>
    public string ExtrusionAxis { get; init; } = "none";

    /// <summary>Number of straight printing moves.</summary>
    public int PrintSegments => Counters.Prints;

    /// <summary>Number of straight moves that do not print.</summary>
    public int TravelSegments => Counters.Travels;

    /// <summary>Number of printing arcs (G2, G3).</summary>
    public int PrintArcs => Counters.PrintArcs;

    /// <summary>Number of arcs (G2, G3) that do not print.</summary>
    public int TravelArcs => Counters.TravelArcs;

    /// <summary>Number of retractions in place by E.</summary>
    public int Retractions => Counters.Retractions;

    /// <summary>Number of firmware retractions (G10).</summary>
    public int FirmwareRetractions => Counters.FirmwareRetractions;

    /// <summary>Length of printing moves, mm.</summary>
    public double PrintLength => Counters.PrintLength;

    /// <summary>Length of moves that do not print, mm.</summary>
    public double TravelLength => Counters.TravelLength;

    /// <summary>False if the file has no E values. The sums of E are then 0 and have no meaning.</summary>
    public bool HasAmounts { get; init; }

    /// <summary>Sum of all changes of E, in its unit.</summary>
    public double ENet => Counters.ENet;

    /// <summary>Filament used: the maximum of the running sum of E of each tool, summed over the tools.</summary>
    public double EUsed { get; init; }

    /// <summary>Filament used by each tool, ascending by tool.</summary>
    public IReadOnlyList<KeyValuePair<int, double>> EUsedByTool { get; init; } = [];

    /// <summary>Sum of E by the rule of Marlin 2 (the last of G90, G91, M82, M83 decides). Null if it does not differ.</summary>
    public double? EByMarlin2Rule { get; init; }

    /// <summary>Bounding box of the ends of printing moves, mm, as written in the file.</summary>
    public Bounds PrintBounds { get; init; }

    /// <summary>Bounding box of the ends of all moves, mm, as written in the file.</summary>
    public Bounds AllBounds { get; init; }

    /// <summary>Final position, mm, as written in the file.</summary>
    public Vec3 EndPosition { get; init; }

    /// <summary>Number of lines with each feature in which flavors differ.</summary>
    public IReadOnlyList<KeyValuePair<string, int>> Features { get; init; } = [];

    /// <summary>True if the file begins with a byte order mark.</summary>
    public bool ByteOrderMark { get; init; }

    /// <summary>The thumbnails in the comments, in order.</summary>
    public IReadOnlyList<Thumbnail> Thumbnails { get; init; } = [];

    /// <summary>The setup in the comments of a file of Caterpillar (<see cref="FileSetup"/>), by key; empty = none.</summary>
    public IReadOnlyList<KeyValuePair<string, string>> Setup { get; init; } = [];

    /// <summary>The report as a JSON object. Sums of E are null if the file has no E values.</summary>
    public string ToJson(string indent = "")
        => "{" + string.Join(",", Entries().Select(e => "\n" + indent + "  \"" + e.Key + "\": " + e.Value)) + "\n" + indent + "}";

    // An object with one entry per line, written without a library so that numbers keep our format.
    private IEnumerable<(string Key, string Value)> Entries()
    {
        yield return ("file", Quoted(File));
        if (Sha256.Length > 0) yield return ("sha256_unpacked", Quoted(Sha256));
        yield return ("bytes_unpacked", NumberFormatter.Format(Bytes));
        yield return ("extrusion_axis", Quoted(ExtrusionAxis));
        yield return ("print_segments", Number(Counters.Prints));
        yield return ("travel_segments", Number(Counters.Travels));
        yield return ("travel_with_retraction", Number(Counters.TravelsWithRetraction));
        yield return ("print_arcs", Number(Counters.PrintArcs));
        yield return ("travel_arcs", Number(Counters.TravelArcs));
        yield return ("print_g0", Number(Counters.PrintsG0));
        yield return ("travel_g1", Number(Counters.TravelsG1));
        yield return ("rapid_moves_g0", Number(Counters.Rapids));
        yield return ("feed_moves_g123", Number(Counters.Feeds));
        yield return ("retractions", Number(Counters.Retractions));
        yield return ("deretractions", Number(Counters.Deretractions));
        yield return ("firmware_retractions", Number(Counters.FirmwareRetractions));
        yield return ("firmware_deretractions", Number(Counters.FirmwareDeretractions));
        yield return ("no_ops", Number(Counters.NoOps));
        yield return ("tool_changes", Number(Counters.ToolChanges));
        yield return ("layer_marks", Number(Counters.LayerMarks));
        yield return ("print_length", Number(Counters.PrintLength));
        yield return ("print_length_xy", Number(Counters.PrintLengthXY));
        yield return ("travel_length", Number(Counters.TravelLength));
        yield return ("e_positive", Amount(Counters.EPositive));
        yield return ("e_negative", Amount(Counters.ENegative));
        yield return ("e_print", Amount(Counters.EPrint));
        yield return ("e_net", Amount(Counters.ENet));
        yield return ("e_used", Amount(EUsed));
        var byTool = EUsedByTool.Select(p => (NumberFormatter.Format(p.Key), Number(p.Value)));
        if (HasAmounts && EUsedByTool.Count > 1) yield return ("e_used_by_tool", Object(byTool));
        if (HasAmounts && EByMarlin2Rule is { } other) yield return ("e_total_marlin2_rule", Number(other));
        yield return ("layers_z", Number(Counters.Heights));
        yield return ("layers_flat", Number(Counters.FlatHeights));
        yield return ("z_changes_of_print", Number(Counters.ZChanges));
        yield return ("print_box", Box(PrintBounds));
        yield return ("all_moves_box", Box(AllBounds));
        yield return ("end_position", Point(EndPosition));
        var features = Features.Select(p => (p.Key, NumberFormatter.Format(p.Value)));
        yield return ("features", Object(ByteOrderMark ? features.Append(("bom", "true")) : features));
        if (Thumbnails.Count > 0)
        {
            var images = Thumbnails.Select(i => Object([("width", Number(i.Width)), ("height", Number(i.Height)), ("format", Quoted(i.Format))]));
            yield return ("thumbnails", "[" + string.Join(", ", images) + "]");
        }
        if (Setup.Count > 0) yield return ("setup", Object(Setup.Select(p => (p.Key, Quoted(p.Value)))));
    }

    private string Amount(double value) => HasAmounts ? Number(value) : "null";

    private static string Quoted(string value) => Newtonsoft.Json.JsonConvert.ToString(value);

    private static string Number(double value) => NumberFormatter.Format(value, Decimals);

    private static string Point(Vec3 p) => "[" + Number(p.X) + ", " + Number(p.Y) + ", " + Number(p.Z) + "]";

    private static string Box(Bounds box) => box.IsEmpty ? "null" : "[" + Point(box.Min) + ", " + Point(box.Max) + "]";

    // On one line.
    private static string Object(IEnumerable<(string Key, string Value)> entries)
        => "{" + string.Join(", ", entries.Select(e => "\"" + e.Key + "\": " + e.Value)) + "}";
}

namespace Caterpillar.GCode;

/// <summary>
/// Counts and sums of a file, with start and end G-code. Lengths are in mm, E is in mm of filament (mm³ in volumetric files), and positions are as written in
/// the file.
/// </summary>
public sealed record DecodeReport
{
    private readonly DecodeCounters _counters;

    internal DecodeReport(DecodeCounters counters) => _counters = counters;

    /// <summary>Name of the file, or empty.</summary>
    public string File { get; init; } = "";

    /// <summary>SHA-256 of the unpacked bytes, hexadecimal. Empty if not requested.</summary>
    public string Sha256 { get; init; } = "";

    /// <summary>Length of the unpacked text, bytes.</summary>
    public long Bytes { get; init; }

    /// <summary>E, A, B, A+B, M101 (a switch without E values) or none.</summary>
    public string ExtrusionAxis { get; init; } = "none";

    /// <summary>Number of straight printing moves.</summary>
    public int PrintSegments => _counters.Prints;

    /// <summary>Number of straight moves that do not print.</summary>
    public int TravelSegments => _counters.Travels;

    /// <summary>Number of travel moves with retraction (wipes).</summary>
    public int TravelsWithRetraction => _counters.TravelsWithRetraction;

    /// <summary>Number of printing arcs (G2, G3).</summary>
    public int PrintArcs => _counters.PrintArcs;

    /// <summary>Number of arcs (G2, G3) that do not print.</summary>
    public int TravelArcs => _counters.TravelArcs;

    /// <summary>Number of printing moves with G0.</summary>
    public int PrintsByG0 => _counters.PrintsG0;

    /// <summary>Number of travel moves without G0.</summary>
    public int TravelsByG1 => _counters.TravelsG1;

    /// <summary>Number of G0 commands.</summary>
    public int RapidMoves => _counters.Rapids;

    /// <summary>Number of G1, G2 and G3 commands.</summary>
    public int FeedMoves => _counters.Feeds;

    /// <summary>Number of retractions in place by E.</summary>
    public int Retractions => _counters.Retractions;

    /// <summary>Number of deretractions in place by E.</summary>
    public int Deretractions => _counters.Deretractions;

    /// <summary>Number of firmware retractions (G10).</summary>
    public int FirmwareRetractions => _counters.FirmwareRetractions;

    /// <summary>Number of firmware deretractions (G11).</summary>
    public int FirmwareDeretractions => _counters.FirmwareDeretractions;

    /// <summary>Number of motion commands that change nothing.</summary>
    public int NoOps => _counters.NoOps;

    /// <summary>Number of tool changes.</summary>
    public int ToolChanges => _counters.ToolChanges;

    /// <summary>Number of comments that start a layer.</summary>
    public int LayerMarks => _counters.LayerMarks;

    /// <summary>Length of printing moves, mm.</summary>
    public double PrintLength => _counters.PrintLength;

    /// <summary>Length of printing moves seen from above, mm.</summary>
    public double PrintLengthXY => _counters.PrintLengthXY;

    /// <summary>Length of moves that do not print, mm.</summary>
    public double TravelLength => _counters.TravelLength;

    /// <summary>False if the file has no E values. The sums of E are then 0 and have no meaning.</summary>
    public bool HasAmounts { get; init; }

    /// <summary>Sum of all increases of E, in its unit.</summary>
    public double EPositive => _counters.EPositive;

    /// <summary>Sum of all decreases of E, in its unit, 0 or negative.</summary>
    public double ENegative => _counters.ENegative;

    /// <summary>E of printing moves, in its unit.</summary>
    public double EPrint => _counters.EPrint;

    /// <summary>Sum of all changes of E, in its unit.</summary>
    public double ENet => _counters.ENet;

    /// <summary>Filament used: the maximum of the running sum of E of each tool, summed over the tools.</summary>
    public double EUsed { get; init; }

    /// <summary>Filament used by each tool, ascending by tool.</summary>
    public IReadOnlyList<KeyValuePair<int, double>> EUsedByTool { get; init; } = [];

    /// <summary>Sum of E by the rule of Marlin 2 (the last of G90, G91, M82, M83 decides). Null if it does not differ.</summary>
    public double? EByMarlin2Rule { get; init; }

    /// <summary>Number of different heights (to 1 µm) at the ends of extrusions.</summary>
    public int Heights => _counters.Heights;

    /// <summary>Number of different heights of level extrusions.</summary>
    public int FlatHeights => _counters.FlatHeights;

    /// <summary>Number of height changes while printing.</summary>
    public int HeightChanges => _counters.ZChanges;

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
    {
        var json = new JsonLines(indent);
        json.Text("file", File);
        if (Sha256.Length > 0) json.Text("sha256_unpacked", Sha256);
        json.Number("bytes_unpacked", Bytes);
        json.Text("extrusion_axis", ExtrusionAxis);
        json.Numbers(Moves());
        if (HasAmounts && EUsedByTool.Count > 1) json.Raw("e_used_by_tool", ByTool());
        if (HasAmounts && EByMarlin2Rule is { } other) json.Raw("e_total_marlin2_rule", JsonLines.Number(other));
        json.Numbers(LayerHeights());
        json.Raw("print_box", JsonLines.Box(PrintBounds));
        json.Raw("all_moves_box", JsonLines.Box(AllBounds));
        json.Raw("end_position", JsonLines.Point(EndPosition));
        json.Raw("features", FeatureObject());
        if (Thumbnails.Count > 0) json.Raw("thumbnails", ThumbnailList());
        if (Setup.Count > 0) json.Raw("setup", Object(Setup.Select(p => (p.Key, JsonLines.Quoted(p.Value)))));
        return json.ToString();
    }

    private KeyValuePair<string, double?>[] Moves() =>
    [
        new("print_segments", PrintSegments),
        new("travel_segments", TravelSegments),
        new("travel_with_retraction", TravelsWithRetraction),
        new("print_arcs", PrintArcs),
        new("travel_arcs", TravelArcs),
        new("print_g0", PrintsByG0),
        new("travel_g1", TravelsByG1),
        new("rapid_moves_g0", RapidMoves),
        new("feed_moves_g123", FeedMoves),
        new("retractions", Retractions),
        new("deretractions", Deretractions),
        new("firmware_retractions", FirmwareRetractions),
        new("firmware_deretractions", FirmwareDeretractions),
        new("no_ops", NoOps),
        new("tool_changes", ToolChanges),
        new("layer_marks", LayerMarks),
        new("print_length", PrintLength),
        new("print_length_xy", PrintLengthXY),
        new("travel_length", TravelLength),
        new("e_positive", Amount(EPositive)),
        new("e_negative", Amount(ENegative)),
        new("e_print", Amount(EPrint)),
        new("e_net", Amount(ENet)),
        new("e_used", Amount(EUsed)),
    ];

    private KeyValuePair<string, double?>[] LayerHeights() =>
    [
        new("layers_z", Heights),
        new("layers_flat", FlatHeights),
        new("z_changes_of_print", HeightChanges),
    ];

    private double? Amount(double value) => HasAmounts ? value : null;

    private string ByTool() => Object(EUsedByTool.Select(p => (NumberFormatter.Format(p.Key), JsonLines.Number(p.Value))));

    private string ThumbnailList() => "[" + string.Join(", ", Thumbnails.Select(image => Object([
        ("width", NumberFormatter.Format(image.Width)),
        ("height", NumberFormatter.Format(image.Height)),
        ("format", JsonLines.Quoted(image.Format))]))) + "]";

    private string FeatureObject()
    {
        var features = Features.Select(p => (p.Key, NumberFormatter.Format(p.Value)));
        return Object(ByteOrderMark ? features.Append(("bom", "true")) : features);
    }

    // On one line.
    private static string Object(IEnumerable<(string Key, string Value)> entries)
        => "{" + string.Join(", ", entries.Select(e => "\"" + e.Key + "\": " + e.Value)) + "}";
}

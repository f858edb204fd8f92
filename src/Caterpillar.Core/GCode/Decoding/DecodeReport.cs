using System.Text;
using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.GCode;

/// <summary>
/// What a file does, in numbers. Lengths in mm, E in mm of filament (mm³ in volumetric files); positions as written in the file. Start and end code are
/// included.
/// </summary>
public sealed record DecodeReport
{
    private readonly DecodeCounters _counters;

    internal DecodeReport(DecodeCounters counters) => _counters = counters;

    /// <summary>Name of the file, or empty.</summary>
    public string File { get; init; } = "";

    /// <summary>SHA-256 of the unpacked bytes in hexadecimal, or empty where it was not asked for.</summary>
    public string Sha256 { get; init; } = "";

    /// <summary>Length of the text, unpacked.</summary>
    public long Bytes { get; init; }

    /// <summary>E, A, B, A+B, M101 (a switch, no amounts) or none.</summary>
    public string ExtrusionAxis { get; init; } = "none";

    /// <summary>Straight moves that print.</summary>
    public int PrintSegments => _counters.Prints;

    /// <summary>Straight moves that do not print.</summary>
    public int TravelSegments => _counters.Travels;

    /// <summary>Travels with negative E (wipes).</summary>
    public int TravelsWithRetract => _counters.TravelsWithRetract;

    /// <summary>G2 and G3 that print.</summary>
    public int PrintArcs => _counters.PrintArcs;

    /// <summary>G2 and G3 that do not print.</summary>
    public int TravelArcs => _counters.TravelArcs;

    /// <summary>Prints by G0, and travels by others.</summary>
    public int PrintsByG0 => _counters.PrintsG0;

    /// <summary>Travels by other commands than G0.</summary>
    public int TravelsByG1 => _counters.TravelsG1;

    /// <summary>Commands G0.</summary>
    public int RapidMoves => _counters.Rapids;

    /// <summary>Commands G1, G2 and G3.</summary>
    public int FeedMoves => _counters.Feeds;

    /// <summary>Retractions in place, by E.</summary>
    public int Retracts => _counters.Retracts;

    /// <summary>Deretractions in place, by E.</summary>
    public int Unretracts => _counters.Unretracts;

    /// <summary>Retractions by the firmware (G10).</summary>
    public int FirmwareRetracts => _counters.FirmwareRetracts;

    /// <summary>Deretractions by the firmware (G11).</summary>
    public int FirmwareUnretracts => _counters.FirmwareUnretracts;

    /// <summary>Commands of motion that change nothing.</summary>
    public int NoOps => _counters.NoOps;

    /// <summary>Changes to another tool.</summary>
    public int ToolChanges => _counters.ToolChanges;

    /// <summary>Comments that start a layer.</summary>
    public int LayerMarks => _counters.LayerMarks;

    /// <summary>Length of printing moves, mm.</summary>
    public double PrintLength => _counters.PrintLength;

    /// <summary>Length of printing moves seen from above, mm.</summary>
    public double PrintLengthXY => _counters.PrintLengthXY;

    /// <summary>Length of moves that do not print, mm.</summary>
    public double TravelLength => _counters.TravelLength;

    /// <summary>False where the file has no amounts of extrusion; then the amounts below are 0 and mean nothing.</summary>
    public bool HasAmounts { get; init; }

    /// <summary>Sum of all increases of E, in its unit.</summary>
    public double EPositive => _counters.EPositive;

    /// <summary>Sum of all decreases of E, in its unit; not positive.</summary>
    public double ENegative => _counters.ENegative;

    /// <summary>E of printing moves, in its unit.</summary>
    public double EPrint => _counters.EPrint;

    /// <summary>Sum of all changes of E, in its unit.</summary>
    public double ENet => _counters.ENet;

    /// <summary>Highest value of the running sum, for each tool by itself, added up: what slicers call filament used.</summary>
    public double EUsed { get; init; }

    /// <summary>The highest value of the running sum of E for each tool, ascending by tool.</summary>
    public IReadOnlyList<KeyValuePair<int, double>> EUsedByTool { get; init; } = [];

    /// <summary>The sum of E by the rule of Marlin 2 (the last of G90, G91, M82, M83 decides) where it differs, else null.</summary>
    public double? EByMarlin2Rule { get; init; }

    /// <summary>Different heights (to 1 µm) at the ends of extrusions; the same of flat extrusions only.</summary>
    public int Heights => _counters.Heights;

    /// <summary>Heights at which a level extrusion is printed.</summary>
    public int FlatHeights => _counters.FlatHeights;

    /// <summary>How often the height of printing changes.</summary>
    public int HeightChanges => _counters.ZChanges;

    /// <summary>Box of the ends of printing moves, mm, as written in the file.</summary>
    public Bounds PrintBounds { get; init; }

    /// <summary>Box of the ends of all moves, mm, as written in the file.</summary>
    public Bounds AllBounds { get; init; }

    /// <summary>Where the file ends, mm, as written in it.</summary>
    public Vec3 EndPosition { get; init; }

    /// <summary>Number of lines with each notation by which flavors differ.</summary>
    public IReadOnlyList<KeyValuePair<string, int>> Features { get; init; } = [];

    /// <summary>The file began with a byte order mark.</summary>
    public bool ByteOrderMark { get; init; }

    /// <summary>The images of the print in its comments, in their order.</summary>
    public IReadOnlyList<Thumbnail> Thumbnails { get; init; } = [];

    /// <summary>The report as a JSON object; amounts are null where the file has none.</summary>
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
        return json.ToString();
    }

    private KeyValuePair<string, double?>[] Moves() =>
    [
        new("print_segments", PrintSegments),
        new("travel_segments", TravelSegments),
        new("travel_with_retraction", TravelsWithRetract),
        new("print_arcs", PrintArcs),
        new("travel_arcs", TravelArcs),
        new("print_g0", PrintsByG0),
        new("travel_g1", TravelsByG1),
        new("rapid_moves_g0", RapidMoves),
        new("feed_moves_g123", FeedMoves),
        new("retractions", Retracts),
        new("deretractions", Unretracts),
        new("firmware_retractions", FirmwareRetracts),
        new("firmware_deretractions", FirmwareUnretracts),
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

    private string ByTool()
    {
        var text = new StringBuilder("{");
        foreach (var pair in EUsedByTool)
            text.Append(text.Length > 1 ? ", " : "").Append('"').Append(NumberFormatter.Format(pair.Key)).Append("\": ").Append(JsonLines.Number(pair.Value));
        return text.Append('}').ToString();
    }

    private string ThumbnailList()
    {
        var text = new StringBuilder("[");
        foreach (var image in Thumbnails)
        {
            text.Append(text.Length > 1 ? ", " : "").Append("{\"width\": ").Append(NumberFormatter.Format(image.Width)).Append(", \"height\": ")
                .Append(NumberFormatter.Format(image.Height));
            text.Append(", \"format\": ").Append(JsonLines.Quoted(image.Format)).Append('}');
        }
        return text.Append(']').ToString();
    }

    private string FeatureObject()
    {
        var text = new StringBuilder("{");
        foreach (var pair in Features)
            text.Append(text.Length > 1 ? ", " : "").Append('"').Append(pair.Key).Append("\": ").Append(NumberFormatter.Format(pair.Value));
        if (ByteOrderMark) text.Append(text.Length > 1 ? ", " : "").Append("\"bom\": true");
        return text.Append('}').ToString();
    }
}

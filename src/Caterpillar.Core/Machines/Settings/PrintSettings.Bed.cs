namespace Caterpillar.Machines;

// What is printed around and below a part.
public sealed partial record PrintSettings
{
    /// <summary>Number of skirt loops; 0 = off.</summary>
    public int SkirtLoops { get; init => field = BedKeys.SkirtLoops.Check(value); }

    /// <summary>Distance of the skirt from the part.</summary> <value>mm.</value>
    public double SkirtDistance { get; init => field = BedKeys.SkirtDistance.Check(value); } = 5;

    /// <summary>Brim width; 0 = off.</summary> <value>mm.</value>
    public double BrimWidth { get; init => field = BedKeys.BrimWidth.Check(value); }

    /// <summary>Brim around the part, inside its holes, both, or only ears at its corners.</summary>
    public BrimType BrimType { get; init; }

    /// <summary>With brim_type=ears: outer corners up to this angle have ears.</summary> <value>Degrees.</value>
    public double BrimEarsMaxAngle { get; init => field = BedKeys.BrimEarsMaxAngle.Check(value); } = 125;

    /// <summary>Brim ears at points of the bed, with any brim_type: a list of [x, y, diameter].</summary> <value>mm.</value>
    public ValueList<BrimEar> BrimEars { get; init => field = BedKeys.BrimEars.Check(value); } = ValueList<BrimEar>.Empty;

    /// <summary>Gap between brim and part.</summary> <value>mm.</value>
    public double BrimGap { get; init => field = BedKeys.BrimGap.Check(value); }

    /// <summary>Whether something is printed on the bed around the part.</summary>
    internal bool HasSkirtOrBrim => SkirtLoops > 0 || BrimWidth > 0 || BrimEars.Count > 0;

    /// <summary>The settings without skirt, brim and ears.</summary>
    internal PrintSettings WithoutSkirtAndBrim => this with { SkirtLoops = 0, BrimWidth = 0, BrimEars = ValueList<BrimEar>.Empty };

    /// <summary>Number of raft layers; 0 = off.</summary>
    public int RaftLayers { get; init => field = BedKeys.RaftLayers.Check(value); }

    /// <summary>Distance by which the raft extends beyond the part.</summary> <value>mm.</value>
    public double RaftExpansion { get; init => field = BedKeys.RaftExpansion.Check(value); } = 3;

    /// <summary>Layer height of the raft; 0 = 75 % of the nozzle diameter.</summary> <value>mm.</value>
    public double RaftLayerHeight { get => OfNozzle(field, 0.3); init => field = BedKeys.RaftLayerHeight.Check(value); }

    /// <summary>Gap between raft and part.</summary> <value>mm.</value>
    public double RaftGap { get; init => field = BedKeys.RaftGap.Check(value); } = 0.2;

    /// <summary>Density of the lower raft layers. The top layer is solid.</summary> <value>%.</value>
    public double RaftDensityPercent { get; init => field = BedKeys.RaftDensityPercent.Check(value); } = 40;
}

/// <summary>Keys of print settings: skirt, brim and raft.</summary>
internal static class BedKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly IntegerKey SkirtLoops = All.Integer("skirt_loops", 0, 1000, s => s.SkirtLoops, (s, v) => s with { SkirtLoops = v });
    public static readonly NumberKey SkirtDistance = All.Number("skirt_distance_mm", 0, 1000, s => s.SkirtDistance, (s, v) => s with { SkirtDistance = v });
    public static readonly NumberKey BrimWidth = All.Number("brim_width_mm", 0, 1000, s => s.BrimWidth, (s, v) => s with { BrimWidth = v });
    public static readonly ProfileKey<PrintSettings, BrimType> BrimType = All.Choice("brim_type", s => s.BrimType, (s, v) => s with { BrimType = v });
    public static readonly NumberKey BrimEarsMaxAngle
        = All.Number("brim_ears_max_angle_deg", 0, 180, s => s.BrimEarsMaxAngle, (s, v) => s with { BrimEarsMaxAngle = v });
    public static readonly ProfileKey<PrintSettings, ValueList<BrimEar>> BrimEars = All.Of(
        "brim_ears_mm",
        new RowsFormat<BrimEar>(["x", "y", "diameter"], 10_000, -100_000, 100_000, BrimEar.Of, e => [e.X, e.Y, e.Diameter], BrimEar.Problem),
        s => s.BrimEars, (s, v) => s with { BrimEars = v });
    public static readonly NumberKey BrimGap = All.Number("brim_gap_mm", 0, 1000, s => s.BrimGap, (s, v) => s with { BrimGap = v });
    public static readonly IntegerKey RaftLayers = All.Integer("raft_layers", 0, 1000, s => s.RaftLayers, (s, v) => s with { RaftLayers = v });
    public static readonly NumberKey RaftExpansion = All.Number("raft_expansion_mm", 0, 1000, s => s.RaftExpansion, (s, v) => s with { RaftExpansion = v });
    public static readonly NumberKey RaftLayerHeight
        = All.NumberOrZero("raft_layer_height_mm", 0.001, 1000, s => s.RaftLayerHeight, (s, v) => s with { RaftLayerHeight = v });
    public static readonly NumberKey RaftGap = All.Number("raft_gap_mm", 0, 1000, s => s.RaftGap, (s, v) => s with { RaftGap = v });
    public static readonly NumberKey RaftDensityPercent
        = All.Number("raft_density_percent", 1, 100, s => s.RaftDensityPercent, (s, v) => s with { RaftDensityPercent = v });
}

namespace Caterpillar.Machines;

// Vase mode, open meshes, rough surfaces and the time of layers.
public sealed partial record PrintSettings
{
    /// <summary>Spiral vase: one wall that rises continuously, on a solid bottom of bottom_layers.</summary>
    public bool SpiralVase { get; init; }

    /// <summary>Minimum flow at the start of the first turn and the end of the last turn of a spiral vase.</summary> <value>%.</value>
    public double SpiralVaseMinFlowPercent { get; init => field = SurfaceKeys.SpiralVaseMinFlowPercent.Check(value); } = 20;

    /// <summary>Ignore contours that do not close, or print them as single walls.</summary>
    public OpenContours OpenContours { get; init; }

    /// <summary>Fuzzy skin: maximum random offset of outer walls; 0 = off.</summary> <value>mm.</value>
    public double FuzzySkinThickness { get; init => field = SurfaceKeys.FuzzySkinThickness.Check(value); }

    /// <summary>Distance between the points of fuzzy skin.</summary> <value>mm.</value>
    public double FuzzySkinPointDistance { get; init => field = SurfaceKeys.FuzzySkinPointDistance.Check(value); } = 0.5;

    /// <summary>Random seed of fuzzy skin.</summary>
    public int FuzzySkinSeed { get; init => field = SurfaceKeys.FuzzySkinSeed.Check(value); } = 1;

    /// <summary>Minimum layer time. Shorter layers are slowed down to cool.</summary> <value>s.</value>
    public double MinLayerTime { get; init => field = SurfaceKeys.MinLayerTime.Check(value); } = 5;

    /// <summary>Minimum speed of layers that are slowed down.</summary> <value>mm/s.</value>
    public double MinPrintSpeed { get; init => field = SurfaceKeys.MinPrintSpeed.Check(value); } = 10;
}

/// <summary>Keys of print settings: spiral vase, open contours, fuzzy skin, layer time.</summary>
internal static class SurfaceKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly FlagKey SpiralVase = All.Boolean("spiral_vase", s => s.SpiralVase, (s, v) => s with { SpiralVase = v });
    public static readonly NumberKey SpiralVaseMinFlowPercent
        = All.Number("spiral_vase_min_flow_percent", 0, 100, s => s.SpiralVaseMinFlowPercent, (s, v) => s with { SpiralVaseMinFlowPercent = v });
    public static readonly ProfileKey<PrintSettings, OpenContours> OpenContours
        = All.Choice("open_contours", s => s.OpenContours, (s, v) => s with { OpenContours = v });
    public static readonly NumberKey FuzzySkinThickness
        = All.Number("fuzzy_skin_thickness_mm", 0, 100, s => s.FuzzySkinThickness, (s, v) => s with { FuzzySkinThickness = v });
    public static readonly NumberKey FuzzySkinPointDistance
        = All.Number("fuzzy_skin_point_distance_mm", 0.01, 100, s => s.FuzzySkinPointDistance, (s, v) => s with { FuzzySkinPointDistance = v });
    public static readonly IntegerKey FuzzySkinSeed
        = All.Integer("fuzzy_skin_seed", 0, 1_000_000_000, s => s.FuzzySkinSeed, (s, v) => s with { FuzzySkinSeed = v });
    public static readonly NumberKey MinLayerTime = All.Number("min_layer_time_s", 0, 10_000, s => s.MinLayerTime, (s, v) => s with { MinLayerTime = v });
    public static readonly NumberKey MinPrintSpeed
        = All.Number("min_print_speed_mm_s", 0.01, 10_000, s => s.MinPrintSpeed, (s, v) => s with { MinPrintSpeed = v });
}

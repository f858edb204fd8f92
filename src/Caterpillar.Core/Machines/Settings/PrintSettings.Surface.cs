using FlagKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.PrintSettings, bool>;
using IntegerKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.PrintSettings, int>;
using NumberKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.PrintSettings, double>;

namespace Caterpillar.Machines;

// Vase mode, open meshes, rough surfaces and the time of layers.
public sealed partial record PrintSettings
{
    /// <summary>One wall that climbs without a seam, on a closed bottom of bottom_layers.</summary>
    public bool Vase { get; init; }

    /// <summary>Least flow at the beginning of the first turn and the end of the last one of a vase.</summary> <value>%.</value>
    public double VaseMinFlowPercent { get; init => field = SurfaceKeys.VaseMinFlowPercent.Check(value); } = 20;

    /// <summary>What becomes of contours that do not close: they are left out, or printed as single walls.</summary>
    public OpenMeshes OpenMeshes { get; init; }

    /// <summary>Outer walls wander in and out at random by up to this much; 0 for smooth walls.</summary> <value>mm.</value>
    public double FuzzySkin { get; init => field = SurfaceKeys.FuzzySkin.Check(value); }

    /// <summary>Distance between the points of rough walls.</summary> <value>mm.</value>
    public double FuzzySkinDistance { get; init => field = SurfaceKeys.FuzzySkinDistance.Check(value); } = 0.5;

    /// <summary>Seed of the random numbers of rough walls.</summary>
    public int FuzzySkinSeed { get; init => field = SurfaceKeys.FuzzySkinSeed.Check(value); } = 1;

    /// <summary>Shortest time for a layer: a smaller one is printed more slowly, so that it can cool.</summary> <value>s.</value>
    public double MinLayerTime { get; init => field = SurfaceKeys.MinLayerTime.Check(value); } = 5;

    /// <summary>No layer is slowed down below this speed.</summary> <value>mm/s.</value>
    public double MinSpeed { get; init => field = SurfaceKeys.MinSpeed.Check(value); } = 10;
}

/// <summary>Keys of print settings: vase mode, open meshes, rough surfaces and the time of layers.</summary>
internal static class SurfaceKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly FlagKey Vase = All.Boolean("vase", s => s.Vase, (s, v) => s with { Vase = v });
    public static readonly NumberKey VaseMinFlowPercent
        = All.Number("vase_min_flow_percent", 0, 100, s => s.VaseMinFlowPercent, (s, v) => s with { VaseMinFlowPercent = v });
    public static readonly ProfileKey<PrintSettings, OpenMeshes> OpenMeshes = All.Choice("open_meshes", s => s.OpenMeshes, (s, v) => s with { OpenMeshes = v });
    public static readonly NumberKey FuzzySkin = All.Number("fuzzy_skin_mm", 0, 100, s => s.FuzzySkin, (s, v) => s with { FuzzySkin = v });
    public static readonly NumberKey FuzzySkinDistance
        = All.Number("fuzzy_skin_distance_mm", 0.01, 100, s => s.FuzzySkinDistance, (s, v) => s with { FuzzySkinDistance = v });
    public static readonly IntegerKey FuzzySkinSeed
        = All.Integer("fuzzy_skin_seed", 0, 1_000_000_000, s => s.FuzzySkinSeed, (s, v) => s with { FuzzySkinSeed = v });
    public static readonly NumberKey MinLayerTime = All.Number("min_layer_time_s", 0, 10_000, s => s.MinLayerTime, (s, v) => s with { MinLayerTime = v });
    public static readonly NumberKey MinSpeed = All.Number("min_speed_mm_s", 0.01, 10_000, s => s.MinSpeed, (s, v) => s with { MinSpeed = v });
}

using System.Collections.Generic;
using K = Caterpillar.Machines.Keys<Caterpillar.Machines.PrintSettings>;

namespace Caterpillar.Machines;

/// <summary>Keys of print settings: vase mode, open meshes, rough surfaces and the time of layers.</summary>
internal static class SurfaceKeys
{
    public static readonly ProfileKey<PrintSettings, bool> Vase = K.Boolean(
        "vase", s => s.Vase, (s, v) => s with { Vase = v },
        "One wall that climbs without a seam, on a closed bottom of bottom_layers.");

    public static readonly ProfileKey<PrintSettings, double> VaseMinFlowPercent = K.Number(
        "vase_min_flow_percent", 0, 100, s => s.VaseMinFlowPercent, (s, v) => s with { VaseMinFlowPercent = v },
        "Least flow at the beginning of the first turn and the end of the last one of a vase.");

    public static readonly ProfileKey<PrintSettings, OpenMeshes> OpenMeshes = K.Choice(
        "open_meshes", s => s.OpenMeshes, (s, v) => s with { OpenMeshes = v },
        "What becomes of contours that do not close: they are left out, or printed as single walls.",
        ("ignore", Machines.OpenMeshes.Ignore), ("walls", Machines.OpenMeshes.Walls));

    public static readonly ProfileKey<PrintSettings, double> FuzzySkin = K.Number(
        "fuzzy_skin_mm", 0, 100, s => s.FuzzySkin, (s, v) => s with { FuzzySkin = v },
        "Outer walls wander in and out at random by up to this much; 0 for smooth walls.");

    public static readonly ProfileKey<PrintSettings, double> FuzzySkinDistance = K.Number(
        "fuzzy_skin_distance_mm", 0.01, 100, s => s.FuzzySkinDistance, (s, v) => s with { FuzzySkinDistance = v },
        "Distance between the points of rough walls.");

    public static readonly ProfileKey<PrintSettings, int> FuzzySkinSeed = K.Integer(
        "fuzzy_skin_seed", 0, 1_000_000_000, s => s.FuzzySkinSeed, (s, v) => s with { FuzzySkinSeed = v },
        "Seed of the random numbers of rough walls.");

    public static readonly ProfileKey<PrintSettings, double> MinLayerTime = K.Number(
        "min_layer_time_s", 0, 10_000, s => s.MinLayerTime, (s, v) => s with { MinLayerTime = v },
        "Shortest time for a layer: a smaller one is printed more slowly, so that it can cool.");

    public static readonly ProfileKey<PrintSettings, double> MinSpeed = K.Number(
        "min_speed_mm_s", 0.01, 10_000, s => s.MinSpeed, (s, v) => s with { MinSpeed = v },
        "No layer is slowed down below this speed.");

    public static readonly IReadOnlyList<ProfileKey<PrintSettings>> All =
    [
        Vase, VaseMinFlowPercent, OpenMeshes, FuzzySkin, FuzzySkinDistance, FuzzySkinSeed, MinLayerTime, MinSpeed,
    ];
}

namespace Caterpillar.Machines;

// Vase mode, open meshes, rough surfaces and the time of layers.
public sealed partial record PrintSettings
{
    /// <summary>One wall that climbs without a seam, on a closed bottom of bottom_layers.</summary>
    public bool Vase { get; init; }

    /// <summary>Least flow at the beginning of the first turn and the end of the last one of a vase, %.</summary>
    public double VaseMinFlowPercent { get; init => field = SurfaceKeys.VaseMinFlowPercent.Check(value); } = 20;

    /// <summary>What becomes of contours that do not close: they are left out, or printed as single walls.</summary>
    public OpenMeshes OpenMeshes { get; init; }

    /// <summary>Outer walls wander in and out at random by up to this much; 0 for smooth walls, mm.</summary>
    public double FuzzySkin { get; init => field = SurfaceKeys.FuzzySkin.Check(value); }

    /// <summary>Distance between the points of rough walls, mm.</summary>
    public double FuzzySkinDistance { get; init => field = SurfaceKeys.FuzzySkinDistance.Check(value); } = 0.5;

    /// <summary>Seed of the random numbers of rough walls.</summary>
    public int FuzzySkinSeed { get; init => field = SurfaceKeys.FuzzySkinSeed.Check(value); } = 1;

    /// <summary>Shortest time for a layer: a smaller one is printed more slowly, so that it can cool (s).</summary>
    public double MinLayerTime { get; init => field = SurfaceKeys.MinLayerTime.Check(value); } = 5;

    /// <summary>No layer is slowed down below this speed, mm/s.</summary>
    public double MinSpeed { get; init => field = SurfaceKeys.MinSpeed.Check(value); } = 10;
}

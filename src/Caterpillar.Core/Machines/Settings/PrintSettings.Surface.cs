namespace Caterpillar.Machines;

// Vase mode, open meshes, rough surfaces and the time of layers.
public sealed partial record PrintSettings
{
    /// <summary>Spiral vase: one wall that rises continuously, on a solid bottom of bottom_layers.</summary>
    public bool SpiralVase { get; init; }

    /// <summary>Minimum flow at the start of the first turn and the end of the last turn of a spiral vase.</summary> <value>%.</value>
    public double SpiralVaseMinFlowPercent { get; init => field = Keys.Check(value); } = 20;

    /// <summary>Ignore contours that do not close, print them as single walls, or print all contours as single walls, on the surface of the model.</summary>
    public OpenContours OpenContours { get; init; }

    /// <summary>Fuzzy skin: maximum random offset of outer walls; 0 = off.</summary> <value>mm.</value>
    public double FuzzySkinThickness { get; init => field = Keys.Check(value); }

    /// <summary>Distance between the points of fuzzy skin.</summary> <value>mm.</value>
    public double FuzzySkinPointDistance { get; init => field = Keys.Check(value); } = 0.5;

    /// <summary>Random seed of fuzzy skin.</summary>
    public int FuzzySkinSeed { get; init => field = Keys.Check(value); } = 1;

    /// <summary>Minimum layer time. Shorter layers are slowed down to cool.</summary> <value>s.</value>
    public double MinLayerTime { get; init => field = Keys.Check(value); } = 5;

    /// <summary>Minimum speed of layers that are slowed down.</summary> <value>mm/s.</value>
    public double MinPrintSpeed { get; init => field = Keys.Check(value); } = 10;
}

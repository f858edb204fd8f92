namespace Caterpillar.Machines;

// Layers that follow a surface.
public sealed partial record PrintSettings
{
    /// <summary>Maximum deviation of curved paths and of the deformed model.</summary> <value>mm.</value>
    public double CurvedTolerance { get; init => field = Keys.Check(value); } = 0.01;

    /// <summary>Maximum change of the gap between curved layers along a move that is longer than half the line width.</summary> <value>% of the gap.</value>
    public double CurvedGapStep { get; init => field = Keys.Check(value); } = 10;

    /// <summary>Minimum thickness of curved layers. Thinner ones are combined; 0 = 0.15 × nozzle diameter, at most half the layer height.</summary>
    /// <value>mm.</value>
    public double CurvedMinGap { get; init => field = Keys.Check(value); }

    /// <summary>Maximum thickness of curved layers. Thicker ones are divided; 0 = 0.75 × nozzle diameter, or the layer height if greater.</summary>
    /// <value>mm.</value>
    public double CurvedMaxGap { get; init => field = Keys.Check(value); }

    /// <summary>Maximum ratio of the thickest to the thinnest extrusion of curved layers. Thinner layers are combined; 0 = any.</summary>
    /// <remarks>2 or more.</remarks>
    public double CurvedMaxGapRatio { get; init => field = Keys.Check(value); }

    /// <summary>Maximum slope of curved layers; 0 = as steep as the print head allows.</summary> <value>Degrees.</value>
    public double CurvedMaxSlope { get; init => field = Keys.Check(value); }
}

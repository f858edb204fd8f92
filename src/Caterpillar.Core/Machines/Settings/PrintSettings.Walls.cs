namespace Caterpillar.Machines;

// How wide walls are, where there are more or fewer of them, and whether paths have arcs.
public sealed partial record PrintSettings
{
    /// <summary>Print one wall in the first layer.</summary>
    public bool OnlyOneWallFirstLayer { get; init; }

    /// <summary>Print one wall around top surfaces. The other walls follow what the layer above covers.</summary>
    /// <remarks>Top surfaces narrower than three line widths keep all walls.</remarks>
    public bool OnlyOneWallTop { get; init; }

    /// <summary>Print one more wall in every other layer.</summary>
    public bool AlternateExtraWall { get; init; }

    /// <summary>Fill overhangs that are no bridges with more walls, printed from the supported side outwards.</summary>
    public bool ExtraWallsOnOverhangs { get; init; }

    /// <summary>Maximum speed of small loops, such as walls of screw holes; 0 = as other walls.</summary> <value>mm/s.</value>
    public double SmallLoopSpeed { get; init => field = Keys.Check(value); }

    /// <summary>Small loops are no longer than a circle of this radius.</summary> <value>mm.</value>
    public double SmallLoopRadius { get; init => field = Keys.Check(value); } = 6.5;

    /// <summary>Let wall widths follow the local thickness (Arachne). Otherwise all walls have the line width, and thinner places stay open.</summary>
    public bool VariableWallWidth { get; init; } = true;

    /// <summary>Minimum width of variable-width walls; 0 = 45 % of their line width. Places thinner than half of it stay open.</summary> <value>mm.</value>
    public double MinWallWidth { get => OfNozzle(field, 0); init => field = Keys.Check(value); }

    /// <summary>Maximum width of variable-width walls; 0 = 180 % of their line width.</summary> <value>mm.</value>
    public double MaxWallWidth { get => OfNozzle(field, 0); init => field = Keys.Check(value); }

    /// <summary>Fit arcs (G2, G3) to the paths of planar layers within this tolerance; 0 = off.</summary>
    /// <value>mm.</value> <remarks>No arc crosses a seam or a change of width or flow. Spiral vases have no arcs.</remarks>
    public double ArcFittingTolerance { get; init => field = Keys.Check(value); }
}

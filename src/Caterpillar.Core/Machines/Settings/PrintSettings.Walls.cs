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
    public double SmallLoopSpeed { get; init => field = WallWidthKeys.SmallLoopSpeed.Check(value); }

    /// <summary>Small loops are no longer than a circle of this radius.</summary> <value>mm.</value>
    public double SmallLoopRadius { get; init => field = WallWidthKeys.SmallLoopRadius.Check(value); } = 6.5;

    /// <summary>Let wall widths follow the local thickness (Arachne). Otherwise all walls have the line width, and thinner places stay open.</summary>
    public bool VariableWallWidth { get; init; } = true;

    /// <summary>Minimum width of variable-width walls; 0 = 45 % of their line width. Places thinner than half of it stay open.</summary> <value>mm.</value>
    public double MinWallWidth { get => OfNozzle(field, 0); init => field = WallWidthKeys.MinWallWidth.Check(value); }

    /// <summary>Maximum width of variable-width walls; 0 = 180 % of their line width.</summary> <value>mm.</value>
    public double MaxWallWidth { get => OfNozzle(field, 0); init => field = WallWidthKeys.MaxWallWidth.Check(value); }

    /// <summary>Fit arcs (G2, G3) to the paths of planar layers within this tolerance; 0 = off.</summary>
    /// <value>mm.</value> <remarks>No arc crosses a seam or a change of width or flow. Spiral vases have no arcs.</remarks>
    public double ArcFittingTolerance { get; init => field = WallWidthKeys.ArcFittingTolerance.Check(value); }
}

/// <summary>Keys of print settings: number and widths of walls, small loops, arc fitting.</summary>
internal static class WallWidthKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly FlagKey OnlyOneWallFirstLayer
        = All.Boolean("only_one_wall_first_layer", s => s.OnlyOneWallFirstLayer, (s, v) => s with { OnlyOneWallFirstLayer = v });
    public static readonly FlagKey OnlyOneWallTop = All.Boolean("only_one_wall_top", s => s.OnlyOneWallTop, (s, v) => s with { OnlyOneWallTop = v });
    public static readonly FlagKey AlternateExtraWall
        = All.Boolean("alternate_extra_wall", s => s.AlternateExtraWall, (s, v) => s with { AlternateExtraWall = v });
    public static readonly FlagKey ExtraWallsOnOverhangs
        = All.Boolean("extra_walls_on_overhangs", s => s.ExtraWallsOnOverhangs, (s, v) => s with { ExtraWallsOnOverhangs = v });
    public static readonly NumberKey SmallLoopSpeed
        = All.Number("small_loop_speed_mm_s", 0, 10_000, s => s.SmallLoopSpeed, (s, v) => s with { SmallLoopSpeed = v });
    public static readonly NumberKey SmallLoopRadius
        = All.Number("small_loop_radius_mm", 0, 1000, s => s.SmallLoopRadius, (s, v) => s with { SmallLoopRadius = v });
    public static readonly FlagKey VariableWallWidth = All.Boolean("variable_wall_width", s => s.VariableWallWidth, (s, v) => s with { VariableWallWidth = v });
    public static readonly NumberKey MinWallWidth
        = All.NozzleSize("min_wall_width_mm", s => s.MinWallWidth, (s, v) => s with { MinWallWidth = v });
    public static readonly NumberKey MaxWallWidth
        = All.NozzleSize("max_wall_width_mm", s => s.MaxWallWidth, (s, v) => s with { MaxWallWidth = v });
    public static readonly NumberKey ArcFittingTolerance
        = All.NumberOrZero("arc_fitting_tolerance_mm", 0.001, 1, s => s.ArcFittingTolerance, (s, v) => s with { ArcFittingTolerance = v });
}

using FlagKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.PrintSettings, bool>;
using NumberKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.PrintSettings, double>;

namespace Caterpillar.Machines;

// How wide walls are, and whether they have arcs.
public sealed partial record PrintSettings
{
    /// <summary>Let wall widths follow the local thickness (Arachne). Otherwise all walls have the line width, and thinner places stay open.</summary>
    public bool VariableWallWidth { get; init; } = true;

    /// <summary>Minimum width of variable-width walls; 0 = 45 % of their line width. Places thinner than half of it stay open.</summary> <value>mm.</value>
    public double MinWallWidth { get => OfNozzle(field, 0); init => field = WallWidthKeys.MinWallWidth.Check(value); }

    /// <summary>Maximum width of variable-width walls; 0 = 180 % of their line width.</summary> <value>mm.</value>
    public double MaxWallWidth { get => OfNozzle(field, 0); init => field = WallWidthKeys.MaxWallWidth.Check(value); }

    /// <summary>Fit arcs (G2, G3) to the walls of planar layers within this tolerance; 0 = off.</summary>
    /// <value>mm.</value> <remarks>No arc crosses a seam or a change of width or flow. Spiral vases have no arcs.</remarks>
    public double ArcFittingTolerance { get; init => field = WallWidthKeys.ArcFittingTolerance.Check(value); }
}

/// <summary>Keys of print settings: wall widths and arc fitting.</summary>
internal static class WallWidthKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly FlagKey VariableWallWidth = All.Boolean("variable_wall_width", s => s.VariableWallWidth, (s, v) => s with { VariableWallWidth = v });
    public static readonly NumberKey MinWallWidth
        = All.NozzleSize("min_wall_width_mm", s => s.MinWallWidth, (s, v) => s with { MinWallWidth = v });
    public static readonly NumberKey MaxWallWidth
        = All.NozzleSize("max_wall_width_mm", s => s.MaxWallWidth, (s, v) => s with { MaxWallWidth = v });
    public static readonly NumberKey ArcFittingTolerance
        = All.NumberOrZero("arc_fitting_tolerance_mm", 0.001, 1, s => s.ArcFittingTolerance, (s, v) => s with { ArcFittingTolerance = v });
}

using FlagKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.PrintSettings, bool>;
using NumberKey = Caterpillar.Machines.ProfileKey<Caterpillar.Machines.PrintSettings, double>;

namespace Caterpillar.Machines;

// How wide walls are, and whether they have arcs.
public sealed partial record PrintSettings
{
    /// <summary>
    /// Walls follow the local thickness: thin places get one extrusion, others an even number that shares what is there. Otherwise all walls have the line
    /// width, and what is too narrow for one stays open.
    /// </summary>
    public bool VariableWallWidth { get; init; } = true;

    /// <summary>Width of the narrowest wall where widths vary; 0 for 45 % of the line width. Places of less than half of it are not printed.</summary>
    /// <value>mm.</value>
    public double MinWallWidth { get; init => field = WallWidthKeys.MinWallWidth.Check(value); }

    /// <summary>Width of the widest wall where widths vary; 0 for 180 % of the line width.</summary> <value>mm.</value>
    public double MaxWallWidth { get; init => field = WallWidthKeys.MaxWallWidth.Check(value); }

    /// <summary>Walls of planar layers become arcs (G2, G3) where they stay within this distance of one; 0 for straight segments only.</summary>
    /// <value>mm.</value> <remarks>No arc crosses a change of width or flow, or a seam; spiral vases have none.</remarks>
    public double ArcFittingTolerance { get; init => field = WallWidthKeys.ArcFittingTolerance.Check(value); }
}

/// <summary>Keys of print settings: how wide walls are, and whether they have arcs.</summary>
internal static class WallWidthKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly FlagKey VariableWallWidth = All.Boolean("variable_wall_width", s => s.VariableWallWidth, (s, v) => s with { VariableWallWidth = v });
    public static readonly NumberKey MinWallWidth
        = All.NumberOrZero("min_wall_width_mm", 0.01, 1000, s => s.MinWallWidth, (s, v) => s with { MinWallWidth = v });
    public static readonly NumberKey MaxWallWidth
        = All.NumberOrZero("max_wall_width_mm", 0.01, 1000, s => s.MaxWallWidth, (s, v) => s with { MaxWallWidth = v });
    public static readonly NumberKey ArcFittingTolerance
        = All.NumberOrZero("arc_fitting_tolerance_mm", 0.001, 1, s => s.ArcFittingTolerance, (s, v) => s with { ArcFittingTolerance = v });
}

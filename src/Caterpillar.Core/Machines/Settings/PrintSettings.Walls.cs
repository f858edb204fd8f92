namespace Caterpillar.Machines;

// How wide walls are, and whether they have arcs.
public sealed partial record PrintSettings
{
    /// <summary>
    /// Walls follow the local thickness: thin places get one strand, others an even number that shares what is there. Otherwise all walls have the line width.
    /// </summary>
    public bool VariableWallWidth { get; init; } = true;

    /// <summary>Width of the narrowest wall where widths vary, mm; 0 for 45 % of the line width.</summary>
    public double MinWallWidth { get; init => field = WallWidthKeys.MinWallWidth.Check(value); }

    /// <summary>Width of the widest wall where widths vary, mm; 0 for 180 % of the line width.</summary>
    public double MaxWallWidth { get; init => field = WallWidthKeys.MaxWallWidth.Check(value); }

    /// <summary>
    /// Runs of straight segments of planar walls that stay within this distance of an arc become that arc, mm; 0 for straight segments only. No arc crosses a
    /// change of width or flow, or a seam; spiral vases have none.
    /// </summary>
    public double WallArcTolerance { get; init => field = WallWidthKeys.WallArcTolerance.Check(value); }
}

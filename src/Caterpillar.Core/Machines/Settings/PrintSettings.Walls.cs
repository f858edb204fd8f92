namespace Caterpillar.Machines;

// How wide walls are.
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
}

namespace Caterpillar.Machines;

// Widths of extrusions by role.
public sealed partial record PrintSettings
{
    /// <summary>Width of all extrusions of the first layer, also of skirt, brim and raft; 0 = as in other layers.</summary> <value>mm.</value>
    public double FirstLayerLineWidth { get => OfNozzle(field, 0); init => field = Keys.Check(value); }

    /// <summary>Width of outer walls; 0 = line width.</summary> <value>mm.</value>
    public double OuterWallLineWidth { get => OfNozzle(field, 0); init => field = Keys.Check(value); }

    /// <summary>Width of inner walls; 0 = line width.</summary> <value>mm.</value>
    public double InnerWallLineWidth { get => OfNozzle(field, 0); init => field = Keys.Check(value); }

    /// <summary>Width of sparse infill; 0 = line width.</summary> <value>mm.</value>
    public double InfillLineWidth { get => OfNozzle(field, 0); init => field = Keys.Check(value); }

    /// <summary>Width of top surfaces; 0 = solid_infill_line_width_mm.</summary> <value>mm.</value>
    public double TopSurfaceLineWidth { get => OfNozzle(field, 0); init => field = Keys.Check(value); }

    /// <summary>Width of supports; 0 = line width.</summary> <value>mm.</value>
    public double SupportLineWidth { get => OfNozzle(field, 0); init => field = Keys.Check(value); }

    /// <summary>Width in mm of extrusions with a width of their own (0 = line width); in the first layer that of the first layer.</summary>
    internal double WidthOf(double own, bool firstLayer) => firstLayer && FirstLayerLineWidth > 0 ? FirstLayerLineWidth : own > 0 ? own : LineWidth;
}

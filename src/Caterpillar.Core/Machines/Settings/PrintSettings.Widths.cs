namespace Caterpillar.Machines;

// Widths of extrusions by role.
public sealed partial record PrintSettings
{
    /// <summary>Width of all extrusions of the first layer, also of skirt, brim and raft; 0 = as in other layers.</summary> <value>mm.</value>
    public double FirstLayerLineWidth { get => OfNozzle(field, 0); init => field = WidthKeys.FirstLayerLineWidth.Check(value); }

    /// <summary>Width of outer walls; 0 = line width.</summary> <value>mm.</value>
    public double OuterWallLineWidth { get => OfNozzle(field, 0); init => field = WidthKeys.OuterWallLineWidth.Check(value); }

    /// <summary>Width of inner walls; 0 = line width.</summary> <value>mm.</value>
    public double InnerWallLineWidth { get => OfNozzle(field, 0); init => field = WidthKeys.InnerWallLineWidth.Check(value); }

    /// <summary>Width of sparse infill; 0 = line width.</summary> <value>mm.</value>
    public double InfillLineWidth { get => OfNozzle(field, 0); init => field = WidthKeys.InfillLineWidth.Check(value); }

    /// <summary>Width of top surfaces; 0 = solid_infill_line_width_mm.</summary> <value>mm.</value>
    public double TopSurfaceLineWidth { get => OfNozzle(field, 0); init => field = WidthKeys.TopSurfaceLineWidth.Check(value); }

    /// <summary>Width of supports; 0 = line width.</summary> <value>mm.</value>
    public double SupportLineWidth { get => OfNozzle(field, 0); init => field = WidthKeys.SupportLineWidth.Check(value); }

    /// <summary>Width in mm of extrusions with a width of their own (0 = line width); in the first layer that of the first layer.</summary>
    internal double WidthOf(double own, bool firstLayer) => firstLayer && FirstLayerLineWidth > 0 ? FirstLayerLineWidth : own > 0 ? own : LineWidth;
}

/// <summary>Keys of print settings: widths by role.</summary>
internal static class WidthKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    public static readonly NumberKey FirstLayerLineWidth
        = All.NozzleSize("first_layer_line_width_mm", s => s.FirstLayerLineWidth, (s, v) => s with { FirstLayerLineWidth = v });
    public static readonly NumberKey OuterWallLineWidth
        = All.NozzleSize("outer_wall_line_width_mm", s => s.OuterWallLineWidth, (s, v) => s with { OuterWallLineWidth = v });
    public static readonly NumberKey InnerWallLineWidth
        = All.NozzleSize("inner_wall_line_width_mm", s => s.InnerWallLineWidth, (s, v) => s with { InnerWallLineWidth = v });
    public static readonly NumberKey InfillLineWidth
        = All.NozzleSize("infill_line_width_mm", s => s.InfillLineWidth, (s, v) => s with { InfillLineWidth = v });
    public static readonly NumberKey TopSurfaceLineWidth
        = All.NozzleSize("top_surface_line_width_mm", s => s.TopSurfaceLineWidth, (s, v) => s with { TopSurfaceLineWidth = v });
    public static readonly NumberKey SupportLineWidth
        = All.NozzleSize("support_line_width_mm", s => s.SupportLineWidth, (s, v) => s with { SupportLineWidth = v });
}

namespace Caterpillar.Slicing;

/// <summary>
/// What walls are to be like. Lengths in mm. A bead of a width covers a spacing, its area over the thickness of the layer: so far apart do neighbors lie that
/// fill the layer. For a stadium that is less than the width, and what the round sides of the outermost beads leave open at the outline is <see cref="Edge"/>.
/// </summary>
internal sealed record WallRules
{
    /// <summary>How far chords of round inner corners may be from the arc, as a share of its radius: in short ones a printer is slow.</summary>
    public const double Rounding = 0.1;

    /// <summary>Walls along each contour.</summary>
    public int Count { get; init; } = 2;

    public double OuterWidth { get; init; } = 0.45;

    public double InnerWidth { get; init; } = 0.45;

    /// <summary>Thickness of the layer.</summary>
    public double Thickness { get; init; } = 0.2;

    public BeadShape Shape { get; init; } = BeadShape.Stadium;

    /// <summary>True if widths follow the local thickness. Otherwise all walls have their nominal width, and narrower places stay open.</summary>
    public bool VariableWidth { get; init; } = true;

    /// <summary>Inner corners of walls that are not seen, and of what they leave: a printer nearly stops at a point.</summary>
    public JoinStyle Corners { get; init; }

    /// <summary>The narrowest bead that prints well.</summary>
    public double MinWidth { get; init; } = 0.2;

    /// <summary>The widest bead that prints well.</summary>
    public double MaxWidth { get; init; } = 0.8;

    /// <summary>How far outer walls may deviate from their exact course, so that vertices are saved.</summary>
    public double Tolerance { get; init; } = 0.002;

    /// <summary>The same of walls that are not seen.</summary>
    public double InnerTolerance { get; init; } = 0.0125;

    /// <summary>The walls of print settings, in a layer of a thickness, which may be the first.</summary>
    public static WallRules Of(PrintSettings settings, double thickness, bool first = false)
    {
        var (outer, inner) = (settings.WidthOf(settings.OuterWallLineWidth, first), settings.WidthOf(settings.InnerWallLineWidth, first));
        var (least, most) = (Math.Min(outer, inner), Math.Max(outer, inner));
        return new WallRules
        {
            Count = settings.WallCount, OuterWidth = outer, InnerWidth = inner, Thickness = thickness, Shape = settings.BeadShape,
            VariableWidth = settings.VariableWallWidth,
            MinWidth = settings.MinWallWidth > 0 ? Math.Min(settings.MinWallWidth, least) : least * 0.45,
            MaxWidth = settings.MaxWallWidth > 0 ? Math.Max(settings.MaxWallWidth, most) : most * 1.8,
            InnerTolerance = settings.Resolution,
            // What round corners leave open beside the walls is no matter where infill does.
            Corners = settings.InfillDensityPercent < 100 ? JoinStyle.Round : JoinStyle.Miter,
        };
    }

    public double OuterSpacing => Spacing(OuterWidth);

    public double InnerSpacing => Spacing(InnerWidth);

    /// <summary>Distance from the outline to where spacings begin to count.</summary>
    public double Edge => (OuterWidth - OuterSpacing) / 2;

    /// <summary>Cross-section in mm² of a bead of a width.</summary>
    public double Area(double width) => Shape switch
    {
        BeadShape.Rectangle => width * Thickness,
        // Narrower than high, an extrusion is round.
        BeadShape.Stadium => width >= Thickness ? width * Thickness - (1 - Math.PI / 4) * Thickness * Thickness : Math.PI / 4 * width * width,
        _ => Math.PI / 4 * width * width,
    };

    /// <summary>What a bead of a width covers.</summary>
    public double Spacing(double width) => Area(width) / Thickness;

    /// <summary>The width of the bead that covers a spacing.</summary>
    public double Width(double spacing)
    {
        if (Shape == BeadShape.Rectangle) return spacing;
        var round = 2 * Math.Sqrt(spacing * Thickness / Math.PI);
        if (Shape == BeadShape.Circle) return round;
        var width = spacing + (1 - Math.PI / 4) * Thickness;
        return width >= Thickness ? width : round;
    }
}

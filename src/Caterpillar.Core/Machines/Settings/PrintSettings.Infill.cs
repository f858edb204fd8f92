namespace Caterpillar.Machines;

// What fills the inside of a part.
public sealed partial record PrintSettings
{
    /// <summary>Infill pattern.</summary>
    public InfillPattern InfillPattern { get; init; }

    /// <summary>Rotation of infill lines from layer to layer.</summary> <value>Degrees.</value>
    public double InfillRotation { get; init => field = InfillKeys.InfillRotation.Check(value); } = 90;

    /// <summary>With infill_pattern=formula: extrusions follow the zero set of this formula in x, y, z (mm), layer, spacing and width.</summary>
    public string InfillFormula { get; init => field = InfillKeys.InfillFormula.Check(value); } = "";

    /// <summary>
    /// With infill_pattern=curves: curves that fill every layer, as points [curve, x, y] on the bed. slice --infill-curves reads them from a file.
    /// </summary>
    /// <value>mm.</value>
    public ValueList<InfillPoint> InfillCurves { get; init => field = InfillKeys.InfillCurves.Check(value); } = ValueList<InfillPoint>.Empty;

    /// <summary>Combine the infill of this many layers into one thicker layer.</summary>
    public int CombineInfillLayers { get; init => field = InfillKeys.CombineInfillLayers.Check(value); } = 1;

    /// <summary>Length along the wall by which free ends of sparse infill lines are anchored; 0 = not anchored.</summary>
    /// <value>mm.</value> <remarks>At most half of the distance to the next line.</remarks>
    public double InfillAnchor { get; init => field = InfillKeys.InfillAnchor.Check(value); }

    /// <summary>Maximum length along the wall that joins two sparse infill lines; 0 = twice their distance.</summary> <value>mm.</value>
    public double InfillAnchorMax { get; init => field = InfillKeys.InfillAnchorMax.Check(value); }

    /// <summary>Print the infill of an island before its walls.</summary>
    public bool InfillFirst { get; init; }
}

/// <summary>Keys of print settings: infill.</summary>
internal static class InfillKeys
{
    public static readonly KeyTable<PrintSettings> All = new();

    /// <summary>Patterns for solid infill.</summary>
    public static readonly InfillPattern[] Solid =
        [Machines.InfillPattern.Monotonic, Machines.InfillPattern.Lines, Machines.InfillPattern.Concentric, Machines.InfillPattern.Hilbert];

    public static readonly ProfileKey<PrintSettings, InfillPattern> InfillPattern
        = All.Choice("infill_pattern", s => s.InfillPattern, (s, v) => s with { InfillPattern = v });
    public static readonly NumberKey InfillRotation
        = All.Number("infill_rotation_deg", -360, 360, s => s.InfillRotation, (s, v) => s with { InfillRotation = v });
    public static readonly ProfileKey<PrintSettings, string> InfillFormula
        = All.Of("infill_formula", new FormulaFormat("x", "y", "z", "layer", "spacing", "width"), s => s.InfillFormula, (s, v) => s with { InfillFormula = v });
    public static readonly ProfileKey<PrintSettings, ValueList<InfillPoint>> InfillCurves = All.Of(
        "infill_curves_mm", new RowsFormat<InfillPoint>(["curve", "x", "y"], 1_000_000, -100_000, 100_000, InfillPoint.Of, p => [p.Curve, p.X, p.Y]),
        s => s.InfillCurves, (s, v) => s with { InfillCurves = v });
    public static readonly IntegerKey CombineInfillLayers
        = All.Integer("combine_infill_layers", 1, 1000, s => s.CombineInfillLayers, (s, v) => s with { CombineInfillLayers = v });
    public static readonly NumberKey InfillAnchor = All.Number("infill_anchor_mm", 0, 1000, s => s.InfillAnchor, (s, v) => s with { InfillAnchor = v });
    public static readonly NumberKey InfillAnchorMax
        = All.NumberOrZero("infill_anchor_max_mm", 0.01, 1000, s => s.InfillAnchorMax, (s, v) => s with { InfillAnchorMax = v });
    public static readonly FlagKey InfillFirst = All.Boolean("infill_before_walls", s => s.InfillFirst, (s, v) => s with { InfillFirst = v });
}

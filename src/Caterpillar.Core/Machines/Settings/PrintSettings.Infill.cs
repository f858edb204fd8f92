namespace Caterpillar.Machines;

// What fills the inside of a part.
public sealed partial record PrintSettings
{
    /// <summary>Infill pattern.</summary>
    public InfillPattern InfillPattern { get; init; }

    /// <summary>Rotation of infill lines from layer to layer.</summary> <value>Degrees.</value>
    public double InfillRotation { get; init => field = Keys.Check(value); } = 90;

    /// <summary>With infill_pattern=formula: extrusions follow the zero set of this formula in x, y, z (mm), layer, spacing and width.</summary>
    public string InfillFormula { get; init => field = Keys.Check(value); } = "";

    /// <summary>
    /// With infill_pattern=curves: curves that fill every layer, as points [curve, x, y] on the bed. slice --infill-curves reads them from a file.
    /// </summary>
    /// <value>mm.</value>
    public ValueList<InfillPoint> InfillCurves { get; init => field = Keys.Check(value); } = ValueList<InfillPoint>.Empty;

    /// <summary>Combine the infill of this many layers into one thicker layer.</summary>
    public int CombineInfillLayers { get; init => field = Keys.Check(value); } = 1;

    /// <summary>Length along the wall by which free ends of sparse infill lines are anchored; 0 = not anchored.</summary>
    /// <value>mm.</value> <remarks>At most half of the distance to the next line.</remarks>
    public double InfillAnchor { get; init => field = Keys.Check(value); }

    /// <summary>Maximum length along the wall that joins two sparse infill lines; 0 = twice their distance.</summary> <value>mm.</value>
    public double InfillAnchorMax { get; init => field = Keys.Check(value); }

    /// <summary>Print the infill of an island before its walls.</summary>
    public bool InfillFirst { get; init; }
}

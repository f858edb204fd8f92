using Caterpillar.Basics;

namespace Caterpillar.Machines;

// What fills the inside of a part.
public sealed partial record PrintSettings
{
    /// <summary>What the lines of the infill look like.</summary>
    public InfillPattern InfillPattern { get; init; }

    /// <summary>By how much the direction of the infill turns from layer to layer, degrees.</summary>
    public double InfillTurn { get; init => field = InfillKeys.InfillTurn.Check(value); } = 90;

    /// <summary>For the pattern formula: the strands run where this formula in x, y, z (mm), layer, spacing and width is zero.</summary>
    public string InfillFormula { get; init => field = InfillKeys.InfillFormula.Check(value); } = "";

    /// <summary>For the pattern curves: the points of the strands of each layer, which are cut at its walls.</summary>
    public ValueList<InfillPoint> InfillCurves { get; init => field = InfillKeys.InfillCurves.Check(value); } = ValueList<InfillPoint>.Empty;

    /// <summary>The infill of so many layers is printed at once, as thick as all of them.</summary>
    public int InfillEvery { get; init => field = InfillKeys.InfillEvery.Check(value); } = 1;

    /// <summary>The infill of an island is printed before its walls.</summary>
    public bool InfillFirst { get; init; }
}

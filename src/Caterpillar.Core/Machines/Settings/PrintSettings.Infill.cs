namespace Caterpillar.Machines;

// What fills the inside of a part.
public sealed partial record PrintSettings
{
    /// <summary>What the lines of the infill look like.</summary>
    public InfillPattern InfillPattern { get; init; }

    /// <summary>By how much the direction of the infill turns from layer to layer, degrees.</summary>
    public double InfillTurn { get; init => field = InfillKeys.InfillTurn.Check(value); } = 90;
}

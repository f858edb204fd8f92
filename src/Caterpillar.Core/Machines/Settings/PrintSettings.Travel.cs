namespace Caterpillar.Machines;

// How the head gets from path to path, and what it does while a layer cools.
public sealed partial record PrintSettings
{
    /// <summary>So much longer than straight a travel inside the part may be to avoid a retraction, mm.</summary>
    public double CombDetour { get; init => field = TravelKeys.CombDetour.Check(value); } = 15;

    /// <summary>What the machine does where a layer is too quick even at the least speed.</summary>
    public LayerWait LayerWait { get; init; } = LayerWait.None;
}

namespace Caterpillar.Machines;

// What is printed around and below a part.
public sealed partial record PrintSettings
{
    /// <summary>Loops around the first layer; 0 for none.</summary>
    public int SkirtLoops { get; init => field = BedKeys.SkirtLoops.Check(value); }

    /// <summary>Distance of the skirt from the part, mm.</summary>
    public double SkirtDistance { get; init => field = BedKeys.SkirtDistance.Check(value); } = 5;
}

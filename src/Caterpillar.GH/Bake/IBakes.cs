namespace Caterpillar.GH.Bake;

/// <summary>Something that is baked as several objects.</summary>
internal interface IBakes
{
    IEnumerable<BakedPart> ToParts(DocumentUnits units);
}

namespace Caterpillar.GH.Bake;

/// <summary>Something that is baked as several objects.</summary>
internal interface IBakes
{
    void BakeTo(Baker baker);
}

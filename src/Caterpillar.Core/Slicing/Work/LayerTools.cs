namespace Caterpillar.Slicing;

/// <summary>What one worker needs for any layer; it keeps its arrays from layer to layer.</summary>
internal sealed class LayerTools
{
    public LayerTools() => (Infill, Strips) = (new InfillFiller(Engine), new VaryingOffset(Engine));

    public RegionEngine Engine { get; } = new();

    public InfillFiller Infill { get; }

    public VaryingOffset Strips { get; }
}

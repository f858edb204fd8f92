namespace Caterpillar.Curved;

/// <summary>The curved layers of all models, and the field that they follow.</summary>
public sealed class CurvedResult : SliceResult
{
    internal CurvedResult(IReadOnlyList<SlicedLayer> layers, LayerField field) : base(layers) => Field = field;

    /// <summary>The field, fitted to the part. The layers are its level sets.</summary>
    public LayerField Field { get; }
}

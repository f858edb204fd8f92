using Caterpillar.Slicing;

namespace Caterpillar.Curved;

/// <summary>The layers of all objects, and the field that they follow.</summary>
public sealed class CurvedResult : SliceResult
{
    internal CurvedResult(IReadOnlyList<SlicedLayer> layers, LayerField field) : base(layers) => Field = field;

    /// <summary>The field whose level sets the layers are, fitted to the part.</summary>
    public LayerField Field { get; }
}

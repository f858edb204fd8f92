using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>A model with its layers.</summary>
internal sealed class Body(NamedMesh model, int number)
{
    public NamedMesh Model { get; } = model;

    public int Number { get; } = number;

    public SourceLocation Source { get; } = new(model.Name);

    /// <summary>From the bed up.</summary>
    public LayerWork[] Layers { get; set; } = [];
}

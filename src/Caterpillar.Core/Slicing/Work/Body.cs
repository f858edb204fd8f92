namespace Caterpillar.Slicing;

/// <summary>A model with its layers.</summary>
internal sealed class Body(NamedMesh model, int number, CancellationToken cancel = default)
{
    public NamedMesh Model { get; } = model;

    public int Number { get; } = number;

    public SourceLocation Source { get; } = new(model.Name);

    /// <summary>Cancels the work on its layers.</summary>
    public CancellationToken Cancel { get; } = cancel;

    /// <summary>Held while its trees are grown: any layer may ask for them.</summary>
    public object Gate { get; } = new();

    /// <summary>The trees of lightning infill in each layer, once they were asked for.</summary>
    public IReadOnlyList<Polyline>[]? Trees { get; set; }

    /// <summary>The lines that take the place of the infill's pattern in a layer of a height, mm.</summary>
    public Func<double, IReadOnlyList<Polyline>>? InfillLines { get; set; }

    /// <summary>From the bed up.</summary>
    public LayerWork[] Layers { get; set; } = [];
}

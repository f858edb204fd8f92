using System;
using System.Collections.Generic;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Geometry;

namespace Caterpillar.Slicing;

/// <summary>A model with its layers.</summary>
internal sealed class Body(NamedMesh model, int number, CancellationToken cancel = default)
{
    private IReadOnlyList<Polyline>[]? _lightning;

    public NamedMesh Model { get; } = model;

    public int Number { get; } = number;

    public SourceLocation Source { get; } = new(model.Name);

    /// <summary>The trees of each layer. Grown when they are first asked for, by when all layers have their outlines.</summary>
    public IReadOnlyList<Polyline>[] Lightning
    {
        get
        {
            lock (Source) return _lightning ??= LightningPlan.Of(this, cancel);
        }
    }

    /// <summary>The user's curves for the infill of a layer of a height, mm.</summary>
    public Func<double, IReadOnlyList<Polyline>>? InfillCurves { get; set; }

    /// <summary>From the bed up.</summary>
    public LayerWork[] Layers { get; set; } = [];
}

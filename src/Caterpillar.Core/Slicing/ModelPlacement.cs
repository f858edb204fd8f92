using System;
using System.Collections.Generic;
using System.Linq;
using Caterpillar.Geometry;
using Caterpillar.Machines;

namespace Caterpillar.Slicing;

/// <summary>Puts models on the bed.</summary>
public static class ModelPlacement
{
    /// <summary>All models moved together, so that they stand on the bed of a printer, in its middle.</summary>
    public static IReadOnlyList<NamedMesh> OnBed(this IReadOnlyList<NamedMesh> models, Printer printer)
        => OnBed(models, (printer ?? throw new ArgumentNullException(nameof(printer))).BuildBounds.Center);

    /// <summary>All models moved together, so that the lowest point stands on Z = 0 and the middle of their box is at a point of the bed.</summary>
    public static IReadOnlyList<NamedMesh> OnBed(this IReadOnlyList<NamedMesh> models, Vec3 center)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        var box = Bounds.Empty;
        foreach (var model in models) box = box.Include(model.Mesh.Bounds);
        if (box.IsEmpty) return models;
        var shift = new Vec3(center.X - box.Center.X, center.Y - box.Center.Y, -box.Min.Z);
        return models.Select(m => new NamedMesh(m.Name, m.Mesh.Moved(shift))).ToArray();
    }
}

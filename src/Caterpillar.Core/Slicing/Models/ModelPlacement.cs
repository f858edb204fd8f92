namespace Caterpillar.Slicing;

/// <summary>
/// Scales, rotates and places models on the bed. Every method returns new models and keeps its input unchanged. Lengths are in mm, and Z = 0 is the bed.
/// </summary>
public static class ModelPlacement
{
    /// <summary>Moves all models together onto the bed of a printer, centered.</summary>
    public static IReadOnlyList<NamedMesh> OnBed(this IReadOnlyList<NamedMesh> models, Printer printer)
        => OnBed(models, (printer ?? throw new ArgumentNullException(nameof(printer))).BuildBounds.Center);

    /// <summary>Moves all models together, with their lowest point at Z = 0 and the center of their bounding box at a point of the bed.</summary>
    public static IReadOnlyList<NamedMesh> OnBed(this IReadOnlyList<NamedMesh> models, Vec3 center)
    {
        var box = BoxOf(models);
        if (box.IsEmpty) return models;
        return Moved(models, new Vec3(center.X - box.Center.X, center.Y - box.Center.Y, -box.Min.Z));
    }

    /// <summary>Moves all models by a vector, mm.</summary>
    public static IReadOnlyList<NamedMesh> Moved(this IReadOnlyList<NamedMesh> models, Vec3 shift) => Each(models, m => m.Moved(shift));

    /// <summary>Scales all models together about the bottom center of their bounding box.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A factor is not above 0.</exception>
    public static IReadOnlyList<NamedMesh> Scaled(this IReadOnlyList<NamedMesh> models, Vec3 factors)
    {
        if (!(factors.X > 0 && factors.Y > 0 && factors.Z > 0)) throw new ArgumentOutOfRangeException(nameof(factors), "The factors must be above 0.");
        return About(models, Affine.Scale(factors.X, factors.Y, factors.Z));
    }

    /// <summary>Scales all models together and uniformly, so that the longest side of their bounding box has this length, mm.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The length is not above 0.</exception>
    public static IReadOnlyList<NamedMesh> ScaledTo(this IReadOnlyList<NamedMesh> models, double longestSide)
    {
        if (!(longestSide > 0)) throw new ArgumentOutOfRangeException(nameof(longestSide), "The length must be above 0.");
        var size = BoxOf(models).Size;
        var longest = Math.Max(size.X, Math.Max(size.Y, size.Z));
        return longest > 0 ? Scaled(models, new Vec3(longestSide / longest, longestSide / longest, longestSide / longest)) : models;
    }

    /// <summary>Scales all models together, so that their bounding box has this size, mm. Sides of length 0 stay unchanged.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A length is not above 0.</exception>
    public static IReadOnlyList<NamedMesh> ScaledTo(this IReadOnlyList<NamedMesh> models, Vec3 size)
    {
        if (!(size.X > 0 && size.Y > 0 && size.Z > 0)) throw new ArgumentOutOfRangeException(nameof(size), "The lengths must be above 0.");
        var now = BoxOf(models).Size;
        return Scaled(models, new Vec3(now.X > 0 ? size.X / now.X : 1, now.Y > 0 ? size.Y / now.Y : 1, now.Z > 0 ? size.Z / now.Z : 1));
    }

    /// <summary>Rotates all models together about the bottom center of their bounding box: about X, then Y, then Z, in degrees, right-handed.</summary>
    public static IReadOnlyList<NamedMesh> Rotated(this IReadOnlyList<NamedMesh> models, Vec3 degrees)
        => About(models, Affine.Rotate(Vec3.UnitX, degrees.X).Then(Affine.Rotate(Vec3.UnitY, degrees.Y)).Then(Affine.Rotate(Vec3.UnitZ, degrees.Z)));

    /// <summary>
    /// Rotates each model so that the largest flat face of its convex hull is on the bed, and places it at its current position. Of equal faces, the one
    /// that needs the smallest rotation wins.
    /// </summary>
    public static IReadOnlyList<NamedMesh> LaidFlat(this IReadOnlyList<NamedMesh> models) => Each(models, model =>
    {
        var turned = model.Transformed(LayFlat.Turn(model.Mesh));
        return turned.Moved(Foot(model.Mesh.Bounds).WithZ(0) - Foot(turned.Mesh.Bounds));
    });

    /// <summary>The models with <paramref name="count"/> of each. Copies are named <c>part (2)</c>, <c>part (3)</c>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The count is below 1.</exception>
    public static IReadOnlyList<NamedMesh> Copies(this IReadOnlyList<NamedMesh> models, int count)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        if (count < 1) throw new ArgumentOutOfRangeException(nameof(count), "The count must be at least 1.");
        var names = Enumerable.Range(1, count).Select(i => i == 1 ? "" : $" ({NumberFormatter.Format(i)})");
        return names.SelectMany(name => models.Select(m => m with { Name = m.Name + name })).ToList();
    }

    /// <summary>Bounding box of all models, mm.</summary>
    public static Bounds BoxOf(IReadOnlyList<NamedMesh> models)
        => (models ?? throw new ArgumentNullException(nameof(models))).Aggregate(Bounds.Empty, (box, model) => box.Include(model.Mesh.Bounds));

    private static IReadOnlyList<NamedMesh> About(IReadOnlyList<NamedMesh> models, Affine map)
    {
        var box = BoxOf(models);
        if (box.IsEmpty) return models;
        var foot = Foot(box);
        var whole = Affine.Move(-foot).Then(map).Then(Affine.Move(foot));
        return Each(models, m => m.Transformed(whole));
    }

    private static Vec3 Foot(Bounds box) => box.IsEmpty ? Vec3.Zero : box.Center.WithZ(box.Min.Z);

    private static IReadOnlyList<NamedMesh> Each(IReadOnlyList<NamedMesh> models, Func<NamedMesh, NamedMesh> change)
        => (models ?? throw new ArgumentNullException(nameof(models))).Select(change).ToArray();
}

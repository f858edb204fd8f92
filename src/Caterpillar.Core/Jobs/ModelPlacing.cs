namespace Caterpillar.Jobs;

/// <summary>Scales, rotates and places models, in the order of these properties. By default they are together in the center of the bed.</summary>
public sealed record ModelPlacing
{
    /// <summary>Scale factors of the axes; null = 1.</summary>
    public Vec3? Scale { get; init; }

    /// <summary>Size of the bounding box of all models, mm; null = unchanged.</summary>
    public Vec3? Size { get; init; }

    /// <summary>Longest side of the bounding box of all models, mm; null = unchanged.</summary>
    public double? LongestSide { get; init; }

    /// <summary>Rotation in degrees about X, then Y, then Z, right-handed; null = unchanged.</summary>
    public Vec3? Rotate { get; init; }

    /// <summary>Rotate each model so that its largest flat face is on the bed.</summary>
    public bool LayFlat { get; init; }

    /// <summary>Number of copies of each model, arranged on the bed.</summary>
    public int Copies { get; init; } = 1;

    /// <summary>Arrange models next to each other, with space for the head if they are printed one by one.</summary>
    public bool Arrange { get; init; }

    /// <summary>Minimum distance between arranged models, mm.</summary>
    public double Spacing { get; init; } = new ArrangeOptions().Spacing;

    /// <summary>Keep the positions of models in x, y and z.</summary>
    public bool KeepPosition { get; init; }

    /// <summary>Center of the models on the bed, mm; null = center of the bed.</summary>
    public Vec3? Center { get; init; }

    /// <summary>The models at their print positions, copies in the order of the originals.</summary>
    /// <param name="models">The models.</param>
    /// <param name="setup">The printer, and whether models are printed one by one.</param>
    /// <param name="isPart">The models that are printed; the others are moved with them. Null = all.</param>
    /// <param name="cancel">Cancels.</param>
    /// <returns>The models with the findings of <see cref="ModelCheck"/>; none if they do not all fit, or the head cannot pass between them.</returns>
    public Result<IReadOnlyList<NamedMesh>> Place(
        IReadOnlyList<NamedMesh> models, PrintSetup setup, IReadOnlyList<bool>? isPart = null, CancellationToken cancel = default)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        var printer = setup.Printer;
        var byObject = setup.Settings.PrintSequence == PrintSequence.ByObject;
        if (Scale is { } factors) models = models.Scaled(factors);
        if (Size is { } size) models = models.ScaledTo(size);
        if (LongestSide is { } longest) models = models.ScaledTo(longest);
        if (Rotate is { } degrees) models = models.Rotated(degrees);
        if (LayFlat) models = models.LaidFlat();
        if (Arrange || Copies > 1)
        {
            var options = new ArrangeOptions { Spacing = Spacing, OneAfterTheOther = byObject };
            var arranged = ModelArranger.Arrange(models.Copies(Copies), PrimedArea.Excluded(setup), options, cancel);
            if (arranged.Value is null) return arranged;
            models = arranged.Value;
        }
        else if (!KeepPosition)
        {
            var center = Center ?? printer.BuildBounds.Center;
            // Bodies that are not printed are moved with the parts.
            var box = ModelPlacement.BoxOf(Parts());
            if (!box.IsEmpty) models = models.Moved(new Vec3(center.X - box.Center.X, center.Y - box.Center.Y, -box.Min.Z));
        }
        var found = ModelCheck.Fit(Parts(), printer);
        if (byObject) found = [.. found, .. ModelCheck.Clearance(Parts(), printer)];
        return new Result<IReadOnlyList<NamedMesh>>(found.Any(d => d.Severity == Severity.Error) ? null : models, found);

        IReadOnlyList<NamedMesh> Parts() => isPart?.Contains(false) == true ? models.Where((_, i) => isPart[i]).ToArray() : models;
    }
}

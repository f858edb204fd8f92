using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Slicing;

namespace Caterpillar.Jobs;

/// <summary>How models are scaled, turned and placed, in the order of these properties. By default they stand together in the middle of the bed.</summary>
public sealed record ModelPlacing
{
    /// <summary>Factors for the axes; null for 1.</summary>
    public Vec3? Scale { get; init; }

    /// <summary>The size of the box of all models, mm; null where they are not scaled to it.</summary>
    public Vec3? Size { get; init; }

    /// <summary>The longest side of the box of all models, mm; null where they are not scaled to it.</summary>
    public double? LongestSide { get; init; }

    /// <summary>Degrees about X, then about Y, then about Z, right-handed; null where they are not turned.</summary>
    public Vec3? Rotate { get; init; }

    /// <summary>Each model is turned so that its largest flat face is on the bed.</summary>
    public bool LayFlat { get; init; }

    /// <summary>So many of each model are printed, arranged on the bed.</summary>
    public int Copies { get; init; } = 1;

    /// <summary>Models are put beside each other, so far apart that the head passes where they are printed one after the other.</summary>
    public bool Arrange { get; init; }

    /// <summary>Smallest distance between arranged models, mm.</summary>
    public double Spacing { get; init; } = new ArrangeOptions().Spacing;

    /// <summary>Models stay where they are in x, y and z.</summary>
    public bool KeepPosition { get; init; }

    /// <summary>Where the middle of the models is put, mm; null for the middle of the bed.</summary>
    public Vec3? Center { get; init; }

    /// <summary>The models where they are printed, copies in the order of the originals.</summary>
    /// <param name="models">The models.</param>
    /// <param name="setup">The printer, and whether models are printed one after the other.</param>
    /// <param name="isPart">Which of them are printed; the others move along with these. Null for all.</param>
    /// <param name="cancel">Cancels.</param>
    /// <returns>The models with the findings of <see cref="ModelCheck"/>; none where there is no place for all of them, or the head cannot pass between
    /// them.</returns>
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
            var arranged = ModelArranger.Arrange(models.Copies(Copies), printer, options, cancel);
            if (arranged.Value is null) return arranged;
            models = arranged.Value;
        }
        else if (!KeepPosition)
        {
            var center = Center ?? printer.BuildBounds.Center;
            // Bodies that are not printed move along with the parts.
            var box = ModelPlacement.BoxOf(Parts());
            if (!box.IsEmpty) models = models.Moved(new Vec3(center.X - box.Center.X, center.Y - box.Center.Y, -box.Min.Z));
        }
        var found = ModelCheck.Fit(Parts(), printer);
        if (byObject) found = [.. found, .. ModelCheck.Clearance(Parts(), printer)];
        return new Result<IReadOnlyList<NamedMesh>>(found.Any(d => d.Severity == Severity.Error) ? null : models, found);

        IReadOnlyList<NamedMesh> Parts() => isPart?.Contains(false) == true ? models.Where((_, i) => isPart[i]).ToArray() : models;
    }
}

namespace Caterpillar.Slicing;

/// <summary>Checks placed models before slicing: whether they fit, and whether the print head has clearance.</summary>
public static class ModelCheck
{
    /// <summary>
    /// Checks whether models fit the build volume. Returns warnings <c>models.too_large</c> (by how much, and the scale that fits), <c>models.outside</c> (by
    /// how much), <c>models.unit</c> (what a huge model would be in another unit) and <c>models.excluded_area</c>. They are
    /// warnings because the check of the finished print decides.
    /// </summary>
    public static IReadOnlyList<Diagnostic> Fit(IReadOnlyList<NamedMesh> models, Printer printer)
    {
        if (printer is null) throw new ArgumentNullException(nameof(printer));
        var problems = new List<Diagnostic>();
        var box = ModelPlacement.BoxOf(models);
        if (box.IsEmpty) return problems;
        var bed = printer.BuildBounds;
        var (model, it) = models.Count == 1 ? ("Model is", "it") : ("Models are", "them");
        // On a plain rectangle the boxes are enough.
        var isPlain = printer.BedShape != BedShape.Round && printer.ExcludedAreas.Count == 0;
        var footprints = isPlain ? [] : models.Where(m => m.Mesh.TriangleCount > 0).Select(m => (m.Name, Shape: Footprint.Of(m.Mesh))).ToArray();
        var scale = LargestScale(footprints.Select(f => f.Shape), box, bed, printer.BedShape);
        if (scale < 1)
        {
            problems.Add(new Diagnostic(Severity.Warning, "models.too_large",
                $"{model} {Size(box.Size)} mm: {TooMuch(box.Size, bed.Size)} for {printer.Title} ({Size(bed.Size)} mm"
                + (printer.BedShape == BedShape.Round ? ", round bed). " : "). ")
                + (scale >= 1e-4 ? $"Scale {it} to {NumberFormatter.Format(Math.Floor(scale * 1e4) / 100, 2)} % to fit." : "Check the unit.")));
            if (UnitHint.Of(box.Size) is { } unit) problems.Add(unit);
        }
        else if (Beyond(box, bed) is { } beyond)
        {
            var text = $"{model} {beyond} for the build volume of {printer.Title}. Move {it} to fit.";
            problems.Add(new Diagnostic(Severity.Warning, "models.outside", text));
        }
        foreach (var area in printer.ExcludedAreas.Select(Footprint.Of))
        {
            foreach (var (name, shape) in footprints)
            {
                if (shape.Separation(area) >= 0) continue;
                const string Text = "Model may overlap an excluded area of the bed. Move it away.";
                problems.Add(new Diagnostic(Severity.Warning, "models.excluded_area", Text, new SourceLocation(name)));
            }
        }
        return problems;
    }

    /// <summary>
    /// True if models are so much larger than the build volume that the check of the finished print (<c>bed.outside</c>) must fail at any position.
    /// Differences of a few line widths do not count, because extrusions stay inside the outline.
    /// </summary>
    public static bool IsTooLarge(IReadOnlyList<NamedMesh> models, PrintSetup setup)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        // The last word on a code counts, as in the check itself.
        var own = setup.Printer.CheckSeverities.LastOrDefault(c => c.Code == CheckCodes.Outside);
        if (own.Code is not null && own.Severity != Severity.Error) return false;
        var (box, bed) = (ModelPlacement.BoxOf(models), setup.Printer.BuildBounds);
        var spare = 4 * Math.Max(setup.Settings.LineWidth, setup.Settings.LayerHeight);
        return !box.IsEmpty && (box.Size.X > bed.Size.X + spare || box.Size.Y > bed.Size.Y + spare || box.Size.Z > bed.Size.Z + spare);
    }

    /// <summary>
    /// Checks models that are printed one after the other, the lowest first. Returns errors <c>models.no_clearance</c> if the print head would touch a
    /// printed model.
    /// </summary>
    public static IReadOnlyList<Diagnostic> Clearance(IReadOnlyList<NamedMesh> models, Printer printer)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        if (printer is null) throw new ArgumentNullException(nameof(printer));
        var problems = new List<Diagnostic>();
        var order = models.Where(m => m.Mesh.TriangleCount > 0).OrderBy(m => m.Mesh.Bounds.Max.Z)
            .Select(m => (m.Name, Shape: Footprint.Of(m.Mesh), Top: m.Mesh.Bounds.Max.Z)).ToArray();
        for (var later = 0; later < order.Length; later++)
        {
            for (var earlier = 0; earlier < later; earlier++)
            {
                var needed = HeadClearance.Beside(printer, order[earlier].Top);
                var distance = order[later].Shape.Separation(order[earlier].Shape);
                if (distance >= needed) continue;
                var text = $"Model is {NumberFormatter.Format(Math.Max(0, distance), 2)} mm from {order[earlier].Name}, which is printed first. The print "
                    + $"head needs {NumberFormatter.Format(needed, 2)} mm next to a part "
                    + $"{NumberFormatter.Format(order[earlier].Top, 2)} mm high. Move them apart.";
                problems.Add(new Diagnostic(Severity.Error, "models.no_clearance", text, new SourceLocation(order[later].Name)));
            }
        }
        return problems;
    }

    // For a rectangle from the sizes; on a round bed the corners of the outlines must lie inside when the middle of the box is on the middle of the bed.
    private static double LargestScale(IEnumerable<Footprint> footprints, Bounds box, Bounds bed, BedShape shape)
    {
        var scale = Math.Min(Ratio(bed.Size.X, box.Size.X), Math.Min(Ratio(bed.Size.Y, box.Size.Y), Ratio(bed.Size.Z, box.Size.Z)));
        if (shape != BedShape.Round) return scale;
        foreach (var p in footprints.SelectMany(f => f.Corners))
        {
            double x = (p.X - box.Center.X) / (bed.Size.X / 2), y = (p.Y - box.Center.Y) / (bed.Size.Y / 2);
            scale = Math.Min(scale, Ratio(1, Math.Sqrt(x * x + y * y)));
        }
        return scale;
    }

    private static double Ratio(double there, double needed) => needed > 0 ? there / needed : double.PositiveInfinity;

    private static string Size(Vec3 size)
        => $"{NumberFormatter.Format(size.X, 2)} × {NumberFormatter.Format(size.Y, 2)} × {NumberFormatter.Format(size.Z, 2)}";

    private static string TooMuch(Vec3 size, Vec3 bed)
    {
        var parts = new (double Over, string Axis)[] { (size.X - bed.X, "X"), (size.Y - bed.Y, "Y"), (size.Z - bed.Z, "Z") }
            .Where(a => a.Over > 0).Select(a => $"{NumberFormatter.Format(a.Over, 2)} mm too long in {a.Axis}").ToArray();
        return parts.Length == 0 ? "too large" : string.Join(", ", parts);
    }

    private static string? Beyond(Bounds box, Bounds bed)
    {
        var parts = new (double Over, string Side)[]
        {
            (bed.Min.X - box.Min.X, "far left"), (box.Max.X - bed.Max.X, "far right"), (bed.Min.Y - box.Min.Y, "far to the front"),
            (box.Max.Y - bed.Max.Y, "far to the back"), (box.Max.Z - bed.Max.Z, "high"),
        }.Where(s => s.Over > 1e-6).Select(s => $"{NumberFormatter.Format(s.Over, 2)} mm too {s.Side}").ToArray();
        return parts.Length == 0 ? null : string.Join(", ", parts);
    }
}

namespace Caterpillar.Slicing;

/// <summary>
/// Arranges models on the bed: the largest first, each as close to the center of the bed as possible, or in rows from the front left if more of them fit
/// there. Models are not rotated and take up their convex outline seen from above.
/// </summary>
public static class ModelArranger
{
    /// <summary>Places the models on the bed.</summary>
    /// <returns>The models in the same order, or the error <c>models.no_space</c> with the models that do not fit.</returns>
    /// <exception cref="OperationCanceledException">The call was canceled.</exception>
    public static Result<IReadOnlyList<NamedMesh>> Arrange(
        IReadOnlyList<NamedMesh> models, Printer printer, ArrangeOptions? options = null, CancellationToken cancel = default)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        if (printer is null) throw new ArgumentNullException(nameof(printer));
        options ??= new ArrangeOptions();
        var known = new Dictionary<TriMesh, Footprint>();
        var footprints = models.Select(m => known.TryGetValue(m.Mesh, out var same) ? same : known[m.Mesh] = Footprint.Of(m.Mesh)).ToArray();
        var order = Enumerable.Range(0, models.Count).Where(i => models[i].Mesh.TriangleCount > 0)
            .OrderByDescending(i => footprints[i].Box.Size.X * footprints[i].Box.Size.Y).ThenBy(i => i).ToArray();
        var search = new PlaceSearch(printer, options, cancel);
        var placed = search.FromTheMiddle(footprints, order);
        if (placed.Count(p => p is not null) < order.Length)
        {
            // Rows from the front left hold more, where the bed is nearly full.
            var rows = search.InRows(footprints, order);
            if (rows.Count(p => p is not null) > placed.Count(p => p is not null)) placed = rows;
        }
        var missing = order.Where(i => placed[i] is null).OrderBy(i => i).Select(i => models[i].Name).ToArray();
        if (missing.Length > 0)
        {
            var names = string.Join(", ", missing.Take(5)) + (missing.Length > 5 ? $" and {NumberFormatter.Format(missing.Length - 5)} more" : "");
            var text = $"No room on the bed of {printer.Title} for {names}: {NumberFormatter.Format(order.Length - missing.Length)} of "
                + $"{NumberFormatter.Format(order.Length)} models fit. Print fewer at once or reduce their spacing.";
            return new Result<IReadOnlyList<NamedMesh>>("models.no_space", text);
        }
        var result = models.Select((m, i) => placed[i] is { } place ? Stand(m, footprints[i], place) : m).ToArray();
        return new Result<IReadOnlyList<NamedMesh>>(result, []);
    }

    private static NamedMesh Stand(NamedMesh model, Footprint from, Footprint to)
    {
        var shift = to.Box.Min - from.Box.Min;
        return model.Moved(new Vec3(shift.X, shift.Y, -model.Mesh.Bounds.Min.Z));
    }
}

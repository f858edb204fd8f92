namespace Caterpillar.Cli;

/// <summary>Slices along surfaces, or onto an object.</summary>
internal static class CurvedSlicing
{
    /// <summary>The planned print.</summary>
    /// <param name="curved">The options.</param>
    /// <param name="arguments">The command line.</param>
    /// <param name="read">The models as they were read.</param>
    /// <param name="models">The same at their print positions.</param>
    /// <param name="setup">The printer, material and settings.</param>
    /// <param name="options">Other options of the print.</param>
    /// <param name="session">Reads files.</param>
    public static PrintJob Run(
        CurvedOptionValues curved, ParseResult arguments, IReadOnlyList<NamedMesh> read, IReadOnlyList<SliceModel> models, PrintSetup setup,
        PrintJobOptions options, Session session)
    {
        var shift = Shift(read, models);
        options = curved.Onto.Of(arguments, shift, options, session);
        if (!curved.HasField(arguments)) return session.Run("Slicing", progress => PrintJob.Slice(models, setup, options, progress, session.Cancel));
        // Together with an object the model is already where it belongs.
        if (options.Onto is not null)
        {
            models = models.Select(m => new SliceModel(new NamedMesh(m.Mesh.Name, m.Mesh.Mesh.Moved(new Vec3(0, 0, -shift.Z))), m.Settings)).ToArray();
            shift = shift.WithZ(0);
        }
        var meshes = models.Select(m => m.Mesh).ToArray();
        var field = curved.Field(arguments, meshes, shift, setup, session, out var surface);
        var lines = curved.InfillLines(arguments, surface, meshes, shift, setup, session);
        options = options with { InfillLines = lines is null ? null : _ => lines };
        return session.Run("Slicing", progress => PrintJob.Slice(models, field, setup, options, progress, session.Cancel));
    }

    // Surfaces move with the model, but are not scaled, turned or copied.
    private static Vec3 Shift(IReadOnlyList<NamedMesh> read, IReadOnlyList<SliceModel> models)
    {
        const double Rounding = 1e-6;
        var shift = models[0].Mesh.Mesh.Bounds.Min - read[0].Mesh.Bounds.Min;
        var moved = models.Count == read.Count;
        for (var i = 0; moved && i < read.Count; i++)
        {
            var (from, to) = (read[i].Mesh.Bounds, models[i].Mesh.Mesh.Bounds);
            moved = to.Min.DistanceTo(from.Min + shift) < Rounding && to.Max.DistanceTo(from.Max + shift) < Rounding;
        }
        return moved ? shift : throw new CliException(ExitCode.Usage,
            "With --surface, --field, --deform or --onto, models cannot be scaled, rotated, copied or arranged: the surface would not follow them.");
    }
}

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
    /// <exception cref="CliException">A file cannot be read, or options cannot be combined.</exception>
    public static PrintJob Run(
        CurvedOptionValues curved, ParseResult arguments, IReadOnlyList<NamedMesh> read, IReadOnlyList<SliceModel> models, PrintSetup setup,
        PrintJobOptions options, Session session)
    {
        var placed = models.Select(m => m.Mesh.Placed).Distinct().ToArray();
        if (placed.Length > 1 && read.Count > 1) throw Usage("several models cannot be arranged: the surface would not follow them.");
        if (placed.Length > 1 && !curved.CanBeCopied(arguments)) throw Usage("formulas for --deform and --infill-along do not follow copies.");
        options = curved.Onto.Of(arguments, placed, options, session);
        if (!curved.HasField(arguments)) return session.Run("Slicing", progress => PrintJob.Slice(models, setup, options, progress, session.Cancel));
        // Together with an object the model is already where it belongs.
        if (options.Onto is not null)
            models = models.Select(m => new SliceModel(m.Mesh.Moved(new Vec3(0, 0, -m.Mesh.Placed.Shift.Z)), m.Settings)).ToArray();
        var meshes = models.Select(m => m.Mesh).ToArray();
        var first = placed.Length == 1 ? meshes : [meshes[0]];
        var field = curved.Field(arguments, first, setup, session, out var surface);
        var lines = curved.InfillLines(arguments, surface, first, setup, session);
        options = options with { InfillLines = lines is null ? null : _ => lines };
        if (placed.Length > 1) field = field.ForCopies(meshes);
        return session.Run("Slicing", progress => PrintJob.Slice(models, field, setup, options, progress, session.Cancel));
    }

    private static CliException Usage(string problem) => new(ExitCode.Usage, "With curved layers or --onto, " + problem);
}

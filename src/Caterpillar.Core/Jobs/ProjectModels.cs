namespace Caterpillar.Jobs;

/// <summary>Settings of models in 3MF projects of other slicers: of objects and parts, and painted faces.</summary>
public static class ProjectModels
{
    private const string Painted = "painted";

    // As many as the key for them takes.
    private const int MostMarks = 10_000;

    /// <summary>The settings of each model: those of the print, with what the project says of the model.</summary>
    /// <param name="models">The models as read.</param>
    /// <param name="setup">The print.</param>
    /// <returns>The settings; the note <c>import.no_equal</c> lists settings of models that have no equal.</returns>
    public static Result<IReadOnlyList<PrintSettings>> Settings(IReadOnlyList<NamedMesh> models, PrintSetup setup)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        var problems = new List<Diagnostic>();
        return new Result<IReadOnlyList<PrintSettings>>(models.Select(m => Own(m, setup, problems)).ToArray(), problems);
    }

    /// <summary>The models to slice. Painted seams become seam enforcers of all parts.</summary>
    /// <param name="models">The models at their places, copies in the order of the originals.</param>
    /// <param name="settings">The settings of each original.</param>
    public static IReadOnlyList<SliceModel> Models(IReadOnlyList<NamedMesh> models, IReadOnlyList<PrintSettings> settings)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        if (settings is null) throw new ArgumentNullException(nameof(settings));
        var marks = models.Where(m => m.Settings.ContainsKey(Painted)).SelectMany(m => Enumerable.Range(0, m.Mesh.TriangleCount).Select(t => Mark(m.Mesh, t)))
            .Take(MostMarks).ToArray();
        var all = models.Select((m, i) => new SliceModel(m, With(settings[i % settings.Count], marks)));
        return all.Where(m => !m.Mesh.Settings.ContainsKey(Painted)).ToArray();
    }

    private static PrintSettings Own(NamedMesh model, PrintSetup setup, List<Diagnostic> problems)
    {
        // Without thickness, a modifier has no effect, but it moves with the parts.
        if (model.Settings.ContainsKey(Painted)) return setup.Settings with { ModelType = ModelType.Modifier };
        var own = SlicerImport.Own(setup, model.Settings, out var lost);
        if (lost.Count > 0)
        {
            problems.Add(new Diagnostic(Severity.Note, "import.no_equal",
                $"{model.Name}: without an equal here: {string.Join(", ", lost.Select(k => k + "=" + model.Settings[k]))}."));
        }
        return own.Settings;
    }

    private static PrintSettings With(PrintSettings settings, SeamMark[] marks)
        => marks.Length == 0 || settings.ModelType != ModelType.Part ? settings : settings with { SeamEnforcers = new([.. settings.SeamEnforcers, .. marks]) };

    // A sphere around a triangle.
    private static SeamMark Mark(TriMesh mesh, int triangle)
    {
        var (a, b, c) = mesh.Triangle(triangle);
        var (p, q, r) = (mesh.Vertices[a], mesh.Vertices[b], mesh.Vertices[c]);
        var center = (p + q + r) / 3;
        return new SeamMark(center, Math.Max(0.1, Math.Max(center.DistanceTo(p), Math.Max(center.DistanceTo(q), center.DistanceTo(r)))));
    }
}

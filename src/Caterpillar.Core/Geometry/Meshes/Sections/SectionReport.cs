namespace Caterpillar.Geometry;

/// <summary>Measures of one plane section: the solid by non-zero winding, so that bodies that intersect count once.</summary>
/// <param name="Z">Height of the plane, mm.</param>
/// <param name="Length">Length of the boundary of the area, mm, with open lines added.</param>
/// <param name="Area">Area in mm².</param>
/// <param name="Outer">Number of contours around the area.</param>
/// <param name="Holes">Number of contours around holes in it.</param>
/// <param name="Open">Number of loose ends of contours that do not close.</param>
internal sealed record SectionMeasure(double Z, double Length, double Area, int Outer, int Holes, int Open);

/// <summary>Measures of plane sections of one model. Immutable.</summary>
/// <param name="Model">Name of the model, for example its file.</param>
/// <param name="Sections">One entry for each height, in the requested order.</param>
internal sealed record SectionReport(string Model, IReadOnlyList<SectionMeasure> Sections)
{
    /// <summary>Cuts a mesh at heights in mm and measures the sections.</summary>
    /// <returns>The report, and the diagnostics of <see cref="MeshSections.At"/>.</returns>
    /// <exception cref="ArgumentException">A height is not finite.</exception>
    /// <exception cref="OperationCanceledException">The call was canceled.</exception>
    public static Result<SectionReport> Of(
        string model, TriMesh mesh, IReadOnlyList<double> heights, SectionOptions? options = null,
        IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        options ??= new SectionOptions();
        var cut = MeshSections.At(mesh, heights, options, progress.Part(0, 0.7), cancel);
        var sections = cut.Value!;
        var rows = new SectionMeasure[sections.Count];
        var parallel = new ParallelOptions { MaxDegreeOfParallelism = options.Degree, CancellationToken = cancel };
        Parallel.For(0, rows.Length, parallel, i => rows[i] = Measure(sections[i]));
        progress?.Report(1);
        var place = new SourceLocation(model);
        return new Result<SectionReport>(new SectionReport(model, rows), cut.Diagnostics.Select(d => d with { Source = d.Source ?? place }).ToArray());
    }

    private static SectionMeasure Measure(Section section)
    {
        var (area, perimeter, outer, holes) = ContourMeasure.NonZero(section.Loops);
        return new SectionMeasure(section.Z, perimeter + section.OpenLines.Sum(l => l.Length), area, outer, holes, section.OpenEnds);
    }

    /// <summary>
    /// A JSON array with one object per report: <c>{"model", "sections": [{"z", "length", "area", "outer", "holes", "open"}]}</c>, mm and mm²
    /// with at most nine decimals, one section per line.
    /// </summary>
    public static string ToJson(IEnumerable<SectionReport> reports)
    {
        var all = (reports ?? throw new ArgumentNullException(nameof(reports))).Select(Json).ToArray();
        return "[" + string.Join(",", all) + (all.Length > 0 ? "\n]\n" : "]\n");
    }

    private static string Json(SectionReport report)
        => $"\n {{\"model\": {JsonConvert.ToString(report.Model)}, \"sections\": [{string.Join(",", report.Sections.Select(Json))}"
            + (report.Sections.Count > 0 ? "\n ]}" : "]}");

    private static string Json(SectionMeasure s)
        => $"\n  {{\"z\": {NumberFormatter.Format(s.Z, 9)}, \"length\": {NumberFormatter.Format(s.Length, 9)}, \"area\": {NumberFormatter.Format(s.Area, 9)}, "
            + $"\"outer\": {NumberFormatter.Format(s.Outer)}, \"holes\": {NumberFormatter.Format(s.Holes)}, \"open\": {NumberFormatter.Format(s.Open)}}}";
}

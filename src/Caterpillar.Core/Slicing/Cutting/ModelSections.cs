namespace Caterpillar.Slicing;

/// <summary>Cuts a model for printing: repairs the mesh, closes gaps in contours, and reports repairs and omissions in one diagnostic.</summary>
internal static class ModelSections
{
    /// <summary>Sections at ascending heights. Problems are added to <paramref name="problems"/>.</summary>
    /// <exception cref="OperationCanceledException">The call was canceled.</exception>
    public static IReadOnlyList<Section> Cut(
        NamedMesh model, double[] heights, PrintSettings settings, int threads, List<Diagnostic> problems,
        IProgress<double>? progress, CancellationToken cancel)
    {
        // Open meshes that are printed as single walls have no inside that could be repaired or lost.
        if (settings.OpenContours != OpenContours.Ignore)
            return MeshSections.At(model.Mesh, heights, new SectionOptions { Threads = threads }, progress, cancel).Value!;
        var repaired = settings.RepairMeshes ? MeshRepair.ToSolid(model.Mesh, cancel) : RepairedMesh.Unchanged(model.Mesh);
        var options = new SectionOptions { Threads = threads, GapMm = settings.SliceGapClosing };
        var sections = MeshSections.At(repaired.Mesh, heights, options, progress, cancel).Value!;
        var source = new SourceLocation(model.Name);
        if (BrokenMeshReport.Describe(repaired, sections) is { } text)
            problems.Add(new Diagnostic(Severity.Warning, "slice.broken_mesh", text, source));
        if (LostLayers.Find(sections, settings.MaxAreaLossPercent, cancel) is { } lost)
            problems.Add(new Diagnostic(Severity.Error, "slice.lost_layers", lost, source));
        return sections;
    }
}

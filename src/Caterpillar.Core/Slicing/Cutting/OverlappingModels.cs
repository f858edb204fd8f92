namespace Caterpillar.Slicing;

/// <summary>Makes one model of models that run through each other, so that the place where they overlap is printed once.</summary>
internal static class OverlappingModels
{
    // Heights at which two models are compared, and what counts as touching only, mm².
    private const int MaxHeights = 128;
    private const double LeastArea = 1e-3;

    public static IReadOnlyList<SliceModel> Merge(IReadOnlyList<SliceModel> models, int threads, DiagnosticList problems, CancellationToken cancel)
    {
        var groups = new DisjointSets(models.Count);
        for (var i = 0; i < models.Count; i++)
        {
            for (var j = 0; j < i; j++)
            {
                cancel.ThrowIfCancellationRequested();
                if (groups.Of(i) == groups.Of(j) || !Overlap(models[i], models[j], threads, cancel)) continue;
                if (models[i].Settings != models[j].Settings)
                {
                    problems.Add(Severity.Warning, "models.overlap",
                        $"{models[j].Mesh.Name} and {models[i].Mesh.Name} overlap and have different settings. The overlap is printed twice.");
                    continue;
                }
                groups.Join(i, j);
            }
        }
        var merged = new List<SliceModel>();
        for (var i = 0; i < models.Count; i++)
        {
            if (groups.Of(i) != i) continue;
            var members = Enumerable.Range(i, models.Count - i).Where(k => groups.Of(k) == i).Select(k => models[k]).ToArray();
            if (members.Length == 1)
            {
                merged.Add(members[0]);
                continue;
            }
            const int Named = 3;
            var more = members.Length > Named ? $" + {NumberFormatter.Format(members.Length - Named)} more" : "";
            var name = string.Join(" + ", members.Take(Named).Select(m => m.Mesh.Name)) + more;
            problems.Add(Severity.Note, "models.merged", $"{name} overlap and are printed as one solid. merge_overlapping_models=false prints each.");
            merged.Add(new SliceModel(new NamedMesh(name, TriMesh.Merge(members.Select(m => m.Mesh.Mesh))), members[0].Settings));
        }
        return merged;
    }

    private static bool Overlap(SliceModel a, SliceModel b, int threads, CancellationToken cancel)
    {
        Bounds p = a.Mesh.Mesh.Bounds, q = b.Mesh.Mesh.Bounds;
        if (p.IsEmpty || q.IsEmpty || p.Min.X >= q.Max.X || q.Min.X >= p.Max.X || p.Min.Y >= q.Max.Y || q.Min.Y >= p.Max.Y) return false;
        double bottom = Math.Max(0, Math.Max(p.Min.Z, q.Min.Z)), top = Math.Min(p.Max.Z, q.Max.Z);
        if (!(bottom < top)) return false;
        var count = (int)Math.Max(1, Math.Min(MaxHeights, Math.Ceiling((top - bottom) / a.Settings.LayerHeight)));
        var heights = Enumerable.Range(0, count).Select(i => bottom + (i + 0.5) * (top - bottom) / count).ToArray();
        var options = new SectionOptions { Threads = threads, GapMm = a.Settings.SliceGapClosing };
        var first = MeshSections.At(a.Mesh.Mesh, heights, options, null, cancel).Value!;
        var second = MeshSections.At(b.Mesh.Mesh, heights, options, null, cancel).Value!;
        for (var i = 0; i < count; i++)
        {
            cancel.ThrowIfCancellationRequested();
            if (Region.From(first[i].Loops).Intersect(Region.From(second[i].Loops)).Area > LeastArea) return true;
        }
        return false;
    }
}

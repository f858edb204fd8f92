namespace Caterpillar.Geometry;

/// <summary>
/// Exact plane sections of meshes, chained over shared edges. A vertex at or above the plane counts as above, so every cut triangle has exactly two
/// cut edges. For facets that lie in the plane this is the limit from below throughout: a plane through a flat top gives its outline, a plane
/// through a flat bottom gives nothing.
/// </summary>
internal static class MeshSections
{
    // Cut triangles that are held at a time; more heights are processed in several passes.
    private const long MaxHeld = 1 << 26;

    /// <summary>Sections at any heights in mm, in the order in which they are given.</summary>
    /// <returns>One section for each height, and the diagnostics <c>mesh.gap_closed</c>, <c>mesh.naked_edges</c> (contours that stay
    /// open).</returns>
    /// <exception cref="ArgumentException">A height is not finite.</exception>
    /// <exception cref="OperationCanceledException">The call was canceled.</exception>
    public static Result<IReadOnlyList<Section>> At(
        TriMesh mesh, IReadOnlyList<double> heights, SectionOptions? options = null,
        IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        options ??= new SectionOptions();
        var (ascending, order) = Sorted(heights);
        var sections = new Section[ascending.Length];
        if (ascending.Length > 0 && mesh.TriangleCount > 0)
        {
            var buckets = new LayerBuckets(mesh, ascending);
            _ = mesh.Topology;
            for (int from = 0, to; from < ascending.Length; from = to)
            {
                long held = buckets.Counts[from];
                for (to = from + 1; to < ascending.Length && held + buckets.Counts[to] <= MaxHeld; to++) held += buckets.Counts[to];
                Cut(mesh, ascending, buckets, from, to, options, sections, progress, cancel);
            }
        }
        var diagnostics = new DiagnosticList();
        var ordered = new Section[ascending.Length];
        for (var i = 0; i < ordered.Length; i++) ordered[order[i]] = sections[i] ?? new Section(ascending[i], [], []);
        Report(ordered, diagnostics);
        progress?.Report(1);
        return new Result<IReadOnlyList<Section>>(ordered, diagnostics.ToList());
    }

    private static void Cut(
        TriMesh mesh, double[] heights, LayerBuckets buckets, int from, int to, SectionOptions options,
        Section[] sections, IProgress<double>? progress, CancellationToken cancel)
    {
        var triangles = buckets.Fill(from, to);
        var starts = new int[to - from + 1];
        for (var i = from; i < to; i++) starts[i - from + 1] = starts[i - from] + (int)buckets.Counts[i];
        var done = from;
        var gate = new object();
        var parallel = new ParallelOptions { MaxDegreeOfParallelism = options.Degree, CancellationToken = cancel };
        // Blocks of layers: neighbors touch the same triangles.
        const int Block = 8;
        Parallel.For(0, (to - from + Block - 1) / Block, parallel, () => new SectionWalker(mesh), (block, _, walker) =>
        {
            var last = Math.Min(to, from + (block + 1) * Block);
            for (var i = from + block * Block; i < last; i++)
            {
                var loops = new List<Polyline>();
                var open = new List<Polyline>();
                walker.Cut(heights[i], triangles, starts[i - from], starts[i - from + 1], loops, open);
                var gaps = GapCloser.Close(open, loops, options.GapMm);
                sections[i] = new Section(heights[i], loops.ToArray(), open.ToArray(), gaps);
            }
            if (progress is not null)
            {
                lock (gate) progress.Report((double)(done += last - from - block * Block) / heights.Length);
            }
            return walker;
        }, _ => { });
    }

    private static (double[] Ascending, int[] Order) Sorted(IReadOnlyList<double> heights)
    {
        if (heights.Any(z => double.IsNaN(z - z))) throw new ArgumentException("The heights must be finite numbers.", nameof(heights));
        var order = Enumerable.Range(0, heights.Count).OrderBy(i => heights[i]).ToArray();
        return (Array.ConvertAll(order, i => heights[i]), order);
    }

    private static void Report(Section[] sections, DiagnosticList diagnostics)
    {
        var closed = sections.Sum(s => s.Gaps.Count);
        var widest = sections.Select(s => s.Gaps.Widest).DefaultIfEmpty().Max();
        if (closed > 0)
        {
            diagnostics.Add(Severity.Warning, "mesh.gap_closed",
                $"A gap in a contour was closed. The widest gap is {NumberFormatter.Format(widest, 6)} mm.", null, closed);
        }
        if (sections.FirstOrDefault(s => s.OpenEnds > 0) is { } first)
        {
            diagnostics.Add(Severity.Warning, "mesh.naked_edges",
                $"The mesh is open: a contour has a loose end, first at z = {NumberFormatter.Format(first.Z, 6)} mm.", null, sections.Sum(s => s.OpenEnds));
        }
    }
}

using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>
/// Cuts meshes into planar layers and fills them with walls and straight infill. Each layer is cut at its middle; where solids overlap their union is printed.
/// </summary>
public static class PlanarSlicer
{
    /// <summary>Slices meshes that stand where they are to be printed (Z = 0 is the bed).</summary>
    /// <param name="models">The objects; each keeps its own layers.</param>
    /// <param name="settings">Layer height, line width, walls and infill.</param>
    /// <param name="threads">Degree of parallelism, 0 for all cores. It does not change the result.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels.</param>
    /// <returns>The layers, and what was noticed: the problems of the meshes, <c>slice.nothing</c>, <c>slice.below_bed</c>,
    /// <c>slice.open_contours</c>.</returns>
    /// <exception cref="OperationCanceledException">The call was canceled.</exception>
    public static Result<SliceResult> Slice(
        IReadOnlyList<NamedMesh> models, PrintSettings settings, int threads = 0, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        if (settings is null) throw new ArgumentNullException(nameof(settings));
        var problems = new DiagnosticList();
        var work = new List<LayerWork>();
        for (var i = 0; i < models.Count; i++)
            Cut(models[i], i, settings, threads, problems, work, progress.Part(0.4 * i / models.Count, 0.4 * (i + 1) / models.Count), cancel);
        var ordered = work.OrderBy(w => w.Plan.Top).ThenBy(w => w.Object).ToArray();
        var layers = new SlicedLayer[ordered.Length];
        var done = 0;
        var options = new ParallelOptions { CancellationToken = cancel, MaxDegreeOfParallelism = threads > 0 ? threads : -1 };
        Parallel.For(0, ordered.Length, options, () => new RegionEngine(), (i, _, engine) =>
        {
            layers[i] = Fill(ordered[i], i, settings, engine);
            if (progress is not null)
            {
                var part = (double)Interlocked.Increment(ref done) / ordered.Length;
                lock (options) progress.Report(0.4 + 0.6 * part);
            }
            return engine;
        }, _ => { });
        var kept = layers.Where(l => l.Steps.Count > 0).ToArray();
        if (settings.SkirtLoops > 0 && kept.Length > 0) kept[0] = Skirt.Around(kept, settings);
        if (kept.Length == 0)
            problems.Add(Severity.Error, "slice.nothing", "Nothing to print: the models have no closed contour as wide as a line on any layer.");
        return new Result<SliceResult>(kept.Length > 0 ? new SliceResult(kept) : null, problems.ToList());
    }

    private static void Cut(
        NamedMesh model, int number, PrintSettings settings, int threads, DiagnosticList problems, List<LayerWork> work,
        IProgress<double>? progress, CancellationToken cancel)
    {
        var bounds = model.Mesh.Bounds;
        if (bounds.IsEmpty) return;
        var source = new SourceLocation(model.Name);
        if (bounds.Min.Z < -1e-6)
        {
            problems.Add(Severity.Warning, "slice.below_bed",
                $"The model reaches {NumberFormatter.Format(-bounds.Min.Z, 3)} mm below the bed; that part is not printed.", source);
        }
        var plan = PlannedLayer.StackTo(bounds.Max.Z, settings.FirstLayerHeight, settings.LayerHeight);
        var sections = MeshSections.At(model.Mesh, Array.ConvertAll(plan, l => l.Cut), new SectionOptions { Threads = threads }, progress, cancel);
        foreach (var problem in sections.Diagnostics) problems.Add(problem with { Source = source });
        var open = 0;
        var length = 0.0;
        for (var i = 0; i < plan.Length; i++)
        {
            var section = sections.Value![i];
            foreach (var line in section.OpenLines)
            {
                open++;
                length += line.Length;
            }
            work.Add(new LayerWork(new Layer(i, plan[i].Top, plan[i].Thickness, model.Name), plan[i], section, number));
        }
        if (open > 0)
        {
            problems.Add(Severity.Warning, "slice.open_contours",
                $"{NumberFormatter.Format(open)} contours, {NumberFormatter.Format(length, 1)} mm in all, do not close and are not printed.", source);
        }
    }

    private static SlicedLayer Fill(LayerWork work, int number, PrintSettings settings, RegionEngine engine)
    {
        var rules = SliceRules.Of(settings, work.Plan.Thickness);
        var region = Region.From(work.Section.Loops, FillRule.NonZero, false, engine).Simplified(rules.Simplify, engine);
        var steps = new List<PathStep>();
        var slicer = new IslandSlicer(rules, work.Layer, engine);
        var islands = region.Islands;
        for (var i = 0; i < islands.Count; i++) slicer.Slice(islands[i], number, i, steps);
        return new SlicedLayer(work.Layer, region, steps);
    }

    private sealed record LayerWork(Layer Layer, PlannedLayer Plan, Section Section, int Object);
}

using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Machines;
using Caterpillar.Toolpaths;

namespace Caterpillar.Slicing;

/// <summary>
/// Cuts meshes into planar layers and fills them with walls, skins and infill. Where solids of a model overlap their union is printed.
/// </summary>
public static class PlanarSlicer
{
    /// <summary>Slices meshes that stand where they are to be printed (Z = 0 is the bed).</summary>
    /// <param name="models">The objects; each keeps its own layers.</param>
    /// <param name="settings">Layers, walls, skins and infill.</param>
    /// <param name="threads">Degree of parallelism, 0 for all cores. It does not change the result.</param>
    /// <param name="progress">0 to 1.</param>
    /// <param name="cancel">Cancels.</param>
    /// <returns>The layers, and what was noticed: <c>slice.nothing</c>, <c>slice.below_bed</c>, <c>slice.too_many_layers</c>, and for each broken mesh
    /// <c>slice.broken_mesh</c> (what was mended and what is left out) and <c>slice.lost_layers</c> (an error: there are no layers then).</returns>
    /// <exception cref="OperationCanceledException">The call was cancelled.</exception>
    public static Result<SliceResult> Slice(
        IReadOnlyList<NamedMesh> models, PrintSettings settings, int threads = 0, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (models is null) throw new ArgumentNullException(nameof(models));
        if (settings is null) throw new ArgumentNullException(nameof(settings));
        var problems = new DiagnosticList();
        // One for each model, so not in the list that counts.
        var broken = new List<Diagnostic>();
        var bodies = new List<Body>();
        for (var i = 0; i < models.Count; i++)
        {
            var body = new Body(models[i], i);
            Cut(body, settings, threads, problems, broken, progress.Part(0.4 * i / models.Count, 0.4 * (i + 1) / models.Count), cancel);
            bodies.Add(body);
        }
        if (broken.Any(d => d.Severity == Severity.Error)) return new Result<SliceResult>(null, [.. problems.ToList(), .. broken]);
        var ordered = bodies.SelectMany(b => b.Layers).OrderBy(l => l.Plan.Top).ThenBy(l => l.Body.Number).ToArray();
        var kept = new LayerStream(ordered, threads, cancel).Run(progress.Part(0.4, 1)).Where(l => l.Steps.Count > 0).ToArray();
        if (settings.SkirtLoops > 0 && kept.Length > 0) kept[0] = Skirt.Around(kept, settings);
        if (kept.Length == 0 && !problems.HasErrors)
            problems.Add(Severity.Error, "slice.nothing", "Nothing to print: the models have no closed contour as wide as a line on any layer.");
        return new Result<SliceResult>(kept.Length > 0 ? new SliceResult(kept) : null, [.. problems.ToList(), .. broken]);
    }

    private static void Cut(
        Body body, PrintSettings settings, int threads, DiagnosticList problems, List<Diagnostic> broken,
        IProgress<double>? progress, CancellationToken cancel)
    {
        var mesh = body.Model.Mesh;
        if (mesh.Bounds.IsEmpty) return;
        if (mesh.Bounds.Min.Z < -1e-6)
        {
            problems.Add(Severity.Warning, "slice.below_bed",
                $"The model reaches {NumberFormatter.Format(-mesh.Bounds.Min.Z, 3)} mm below the bed; that part is not printed.", body.Source);
        }
        if (LayerPlan.Of(mesh.Bounds.Max.Z, settings) is not { } plan)
        {
            problems.Add(Severity.Error, "slice.too_many_layers", "More than a million layers: the layers are too thin.", body.Source);
            return;
        }
        var sections = ModelSections.Cut(body.Model, Array.ConvertAll(plan, l => l.Cut), settings, threads, broken, progress, cancel);
        var rules = new Dictionary<double, SliceRules>();
        body.Layers = new LayerWork[plan.Length];
        for (var i = 0; i < plan.Length; i++)
        {
            if (!rules.TryGetValue(plan[i].Thickness, out var rule)) rules.Add(plan[i].Thickness, rule = SliceRules.Of(settings, plan[i].Thickness));
            body.Layers[i] = new LayerWork(body, i, plan[i], rule) { Section = sections[i] };
        }
    }
}

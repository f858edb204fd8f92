using System;
using System.Collections.Generic;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

namespace Caterpillar.Drawings;

/// <summary>User-defined toolpaths (Caterpillar 2019, section 3.3): any 3D curves, printed exactly as drawn and in the given order.</summary>
public static class CurvePaths
{
    // A point with its bead, its move, and their copies until they are written.
    private const double BytesPerPoint = 250;

    /// <summary>
    /// The steps that print curves in their order. Curves without length are ignored with a warning. Errors (codes <c>curves.*</c>) are strands with negative
    /// or infinite settings; parts below the bed are a warning.
    /// </summary>
    /// <exception cref="ArgumentException">The subdivision is out of range, or a curve is null.</exception>
    public static Result<IReadOnlyList<Step>> ToSteps(
        IReadOnlyList<UserCurve> curves, CurveOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        var paths = ToPaths(curves, options, progress, cancel);
        if (paths.Value is null) return new Result<IReadOnlyList<Step>>(null, paths.Diagnostics);
        var steps = new Step[paths.Value.Count];
        for (var i = 0; i < steps.Length; i++)
        {
            var path = paths.Value[i];
            StepGroup? group = options?.Sorting switch
            {
                CurveSorting.WithinLayers => new StepGroup(path.Layer?.Index ?? -1),
                CurveSorting.All => new StepGroup(0),
                _ => null,
            };
            steps[i] = new PathStep(path, group);
        }
        return new Result<IReadOnlyList<Step>>(steps, paths.Diagnostics);
    }

    /// <summary>The paths of curves in their order; as <see cref="ToSteps"/>.</summary>
    /// <exception cref="ArgumentException">The subdivision is out of range, or a curve is null.</exception>
    public static Result<IReadOnlyList<PrintPath>> ToPaths(
        IReadOnlyList<UserCurve> curves, CurveOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (curves is null) throw new ArgumentNullException(nameof(curves));
        options ??= new CurveOptions();
        var diagnostics = new DiagnosticList();
        var paths = new List<PrintPath>(curves.Count);
        var points = 0L;
        var maker = new PathMaker(options, diagnostics, cancel);
        for (var i = 0; i < curves.Count; i++)
        {
            if ((i & 0xFF) == 0)
            {
                cancel.ThrowIfCancellationRequested();
                progress?.Report((double)i / curves.Count);
            }
            var curve = curves[i] ?? throw new ArgumentException("A curve is null.", nameof(curves));
            var path = maker.Make(curve, curve.Source ?? new SourceLocation(Step: i));
            if (path is null) continue;
            points += path.RawPoints.Length;
            if (options.Memory.Refuse(points * BytesPerPoint, $"A division into more than {NumberFormatter.Format(points)} points", curve.Source,
                "Use a larger distance, tolerance or angle.") is { } tooMuch)
            {
                diagnostics.Add(tooMuch);
                break;
            }
            paths.Add(options.FitArcs > 0 ? PathArcs.Fit(path, new ArcFitOptions { Tolerance = options.FitArcs }) : path);
        }
        if (diagnostics.HasErrors) return new Result<IReadOnlyList<PrintPath>>(null, diagnostics.ToList());
        if (paths.Count == 0)
        {
            diagnostics.Add(Severity.Error, "curves.empty", "There is no curve to print.");
            return new Result<IReadOnlyList<PrintPath>>(null, diagnostics.ToList());
        }
        progress?.Report(1);
        return new Result<IReadOnlyList<PrintPath>>(options.MergeTolerance > 0 ? PathMerging.Merge(paths, options.MergeTolerance)
            : paths, diagnostics.ToList());
    }
}

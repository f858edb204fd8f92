namespace Caterpillar.Drawings;

/// <summary>User-defined toolpaths (Caterpillar 2019, section 3.3): 3D curves, printed exactly as drawn and in the given order.</summary>
public static class CurvePaths
{
    // A point with its bead, its move, and their copies until they are written.
    private const double BytesPerPoint = 250;

    /// <summary>
    /// The steps that print curves in their order. Curves without length are ignored with a warning. Curves below the bed are also a warning. Negative or
    /// infinite settings of an extrusion are errors (codes <c>curves.*</c>).
    /// </summary>
    /// <exception cref="ArgumentException">The subdivision is out of range, or a curve is null.</exception>
    public static Result<IReadOnlyList<Step>> ToSteps(
        IReadOnlyList<UserCurve> curves, CurveOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        var made = Make(curves, options ?? new CurveOptions(), withDots: true, progress, cancel);
        if (made.Value is null) return new Result<IReadOnlyList<Step>>(null, made.Diagnostics);
        var steps = new Step[made.Value.Count];
        for (var i = 0; i < steps.Length; i++)
        {
            steps[i] = made.Value[i];
            if (made.Value[i] is not PathStep step) continue;
            if (options?.Sorting == CurveSorting.WithinLayers) steps[i] = step with { Group = new StepGroup(step.Path.Layer?.Index ?? -1) };
            if (options?.Sorting == CurveSorting.All) steps[i] = step with { Group = new StepGroup(0) };
        }
        return new Result<IReadOnlyList<Step>>(steps, made.Diagnostics);
    }

    /// <summary>The paths of curves in their order, without dots. Diagnostics are as in <see cref="ToSteps"/>.</summary>
    /// <exception cref="ArgumentException">The subdivision is out of range, or a curve is null.</exception>
    public static Result<IReadOnlyList<PrintPath>> ToPaths(
        IReadOnlyList<UserCurve> curves, CurveOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        var made = Make(curves, options ?? new CurveOptions(), withDots: false, progress, cancel);
        return new Result<IReadOnlyList<PrintPath>>(made.Value?.Cast<PathStep>().Select(s => s.Path).ToArray(), made.Diagnostics);
    }

    private static UserCurve Raised(UserCurve curve, int layer, CurveOptions options)
    {
        var z = options.FlatHeight + layer * options.Height;
        var raised = curve with { Curve = curve.Curve.Transformed(Affine.Move(new Vec3(0, 0, z))) };
        if (options.Layers == 0) return curve.Layer is { } own ? raised with { Layer = own with { Z = own.Z + z } } : raised;
        var thickness = layer == 0 ? options.FlatHeight : options.Height;
        return raised with { Layer = new Layer(layer, z, thickness), Height = curve.Height ?? thickness };
    }

    private static Result<IReadOnlyList<Step>> Make(
        IReadOnlyList<UserCurve> curves, CurveOptions options, bool withDots, IProgress<double>? progress, CancellationToken cancel)
    {
        if (curves is null) throw new ArgumentNullException(nameof(curves));
        var diagnostics = new DiagnosticList();
        // People draw flat, but at Z 0 the nozzle would scrape the bed.
        var isRaised = options.FlatHeight > 0 && !options.Strokes && curves.All(c => c is not null && c.Curve.Bounds is { Min.Z: 0, Max.Z: 0 })
            && !curves.All(c => c.Area == 0);
        if (isRaised)
            diagnostics.Add(Severity.Note, "curves.flat",
                $"The drawing is flat at Z 0. It is printed at Z {NumberFormatter.Format(options.FlatHeight, 3)}, the height of the first layer"
                + (options.Layers > 1 ? $", and stacked {NumberFormatter.Format(options.Layers)} layers high." : "."));
        else if (options.Layers > 0)
            return new Result<IReadOnlyList<Step>>("curves.not_flat",
                "Only a drawing that is flat at Z 0 and extrudes can be stacked in layers. Remove its Z values, or draw each layer.");
        var steps = new List<Step>(curves.Count);
        var run = new List<PrintPath>();
        var places = new List<SourceLocation>();
        var points = 0L;
        var maker = new PathMaker(options, diagnostics, cancel);
        var total = (long)curves.Count * Math.Max(1, options.Layers);
        for (var n = 0L; n < total; n++)
        {
            if ((n & 0xFF) == 0)
            {
                cancel.ThrowIfCancellationRequested();
                progress?.Report((double)n / total);
            }
            var i = (int)(n % curves.Count);
            var curve = curves[i] ?? throw new ArgumentException("A curve is null.", nameof(curves));
            if (isRaised) curve = Raised(curve, (int)(n / curves.Count), options);
            var source = curve.Source ?? new SourceLocation(Step: i);
            if (!(curve.Dot >= 0 && !double.IsInfinity(curve.Dot)))
            {
                diagnostics.Add(Severity.Error, "curves.bead", "The volume of a dot must be finite and 0 mm³ or more.", source);
                continue;
            }
            if (withDots && options.Dots > 0)
            {
                foreach (var point in PointsOf(curve.Curve, options, cancel)) Dot(point, options.Dots, source);
                continue;
            }
            if (curve.Dot > 0)
            {
                if (withDots) Dot(curve.Curve.Start, curve.Dot, source);
                if (!(curve.Curve.Bounds.Size.LengthSquared > 0)) continue;
            }
            var path = maker.Make(curve, source);
            if (path is null) continue;
            points += path.RawPoints.Length;
            if (options.Memory.Refuse(points * BytesPerPoint, $"Dividing the curves into more than {NumberFormatter.Format(points)} points", curve.Source,
                "Use a larger distance, tolerance or angle.") is { } tooMuch)
            {
                diagnostics.Add(tooMuch);
                break;
            }
            places.Add(curve.Name.Length > 0 ? source with { Key = source.Key ?? curve.Name } : source);
            run.Add(options.FitArcs > 0 ? PathArcs.Fit(path, options.FitArcs) : path);
        }
        EndRun();
        if (!diagnostics.HasErrors && steps.Count == 0) diagnostics.Add(Severity.Error, "curves.empty", "No curve to print.");
        if (diagnostics.HasErrors) return new Result<IReadOnlyList<Step>>(null, diagnostics.ToList());
        progress?.Report(1);
        return new Result<IReadOnlyList<Step>>(steps, diagnostics.ToList());

        void Dot(Vec3 at, double volume, SourceLocation place)
        {
            EndRun();
            steps.Add(new TravelStep(at, intent: TravelIntent.Return) { Source = place });
            steps.Add(new EventStep(new ExtrudeEvent(volume, options.DotSpeed, IsDot: true)) { Source = place });
        }

        // Paths between two dots may be joined.
        void EndRun()
        {
            var paths = options.MergeTolerance > 0 ? PathMerging.Merge(run, options.MergeTolerance) : run;
            for (int i = 0, next = 0; i < paths.Count; i++)
            {
                steps.Add(new PathStep(paths[i]) { Source = places[next++] });
                // A path of several curves states the first.
                while (paths.Count < run.Count && next < run.Count && i + 1 < paths.Count && run[next].Start != paths[i + 1].Start) next++;
            }
            run.Clear();
            places.Clear();
        }
    }

    private static IEnumerable<Vec3> PointsOf(Curve curve, CurveOptions options, CancellationToken cancel)
        => curve is PolylineCurve { Polyline: var line }
            ? Enumerable.Range(0, line.Count > 1 && line[0] == line[1] ? 1 : line.Count).Select(i => line[i])
            : CurveSubdivider.Subdivide(curve, options.Subdivision with { KeepArcs = false }, cancel).Points;
}

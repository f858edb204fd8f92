namespace Caterpillar.Curved;

/// <summary>
/// Projects paths that were made for a flat bed onto an object: heights above the bed become heights above its surface. For paths from slicing, curves,
/// turtles and traces.
/// </summary>
public static class SurfaceProjection
{
    /// <summary>Projects steps downward onto a surface. Segments are divided until they follow it within <c>curved_tolerance_mm</c>.</summary>
    /// <param name="steps">Paths, drawn travels and events. Events stay unchanged.</param>
    /// <param name="onto">Surface to print on.</param>
    /// <param name="setup">Print settings and printer. The print head limits the slope.</param>
    /// <param name="squeeze">Distance by which all paths are lowered, to press the first extrusions onto the surface, mm.</param>
    /// <param name="partial">True leaves out paths that are beyond the surface or too steep, instead of an error.</param>
    /// <param name="progress">Progress, 0 to 1.</param>
    /// <param name="cancel">Cancels the call.</param>
    /// <exception cref="ArgumentOutOfRangeException">The squeeze is negative or not finite.</exception>
    /// <exception cref="OperationCanceledException">The call was canceled.</exception>
    public static Result<IReadOnlyList<Step>> Project(
        IReadOnlyList<Step> steps, PlanSurface onto, PrintSetup setup, double squeeze = 0, bool partial = false,
        IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (steps is null) throw new ArgumentNullException(nameof(steps));
        if (onto is null) throw new ArgumentNullException(nameof(onto));
        if (setup is null) throw new ArgumentNullException(nameof(setup));
        if (!(squeeze >= 0) || double.IsInfinity(squeeze)) throw new ArgumentOutOfRangeException(nameof(squeeze), "The squeeze must not be negative.");
        var problems = new DiagnosticList();
        onto.Check(problems);
        if (problems.HasErrors) return new Result<IReadOnlyList<Step>>(null, problems.ToList());
        var settings = setup.Settings;
        var field = new VerticalField(onto.Moved(new Vec3(0, 0, -squeeze)), null);
        var (span, rise) = Extent(steps, onto);
        var steepest = HeadSlope.Limit(setup, span, rise);
        var rules = new LiftRules(settings, 0, steepest, null, partial)
        {
            FindsEdge = true, TipReach = setup.Printer.HeadOutline[0].Radius + settings.LineWidth / 2,
        };
        var lifter = new PathLifter(field, rules, null);
        var result = new List<Step>(steps.Count);
        for (var i = 0; i < steps.Count; i++)
        {
            cancel.ThrowIfCancellationRequested();
            switch (steps[i])
            {
                // Level combing does not know the surface; pieces that are left out join nothing.
                case PathStep path: result.AddRange(lifter.Lift(path).Select(Free)); break;
                case TravelStep travel: result.Add(new TravelStep(Over(travel.Points, field), travel.Speed, travel.Intent)); break;
                case var other: result.Add(other); break;
            }
            progress?.Report((i + 1.0) / steps.Count);
        }
        LiftFindings.Add(lifter.Report, rules, [result.OfType<PathStep>()], problems);
        return new Result<IReadOnlyList<Step>>(problems.HasErrors ? null : result, problems.ToList());
    }

    private static PathStep Free(PathStep step)
        => new(step.Path, step.Group) { KeepStart = step.KeepStart, Source = step.Source, Lines = step.Lines };

    private static (double Span, double Rise) Extent(IReadOnlyList<Step> steps, PlanSurface onto)
    {
        var paths = steps.OfType<PathStep>().Select(s => s.Path).ToArray();
        var span = paths.Aggregate(Bounds.Empty, (bounds, path) => bounds.Include(path.Bounds)).Size.LengthXY;
        return (span, Bounds.Of(paths.SelectMany(path => path.Points, (_, p) => p.WithZ(onto.Height(p.X, p.Y)))).Size.Z);
    }

    // Between drawn points the head follows the surface.
    private static List<Vec3> Over(IReadOnlyList<Vec3> points, LayerField field)
    {
        var result = new List<Vec3> { field.ToPart(points[0]) };
        for (var i = 1; i < points.Count; i++)
        {
            var parts = double.IsInfinity(field.Detail) ? 1 : (int)Math.Min(10_000, Math.Ceiling((points[i] - points[i - 1]).LengthXY / field.Detail) + 1);
            for (var k = 1; k <= parts; k++) result.Add(field.ToPart(Vec3.Lerp(points[i - 1], points[i], (double)k / parts)));
        }
        return result;
    }
}

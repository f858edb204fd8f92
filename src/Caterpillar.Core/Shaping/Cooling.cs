namespace Caterpillar.Shaping;

/// <summary>
/// Slows down small layers so that they cool before the next one: by Kanada's rule, by a minimum layer time, or both. It never raises a speed.
/// </summary>
public sealed record Cooling
{
    /// <summary>Minimum layer time in seconds. 0 = off. Paths without a layer are grouped by the height of their first vertex.</summary>
    public double MinLayerTime { get; init; }

    /// <summary>Kanada's rule (2015, figure 6): the maximum speed of a segment in mm/s is its length in mm plus 1.</summary>
    public bool SpeedByLength { get; init; }

    /// <summary>Minimum print speed, mm/s. No speed is lowered below it.</summary>
    public double MinPrintSpeed { get; init; } = 5;

    /// <summary>Speed in mm/s of beads without their own speed.</summary>
    public double ReferenceSpeed { get; init; } = 60;

    /// <summary>Maximum number of segments per second without a warning. More make printers stutter. 0 = no limit.</summary>
    public double MaxSegmentsPerSecond { get; init; } = 100;

    /// <summary>Lowers the speeds of the paths.</summary>
    /// <returns>
    /// The paths in the same order, with a note <c>shape.layer_time</c> if the minimum speed prevents the minimum layer time, and a warning
    /// <c>shape.short_segments</c> if a path has too many segments per second.
    /// </returns>
    public Result<IReadOnlyList<PrintPath>> Apply(IReadOnlyList<PrintPath> paths, CancellationToken cancel = default)
    {
        if (paths is null) throw new ArgumentNullException(nameof(paths));
        var problems = new DiagnosticList();
        var result = SpeedByLength ? paths.Select(ByLength).ToArray() : paths.ToArray();
        if (MinLayerTime > 0)
        {
            foreach (var layer in Enumerable.Range(0, result.Length).GroupBy(i => LayerKey(result[i])))
            {
                cancel.ThrowIfCancellationRequested();
                Stretch(result, layer.ToArray(), problems);
            }
        }
        for (var i = 0; i < result.Length && MaxSegmentsPerSecond > 0; i++) WarnOfShortSegments(result[i], i, problems);
        return new Result<IReadOnlyList<PrintPath>>(result, problems.ToList());
    }

    private static (string Object, double Z) LayerKey(PrintPath path) => path.Layer is { } layer ? (layer.Object, layer.Z) : ("", path.Start.Z);

    private double SpeedOf(PrintPath path, int segment) => path.BeadOf(segment).Speed is > 0 and var speed ? speed : ReferenceSpeed;

    private PrintPath ByLength(PrintPath path)
        => path.WithBeads(i => path.BeadOf(i) with { Speed = Math.Min(SpeedOf(path, i), Math.Max(path.LengthOf(i) + 1, MinPrintSpeed)) });

    // Speeds at the minimum cannot drop further, so the others have to drop more: repeated until no other hits the minimum.
    private void Stretch(PrintPath[] paths, int[] layer, DiagnosticList problems)
    {
        var slowed = SlowDown.To(Array.ConvertAll(layer, i => paths[i]), SpeedOf, MinLayerTime, MinPrintSpeed, out var reached);
        for (var k = 0; k < layer.Length; k++) paths[layer[k]] = slowed[k];
        if (reached) return;
        problems.Add(Severity.Note, "shape.layer_time",
            $"A layer takes less than {NumberFormatter.Format(MinLayerTime, 1)} s even at {NumberFormatter.Format(MinPrintSpeed, 1)} mm/s.",
            new SourceLocation(Step: layer[0]));
    }

    private void WarnOfShortSegments(PrintPath path, int number, DiagnosticList problems)
    {
        // Twenty segments in a row fill the buffer of a small controller.
        const int Window = 20;
        var time = 0.0;
        for (var i = 0; i < path.SegmentCount; i++)
        {
            time += path.LengthOf(i) / SpeedOf(path, i);
            if (i >= Window) time -= path.LengthOf(i - Window) / SpeedOf(path, i - Window);
            if (i < Window - 1 || time * MaxSegmentsPerSecond >= Window * (1 - 1e-9)) continue;
            problems.Add(Severity.Warning, "shape.short_segments",
                $"More than {NumberFormatter.Format(MaxSegmentsPerSecond, 0)} segments per second. Merge short segments or print slower.",
                    new SourceLocation(Step: number));
            return;
        }
    }
}

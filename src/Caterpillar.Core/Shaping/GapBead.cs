namespace Caterpillar.Shaping;

/// <summary>
/// Sizes beads to fill the gap below them: to earlier extrusions, a surface or the bed. For any paths, flat or curved, in print order. The area is vertical
/// gap · width · (length in plan / length). The gap is measured at the ends and in the middle of pieces (Simpson's rule). The width is the area of the given
/// bead divided by its height, so that a gap of that height keeps the bead unchanged.
/// </summary>
public sealed record GapBead
{
    /// <summary>Minimum gap, mm. Smaller gaps are printed as if they were this high.</summary>
    public double MinGap { get; init => field = value > 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), "The gap must be positive."); } = 0.05;

    /// <summary>Maximum gap, mm. Larger gaps are printed as if they were this high.</summary>
    public double MaxGap { get; init => field = value > 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), "The gap must be positive."); } = 1;

    /// <summary>Gap in mm above which there is only air and the bead stays unchanged.</summary>
    public double AirGap { get; init => field = value > 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), "The gap must be positive."); } = 3;

    /// <summary>Width of the extrusions, mm. 0 = width of each bead.</summary>
    public double Width { get; init => field = value >= 0 ? value : throw new ArgumentOutOfRangeException(nameof(value), "The width must not be negative."); }

    /// <summary>Maximum length of the pieces in which segments are measured, mm.</summary>
    public double Resolution { get; init => field = value > 0 ? value
        : throw new ArgumentOutOfRangeException(nameof(value), "The resolution must be positive."); } = 1;

    /// <summary>Height of the bed, mm. Null = no bed.</summary>
    public double? Bed { get; init; } = 0;

    /// <summary>A surface below the paths, for example a scanned object. Null = no surface.</summary>
    public TriMesh? Surface { get; init; }

    /// <summary>Bead shape, which determines the width that later paths find below them.</summary>
    public BeadShape Shape { get; init; } = BeadShape.Stadium;

    /// <summary>Limits from print settings: gaps of 0.25 to 2 layer heights, air above 4 layer heights, pieces of the subdivision distance.</summary>
    public static GapBead For(PrintSettings settings)
    {
        if (settings is null) throw new ArgumentNullException(nameof(settings));
        return new GapBead
        {
            MinGap = settings.LayerHeight / 4,
            MaxGap = settings.LayerHeight * 2,
            AirGap = settings.LayerHeight * 4,
            Resolution = settings.SubdivisionDistance,
            Shape = settings.BeadShape,
        };
    }

    /// <summary>Sizes the beads of the paths to fill the gap below. Pieces of one segment with the same gap stay one segment.</summary>
    /// <returns>The paths in the same order, or an error if the width of a bead is unknown. Notes on gaps that the limits changed.</returns>
    public Result<IReadOnlyList<PrintPath>> Apply(IReadOnlyList<PrintPath> paths, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (paths is null) throw new ArgumentNullException(nameof(paths));
        var problems = new DiagnosticList();
        var probe = new GapProbe(this);
        var shaped = new List<PrintPath>(paths.Count);
        for (var i = 0; i < paths.Count; i++)
        {
            cancel.ThrowIfCancellationRequested();
            if (Fill(paths[i], i, probe, problems) is { } path) shaped.Add(path);
            progress?.Report((i + 1.0) / paths.Count);
        }
        return new Result<IReadOnlyList<PrintPath>>(problems.HasErrors ? null : shaped, problems.ToList());
    }

    private PrintPath? Fill(PrintPath path, int number, GapProbe probe, DiagnosticList problems)
    {
        var points = new List<Vec3> { path.Start };
        var beads = new List<Bead>();
        var arcs = new List<Arc?>();
        probe.Begin(path);
        for (var i = 0; i < path.SegmentCount; i++)
        {
            var (start, end, bead, arc) = (path.Points[i], path.EndOf(i), path.BeadOf(i), path.ArcOf(i));
            var width = Width > 0 ? Width : bead.Height > 0 ? bead.Area / bead.Height : 0;
            if (bead.Area > 0 && !(width > 0))
            {
                problems.Add(Severity.Error, "gap.no_width", "A bead has no height. Set the extrusion width.", new SourceLocation(Step: number));
                return null;
            }
            var parts = (int)Math.Min(1_000_000, Math.Max(1, Math.Ceiling(path.LengthOf(i) / Resolution - 1e-9)));
            var from = start;
            var first = beads.Count;
            for (var k = 1; k <= parts; k++)
            {
                var to = k == parts ? end : Arc.PointAt(arc, start, end, (double)k / parts);
                var middle = Arc.PointAt(arc, start, end, (k - 0.5) / parts);
                var piece = arc is { } turn ? turn with { Sweep = turn.Sweep / parts } : (Arc?)null;
                var own = bead;
                if (bead.Area > 0)
                {
                    var gap = (probe.Gap(from, width) + 4 * probe.Gap(middle, width) + probe.Gap(to, width)) / 6;
                    var length = piece?.Length(from, to) ?? from.DistanceTo(to);
                    own = Filling(gap, length, to.Z - from.Z, width, bead, number, problems);
                }
                probe.Print(from, to, own, piece);
                if (beads.Count > first && Same(beads[beads.Count - 1], own))
                {
                    points[points.Count - 1] = to;
                    if (piece is { } more) arcs[arcs.Count - 1] = more with { Sweep = arcs[arcs.Count - 1]!.Value.Sweep + more.Sweep };
                }
                else
                {
                    points.Add(to);
                    beads.Add(own);
                    arcs.Add(piece);
                }
                from = to;
            }
        }
        probe.End();
        if (path.IsClosed) points.RemoveAt(points.Count - 1);
        return path.WithGeometry(points, beads, path.IsClosed, arcs);
    }

    // The bead that fills a gap under a piece of a length and a rise.
    private Bead Filling(double gap, double length, double rise, double width, Bead bead, int number, DiagnosticList problems)
    {
        var place = new SourceLocation(Step: number);
        if (!(gap <= AirGap))
        {
            problems.Add(Severity.Note, "gap.air", "A piece of a path has nothing underneath. Its bead stays unchanged.", place);
            return bead;
        }
        if (gap < MinGap - 1e-9)
        {
            problems.Add(Severity.Warning, "gap.narrow",
                $"A gap of {NumberFormatter.Format(gap, 3)} mm is below the minimum of {NumberFormatter.Format(MinGap, 3)} mm.", place);
        }
        if (gap > MaxGap + 1e-9)
        {
            problems.Add(Severity.Note, "gap.wide",
                $"A gap of {NumberFormatter.Format(gap, 3)} mm is above the maximum of {NumberFormatter.Format(MaxGap, 3)} mm.", place);
        }
        gap = Math.Min(MaxGap, Math.Max(MinGap, gap));
        // A vertical piece has no gap below: its bead stays.
        var share = length > 0 ? Math.Sqrt(Math.Max(0, 1 - rise / length * (rise / length))) : 0;
        return share < UprightShare ? bead : new Bead(gap * share * width, gap * share, bead.Speed);
    }

    // Steeper than 80 degrees.
    private const double UprightShare = 0.17;

    private static bool Same(Bead a, Bead b)
        => a.Speed == b.Speed && Math.Abs(a.Area - b.Area) <= 1e-6 * a.Area && Math.Abs(a.Height - b.Height) <= 1e-6 * a.Height;
}

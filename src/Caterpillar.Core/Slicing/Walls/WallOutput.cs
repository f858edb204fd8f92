namespace Caterpillar.Slicing;

/// <summary>Collects walls: spacings become widths, and points that change nothing are left away.</summary>
internal sealed class WallOutput(WallRules rules)
{
    // Shares of the nominal width by which the width may be off. The side of the outer wall is the surface of the part.
    private const double OuterWidthShare = 0.015;
    private const double InnerWidthShare = 0.02;

    // Largest change of width within a segment of an outer wall, so that its side is a fourth of that off at most, and the shortest piece of one; mm.
    private const double LargestStep = 0.05;
    private const double ShortestStep = 0.1;

    // mm; a printer is slow in shorter moves. They go where the wall stays within a tolerance, which is larger where it is not seen.
    private const double ShortestMove = 0.1;
    private const double ShortTolerance = 0.01;
    private const double InnerShortTolerance = 0.04;

    public List<WallPath> Paths { get; } = [];

    public List<ThinPlace> TooThin { get; } = [];

    public WallResult Result(Region inside) => new(Paths, inside, TooThin);

    /// <summary>Loops of one width.</summary>
    public void Loops(Region line, int index, double width, RegionEngine engine)
    {
        // Offsetting leaves corners of rounding size, which a printer need not see.
        foreach (var contour in line.Simplified(ToleranceOf(index), engine).Contours)
        {
            var points = contour.Raw;
            if (LongMoves(points, closed: true, index) is { } kept) points = Array.ConvertAll(kept, i => points[i]);
            if (points.Length < 3) continue;
            Paths.Add(new WallPath(points, Enumerable.Repeat(width, points.Length).ToArray(), Closed: true, index, IsExtrusion: false));
        }
    }

    /// <summary>A loop at varying distances from the border, mm: half of what it covers.</summary>
    public void Loop(GridPoint[] ring, double[] distances, int index)
        => Add(Array.ConvertAll(ring, Grid.ToMm), Array.ConvertAll(distances, d => rules.Width(2 * d)), closed: true, index, isExtrusion: false);

    /// <summary>Single extrusions, at least as wide as a spacing.</summary>
    public void Extrusions(List<MedialExtrusion> extrusions, int index, double least)
    {
        var most = Math.Max(rules.Spacing(rules.MaxWidth), rules.Spacing(rules.OuterWidth));
        foreach (var extrusion in extrusions)
        {
            if (extrusion.Count < 2) continue;
            var widths = new double[extrusion.Count];
            for (var i = 0; i < widths.Length; i++) widths[i] = rules.Width(Math.Min(Math.Max(2 * extrusion.Radii[i], least), most));
            Add(extrusion.Points, widths, extrusion.Closed, index, isExtrusion: true);
        }
    }

    private double ToleranceOf(int index) => index == 0 ? rules.Tolerance : Math.Max(rules.Tolerance, rules.InnerTolerance);

    private static int[]? LongMoves(Vec3[] points, bool closed, int index)
        => ShortSegments.Keep(points, closed, ShortestMove, index == 0 ? ShortTolerance : InnerShortTolerance, double.PositiveInfinity);

    private void Add(IReadOnlyList<Vec3> points, IReadOnlyList<double> widths, bool closed, int index, bool isExtrusion)
    {
        var visible = index == 0 && !isExtrusion;
        var tolerance = ToleranceOf(visible ? 0 : 1);
        var widthTolerance = visible ? OuterWidthShare * rules.OuterWidth : InnerWidthShare * rules.InnerWidth;
        var (kept, keptWidths) = PathThinning.Thin(points, widths, closed, tolerance, widthTolerance);
        if (LongMoves(kept, closed, index) is { } few) (kept, keptWidths) = (Array.ConvertAll(few, i => kept[i]), Array.ConvertAll(few, i => keptWidths[i]));
        if (kept.Length < 2 || (closed && kept.Length < 3)) return;
        var thinned = kept.Length < points.Count;
        if (index == 0) (kept, keptWidths) = WidthSteps.Split(kept, keptWidths, closed, LargestStep, ShortestStep);
        var path = new WallPath(kept, keptWidths, closed, index, isExtrusion);
        Paths.Add(!thinned ? path : path.WithVolume(WallPath.VolumeOf(points, widths, closed, rules), rules));
    }
}

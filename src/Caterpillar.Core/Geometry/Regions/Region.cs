namespace Caterpillar.Geometry;

/// <summary>
/// A planar area with holes, bounded by closed contours that do not cross but may touch at vertices. Outlines run counterclockwise, holes clockwise.
/// Coordinates are in mm, within ±5368.709. Internally they are integers of 10 nm, so that all operations are robust. Z is ignored and returned as 0.
/// Immutable and thread-safe.
/// </summary>
public sealed class Region
{
    private const int GroupSize = 32;
    private readonly GridPoint[][] _paths;
    private Polyline[]? _contours;
    private Region[]? _islands;
    private RegionIndex? _index;
    private GridBox[]? _boxes;
    private GridBox[]? _groups;

    private Region(GridPoint[][] paths) => _paths = paths;

    /// <summary>The empty region.</summary>
    public static Region Empty { get; } = new(Array.Empty<GridPoint[]>());

    /// <summary>
    /// The area inside contours, all of which count as closed. The fill rule resolves crossings and overlaps; spikes and repeated points are removed. Vertices
    /// within about 15 nm of another edge snap to it. Contours with fewer than three points or without area are ignored.
    /// </summary>
    /// <param name="contours">Contours in mm, in any order.</param>
    /// <param name="rule">Winding numbers that count as inside.</param>
    /// <param name="closeHoles">True removes all holes and keeps the filled outer outlines.</param>
    /// <exception cref="ArgumentException">A coordinate is not a number or beyond ±5368.709 mm.</exception>
    public static Region From(IEnumerable<Polyline> contours, FillRule rule = FillRule.NonZero, bool closeHoles = false)
    {
        if (contours is null) throw new ArgumentNullException(nameof(contours));
        return From(contours, rule, closeHoles, new RegionEngine());
    }

    internal static Region From(IEnumerable<Polyline> contours, FillRule rule, bool closeHoles, RegionEngine engine)
    {
        engine.Clear();
        // Bodies that touch must not be separated by a slit that only comes from the rounding of their vertices.
        engine.Arrangement.Reach = 3;
        foreach (var contour in contours)
        {
            if (contour is null) throw new ArgumentException("A contour is missing.", nameof(contours));
            if (contour.Count > 2) engine.Add(ToGrid(contour.Raw, nameof(contours)));
        }
        return FromEngine(engine, rule, closeHoles);
    }

    /// <summary>The area inside one contour.</summary>
    /// <exception cref="ArgumentException">A coordinate is not a number or beyond ±5368.709 mm.</exception>
    public static Region From(Polyline contour, FillRule rule = FillRule.NonZero)
    {
        if (contour is null) throw new ArgumentNullException(nameof(contour));
        return From(new[] { contour }, rule);
    }

    /// <summary>A rectangle along X and Y, mm. Empty if it has no area.</summary>
    /// <exception cref="ArgumentException">A coordinate is not a number or beyond ±5368.709 mm.</exception>
    public static Region Rectangle(double minX, double minY, double maxX, double maxY)
    {
        int x0 = Grid.FromMm(minX, nameof(minX)), y0 = Grid.FromMm(minY, nameof(minY));
        int x1 = Grid.FromMm(maxX, nameof(maxX)), y1 = Grid.FromMm(maxY, nameof(maxY));
        if (x1 <= x0 || y1 <= y0) return Empty;
        return new Region(new[] { new[] { new GridPoint(x0, y0), new GridPoint(x1, y0), new GridPoint(x1, y1), new GridPoint(x0, y1) } });
    }

    /// <summary>True if the region has no area.</summary>
    public bool IsEmpty => _paths.Length == 0;

    /// <summary>Area in mm², not counting holes.</summary>
    public double Area => _paths.Sum(path => (double)Grid.DoubleArea(path, 0, path.Length)) / (2 * Grid.PerMm * Grid.PerMm);

    /// <summary>Total length of all contours, mm.</summary>
    public double Perimeter => _paths.Sum(Grid.Length) / Grid.PerMm;

    /// <summary>Bounding box in mm, at Z = 0.</summary>
    public Bounds Bounds
        => IsEmpty ? Bounds.Empty : new Bounds(Grid.ToMm(new GridPoint(Box.MinX, Box.MinY)), Grid.ToMm(new GridPoint(Box.MaxX, Box.MaxY)));

    /// <summary>The closed contours in mm at Z = 0: outlines counterclockwise, holes clockwise.</summary>
    public IReadOnlyList<Polyline> Contours
        => _contours ?? Interlocked.CompareExchange(ref _contours, Array.ConvertAll(_paths, ToPolyline), null) ?? _contours!;

    /// <summary>
    /// The connected pieces, in the order of their outlines. Each has its outline first, then its holes. An island in a hole is a piece of its own.
    /// </summary>
    public IReadOnlyList<Region> Islands => _islands ?? Interlocked.CompareExchange(ref _islands, IslandFinder.Split(this), null) ?? _islands!;

    /// <summary>True if the point (mm) is inside or within 5 nm of the boundary.</summary>
    public bool Contains(double x, double y) => Index.Contains(x * Grid.PerMm, y * Grid.PerMm);

    /// <summary>True if the whole straight line from a to b (mm) is inside. The boundary counts as inside.</summary>
    /// <exception cref="ArgumentException">A coordinate is not a number or beyond ±5368.709 mm.</exception>
    public bool ContainsLine(Vec3 a, Vec3 b)
    {
        Grid.FromMm(a, nameof(a));
        Grid.FromMm(b, nameof(b));
        return !IsEmpty && new LineClipper(Index, outside: false).IsWhole(a, b);
    }

    /// <summary>The region without islands and holes whose contour encloses less than <paramref name="area"/> mm².</summary>
    /// <exception cref="ArgumentException">The area is negative or not a number.</exception>
    public Region WithoutSmallContours(double area)
    {
        if (!(area >= 0)) throw new ArgumentException("The area must not be negative.", nameof(area));
        // Contours inside a dropped one are even smaller, so dropping contours one by one leaves a valid region.
        return Own(Array.FindAll(_paths, path => Math.Abs((double)Grid.DoubleArea(path, 0, path.Length)) >= 2 * area * Grid.PerMm * Grid.PerMm));
    }

    /// <summary>The area in either region.</summary>
    public Region Union(Region other) => this.Union(other, new RegionEngine());

    /// <summary>The area in both regions.</summary>
    public Region Intersect(Region other) => this.Intersect(other, new RegionEngine());

    /// <summary>The area in this region but not in the other.</summary>
    public Region Subtract(Region other) => this.Subtract(other, new RegionEngine());

    /// <summary>The area in any of the regions, in one pass.</summary>
    public static Region Union(IEnumerable<Region> regions) => Union(regions, null);

    internal static Region Union(IEnumerable<Region> regions, RegionEngine? engine)
    {
        if (regions is null) throw new ArgumentNullException(nameof(regions));
        var parts = regions.Where(region => !(region ?? throw new ArgumentException("A region is missing.", nameof(regions))).IsEmpty).ToList();
        return parts.Count < 2 ? parts.Count == 0 ? Empty : parts[0] : RegionOperations.Combine(parts, [], InsideRule.Positive, engine ?? new RegionEngine());
    }

    /// <summary>The area in any of some regions and in none of others, in one pass.</summary>
    internal static Region Difference(IReadOnlyList<Region> areas, IReadOnlyList<Region> without, RegionEngine engine)
        => RegionOperations.Combine(areas, without, InsideRule.Difference, engine);

    /// <summary>Regions that are apart from each other as one.</summary>
    internal static Region Beside(IEnumerable<Region> regions) => Own([.. regions.SelectMany(region => region._paths)]);

    /// <summary>
    /// The region grown or shrunk by a distance. Corners that open up get a join; the others are exact. Raw offset curve, then union by positive winding
    /// numbers (Chen and McMains, "Polygon offsetting by computing winding numbers", 2005).
    /// </summary>
    /// <param name="distance">Distance in mm: positive grows, negative shrinks.</param>
    /// <param name="join">Join style at corners.</param>
    /// <param name="miterLimit">Miter limit as a multiple of the distance, at least 1. Longer miters are cut square.</param>
    /// <param name="arcTolerance">Maximum deviation of the chords of round joins from the arc, in mm, above 0.</param>
    /// <exception cref="ArgumentException">A parameter is not a number or out of range, or the result exceeds ±5368.709 mm.</exception>
    public Region Offset(double distance, JoinStyle join = JoinStyle.Miter, double miterLimit = 2, double arcTolerance = 0.005)
        => this.Offset(distance, join, miterLimit, arcTolerance, new RegionEngine());

    /// <summary>
    /// The parts of lines inside the region (or, with <paramref name="outside"/>, outside it). The boundary counts as inside. Original points keep their Z. New
    /// points are on the boundary, with interpolated Z. A closed polyline stays closed unless it is cut.
    /// </summary>
    /// <exception cref="ArgumentException">A coordinate is not a number or beyond ±5368.709 mm.</exception>
    public IReadOnlyList<Polyline> ClipLines(IEnumerable<Polyline> lines, bool outside = false)
    {
        if (lines is null) throw new ArgumentNullException(nameof(lines));
        var clipper = new PolylineClipper(Index, outside);
        foreach (var line in lines)
        {
            if (line is null) throw new ArgumentException("A line is missing.", nameof(lines));
            foreach (var p in line.Raw) Grid.FromMm(p, nameof(lines));
            clipper.Clip(line);
        }
        return clipper.Pieces;
    }

    /// <summary>
    /// The parts of parallel lines inside the region, sorted by row and along the row. A line along a boundary is inside if the region is on its left.
    /// (The half-open rule.)
    /// </summary>
    /// <param name="angle">Direction of the lines, degrees counterclockwise from +X.</param>
    /// <param name="spacing">Distance between lines in mm, above 0.</param>
    /// <param name="phase">Distance of row 0 from the origin in mm, positive to the left of the direction.</param>
    /// <exception cref="ArgumentException">A parameter is not a number, the spacing is not positive, or there would be more than 10 million rows.</exception>
    public IReadOnlyList<HatchLine> HatchLines(double angle, double spacing, double phase = 0) => HatchScanner.Scan(_paths, angle, spacing, phase);

    /// <summary>The contours on the grid, for code that works there. Not to be changed.</summary>
    internal GridPoint[][] Paths => _paths;

    internal RegionIndex Index => _index ?? Interlocked.CompareExchange(ref _index, new RegionIndex(_paths), null) ?? _index!;

    /// <summary>The boxes of the contours.</summary>
    internal GridBox[] Boxes => _boxes ?? Interlocked.CompareExchange(ref _boxes, Array.ConvertAll(_paths, GridBox.Of), null) ?? _boxes!;

    /// <summary>The box of the whole region, on the grid.</summary>
    internal GridBox Box => GridBox.Around(Groups, 0, Groups.Length);

    /// <summary>The numbers of the contours whose boxes reach into one of some boxes, ascending.</summary>
    internal IEnumerable<int> Reaching(GridBox[] places)
    {
        for (var group = 0; group < Groups.Length; group++)
        {
            var around = Groups[group];
            if (!GridBox.Overlap(places, around)) continue;
            var here = places.Length == 1 ? places : Array.FindAll(places, p => GridBox.Overlap(p, around));
            for (var i = group * GroupSize; i < Math.Min((group + 1) * GroupSize, Boxes.Length); i++)
            {
                if (GridBox.Overlap(here, Boxes[i])) yield return i;
            }
        }
    }

    // The boxes around so many contours that follow each other, and so mostly lie together.
    private GridBox[] Groups
    {
        get
        {
            if (_groups is { } known) return known;
            var groups = new GridBox[(Boxes.Length + GroupSize - 1) / GroupSize];
            for (var i = 0; i < groups.Length; i++) groups[i] = GridBox.Around(Boxes, i * GroupSize, Math.Min((i + 1) * GroupSize, Boxes.Length));
            return _groups = groups;
        }
    }

    /// <summary>Takes ownership of valid paths without a check.</summary>
    internal static Region Own(GridPoint[][] paths) => paths.Length == 0 ? Empty : new Region(paths);

    internal static GridPoint[] ToGrid(Vec3[] points, string parameter) => Array.ConvertAll(points, p => Grid.FromMm(p, parameter));

    internal static Polyline ToPolyline(GridPoint[] path) => Polyline.Own(Array.ConvertAll(path, Grid.ToMm), closed: true);

    private static Region FromEngine(RegionEngine engine, FillRule rule, bool closeHoles)
    {
        var paths = engine.Run(rule switch
        {
            FillRule.NonZero => InsideRule.NonZero,
            FillRule.EvenOdd => InsideRule.EvenOdd,
            FillRule.Positive => InsideRule.Positive,
            _ => throw new ArgumentOutOfRangeException(nameof(rule), rule, "Unknown fill rule."),
        });
        if (!closeHoles) return Own(paths);
        engine.Clear();
        foreach (var path in paths)
        {
            if (Grid.DoubleArea(path, 0, path.Length) > 0) engine.Add(path);
        }
        return Own(engine.Run(InsideRule.Positive));
    }
}

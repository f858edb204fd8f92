using System;
using System.Collections.Generic;
using System.Threading;

namespace Caterpillar.Geometry;

/// <summary>
/// A flat area with holes, bounded by closed contours that do not cross: outers counterclockwise, holes clockwise; they may touch at vertices.
/// Coordinates are mm in the interface and integers of 10 nm internally, so all decisions are exact; |coordinate| ≤ 5368.709 mm. Z is ignored and
/// returned as 0. Immutable and thread-safe.
/// </summary>
public sealed partial class Region
{
    private readonly GridPoint[][] _paths;
    private Polyline[]? _contours;
    private Region[]? _islands;
    private RegionIndex? _index;

    private Region(GridPoint[][] paths) => _paths = paths;

    /// <summary>Nothing.</summary>
    public static Region Empty { get; } = new(Array.Empty<GridPoint[]>());

    /// <summary>
    /// The area inside contours, each taken as closed. Crossings, overlaps, spikes and repeated points are resolved by the rule; vertices within about 15 nm of
    /// another edge are snapped to it; contours of fewer than three points or without area give nothing.
    /// </summary>
    /// <param name="contours">Contours in mm, in any order.</param>
    /// <param name="rule">Which winding numbers are inside.</param>
    /// <param name="closeHoles">Drop all holes: the outermost outlines remain, filled.</param>
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

    /// <summary>A rectangle with sides along X and Y, in mm; empty when it has no area.</summary>
    /// <exception cref="ArgumentException">A coordinate is not a number or beyond ±5368.709 mm.</exception>
    public static Region Rectangle(double minX, double minY, double maxX, double maxY)
    {
        int x0 = Grid.FromMm(minX, nameof(minX)), y0 = Grid.FromMm(minY, nameof(minY));
        int x1 = Grid.FromMm(maxX, nameof(maxX)), y1 = Grid.FromMm(maxY, nameof(maxY));
        if (x1 <= x0 || y1 <= y0) return Empty;
        return new Region(new[] { new[] { new GridPoint(x0, y0), new GridPoint(x1, y0), new GridPoint(x1, y1), new GridPoint(x0, y1) } });
    }

    /// <summary>It has no area.</summary>
    public bool IsEmpty => _paths.Length == 0;

    /// <summary>Area in mm², without holes.</summary>
    public double Area
    {
        get
        {
            var sum = 0.0;
            foreach (var path in _paths) sum += Grid.DoubleArea(path, 0, path.Length);
            return sum / (2 * Grid.PerMm * Grid.PerMm);
        }
    }

    /// <summary>Length in mm of all contours.</summary>
    public double Perimeter
    {
        get
        {
            var sum = 0.0;
            foreach (var path in _paths)
            {
                var a = path[path.Length - 1];
                foreach (var b in path)
                {
                    double dx = (double)b.X - a.X, dy = (double)b.Y - a.Y;
                    sum += Math.Sqrt(dx * dx + dy * dy);
                    a = b;
                }
            }
            return sum / Grid.PerMm;
        }
    }

    /// <summary>Box in mm, with Z 0.</summary>
    public Bounds Bounds
    {
        get
        {
            var box = GridBox.Nothing;
            foreach (var path in _paths) box.Include(GridBox.Of(path));
            return IsEmpty ? Bounds.Empty : new Bounds(Grid.ToMm(new GridPoint(box.MinX, box.MinY)), Grid.ToMm(new GridPoint(box.MaxX, box.MaxY)));
        }
    }

    /// <summary>Number of vertices of all contours.</summary>
    public int VertexCount
    {
        get
        {
            var count = 0;
            foreach (var path in _paths) count += path.Length;
            return count;
        }
    }

    /// <summary>The contours in mm, closed, at Z 0: outers counterclockwise, holes clockwise.</summary>
    public IReadOnlyList<Polyline> Contours
    {
        get
        {
            if (_contours is not null) return _contours;
            var contours = new Polyline[_paths.Length];
            for (var i = 0; i < contours.Length; i++) contours[i] = ToPolyline(_paths[i]);
            return Interlocked.CompareExchange(ref _contours, contours, null) ?? contours;
        }
    }

    /// <summary>True if the point (mm) lies inside or within 5 nm of the boundary.</summary>
    public bool Contains(double x, double y) => Index.Contains(x * Grid.PerMm, y * Grid.PerMm);

    /// <summary>True if the whole straight line from a to b (mm) lies inside; the boundary is inside.</summary>
    /// <exception cref="ArgumentException">A coordinate is not a number or beyond ±5368.709 mm.</exception>
    public bool ContainsLine(Vec3 a, Vec3 b)
    {
        Grid.FromMm(a, nameof(a));
        Grid.FromMm(b, nameof(b));
        return !IsEmpty && new LineClipper(Index, outside: false).IsWhole(a, b);
    }

    /// <summary>The same region moved by (x, y) mm, rounded to grid steps.</summary>
    /// <exception cref="ArgumentException">A distance is not a number, or the result would leave ±5368.709 mm.</exception>
    public Region Moved(double x, double y)
    {
        int dx = Grid.FromMm(x, nameof(x)), dy = Grid.FromMm(y, nameof(y));
        var bounds = Bounds;
        if (IsEmpty || (dx == 0 && dy == 0)) return this;
        Grid.FromMm(bounds.Min.X + x, nameof(x));
        Grid.FromMm(bounds.Max.X + x, nameof(x));
        Grid.FromMm(bounds.Min.Y + y, nameof(y));
        Grid.FromMm(bounds.Max.Y + y, nameof(y));
        var paths = new GridPoint[_paths.Length][];
        for (var c = 0; c < paths.Length; c++)
        {
            paths[c] = new GridPoint[_paths[c].Length];
            for (var i = 0; i < paths[c].Length; i++) paths[c][i] = new GridPoint(_paths[c][i].X + dx, _paths[c][i].Y + dy);
        }
        return new Region(paths);
    }

    /// <summary>Without islands and holes whose contour encloses less than an area in mm².</summary>
    /// <exception cref="ArgumentException">The area is negative or not a number.</exception>
    public Region WithoutSmallContours(double area)
    {
        if (!(area >= 0)) throw new ArgumentException("The area must not be negative.", nameof(area));
        // Contours inside a dropped one are even smaller, so dropping contours one by one leaves a valid region.
        return Own(Array.FindAll(_paths, path => Math.Abs((double)Grid.DoubleArea(path, 0, path.Length)) >= 2 * area * Grid.PerMm * Grid.PerMm));
    }

    /// <summary>The contours on the grid, for code that works there. Not to be changed.</summary>
    internal GridPoint[][] Paths => _paths;

    internal RegionIndex Index => _index ?? Interlocked.CompareExchange(ref _index, new RegionIndex(_paths), null) ?? _index!;

    /// <summary>Takes ownership of valid paths without a check.</summary>
    internal static Region Own(GridPoint[][] paths) => paths.Length == 0 ? Empty : new Region(paths);

    internal static GridPoint[] ToGrid(Vec3[] points, string parameter)
    {
        var path = new GridPoint[points.Length];
        for (var i = 0; i < path.Length; i++) path[i] = Grid.FromMm(points[i], parameter);
        return path;
    }

    internal static Polyline ToPolyline(GridPoint[] path)
    {
        var points = new Vec3[path.Length];
        for (var i = 0; i < points.Length; i++) points[i] = Grid.ToMm(path[i]);
        return Polyline.Own(points, closed: true);
    }

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

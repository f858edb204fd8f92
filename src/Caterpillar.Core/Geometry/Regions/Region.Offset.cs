using System;
using System.Collections.Generic;

namespace Caterpillar.Geometry;

public sealed partial class Region
{
    /// <summary>
    /// All points within a distance of the region, or, for a negative distance, all points of the region that are farther than that from the boundary. Corners
    /// that are convex toward the offset get a join; the others are exact. Raw offset curve, then union by positive winding numbers (Chen and McMains, "Polygon
    /// offsetting by computing winding numbers", 2005).
    /// </summary>
    /// <param name="distance">mm; positive grows, negative shrinks.</param>
    /// <param name="join">The join at corners.</param>
    /// <param name="miterLimit">Miter limit, in distances; at least 1. Longer ones are cut square.</param>
    /// <param name="arcTolerance">Maximum deviation, in mm, of the chords of round joins from the arc; positive.</param>
    /// <exception cref="ArgumentException">A parameter is not a number or out of its range, or the result would leave the grid.</exception>
    public Region Offset(double distance, JoinStyle join = JoinStyle.Miter, double miterLimit = 2, double arcTolerance = 0.005)
        => Offset(distance, join, miterLimit, arcTolerance, new RegionEngine());

    /// <summary>Shrunk and grown again with round joins: without parts narrower than two radii (mm).</summary>
    /// <exception cref="ArgumentException">The radius is negative, not a number or too large.</exception>
    public Region Opened(double radius, double arcTolerance = 0.005) => ThereAndBack(radius, -1, arcTolerance);

    /// <summary>Grown and shrunk again with round joins: without gaps narrower than two radii (mm).</summary>
    /// <exception cref="ArgumentException">The radius is negative, not a number or too large.</exception>
    public Region Closed(double radius, double arcTolerance = 0.005) => ThereAndBack(radius, 1, arcTolerance);

    /// <summary>
    /// All points within a distance of lines: the area covered by strokes of twice that width. Round joins and caps by default; with the others, ends are cut
    /// square at the distance.
    /// </summary>
    /// <param name="lines">Open or closed lines in mm; a closed one is a loop, not its inside.</param>
    /// <param name="distance">mm, half of the strokes' width; positive.</param>
    /// <param name="join">The join at corners.</param>
    /// <param name="miterLimit">Miter limit, in distances; at least 1.</param>
    /// <param name="arcTolerance">Maximum deviation, in mm, of the chords of round joins from the arc; positive.</param>
    /// <exception cref="ArgumentException">A parameter or a coordinate is not a number or out of its range, or the result would leave the grid.</exception>
    public static Region Around(IEnumerable<Polyline> lines, double distance, JoinStyle join = JoinStyle.Round, double miterLimit = 2,
        double arcTolerance = 0.005)
    {
        if (lines is null) throw new ArgumentNullException(nameof(lines));
        if (!(distance >= 0.5 / Grid.PerMm)) throw new ArgumentException("The distance must be positive.", nameof(distance));
        var engine = new RegionEngine();
        var curve = Curve(engine, distance, join, miterLimit, arcTolerance);
        foreach (var line in lines)
        {
            if (line is null) throw new ArgumentException("A line is missing.", nameof(lines));
            var path = ToGrid(line.Raw, nameof(lines));
            if (Reach(GridBox.Of(path)) + curve.Reach > Grid.Limit) throw new ArgumentException("The strokes would leave ±5368.709 mm.", nameof(distance));
            if (line.IsClosed && path.Length > 2)
            {
                // Both sides of the loop; the winding numbers of its inside cancel.
                Add(WithoutRepeats(path, closed: true), curve, engine);
                Array.Reverse(path);
                Add(WithoutRepeats(path, closed: true), curve, engine);
            }
            else
            {
                Add(ThereAndBack(WithoutRepeats(path, closed: false)), curve, engine);
            }
        }
        return Own(engine.Run(InsideRule.Positive));
    }

    internal Region Offset(double distance, JoinStyle join, double miterLimit, double arcTolerance, RegionEngine engine)
    {
        var curve = Curve(engine, distance, join, miterLimit, arcTolerance);
        var d = distance * Grid.PerMm;
        if (IsEmpty || Math.Abs(d) < 0.5) return this;
        engine.Clear();
        foreach (var path in _paths)
        {
            var box = GridBox.Of(path);
            var narrow = Math.Min((double)box.MaxX - box.MinX, (double)box.MaxY - box.MinY) <= 2 * Math.Abs(d);
            // An outline narrower than two distances vanishes with its content; so does a hole that is filled.
            if (narrow && Grid.DoubleArea(path, 0, path.Length) > 0 == d < 0) continue;
            if (Reach(box) + curve.Reach > Grid.Limit) throw new ArgumentException("The offset would leave ±5368.709 mm.", nameof(distance));
            curve.Build(path);
            engine.Arrangement.Add(curve.Points, 0, curve.Count, 0);
        }
        return Own(engine.Run(InsideRule.Positive));
    }

    private Region ThereAndBack(double radius, int sign, double arcTolerance)
    {
        if (!(radius >= 0)) throw new ArgumentException("The radius must not be negative.", nameof(radius));
        var engine = new RegionEngine();
        return Offset(sign * radius, JoinStyle.Round, 2, arcTolerance, engine).Offset(-sign * radius, JoinStyle.Round, 2, arcTolerance, engine);
    }

    private static OffsetCurve Curve(RegionEngine engine, double distance, JoinStyle join, double miterLimit, double arcTolerance)
    {
        if (double.IsNaN(distance) || double.IsInfinity(distance)) throw new ArgumentException("The distance must be a number.", nameof(distance));
        if (!(miterLimit >= 1) || double.IsInfinity(miterLimit)) throw new ArgumentException("The miter limit must be at least 1.", nameof(miterLimit));
        if (!(arcTolerance > 0)) throw new ArgumentException("The arc tolerance must be positive.", nameof(arcTolerance));
        if (join is not (JoinStyle.Miter or JoinStyle.Round or JoinStyle.Square)) throw new ArgumentOutOfRangeException(nameof(join), join, "Unknown join.");
        engine.Curve.Set(distance * Grid.PerMm, join, miterLimit, arcTolerance * Grid.PerMm);
        return engine.Curve;
    }

    private static void Add(GridPoint[] path, OffsetCurve curve, RegionEngine engine)
    {
        if (path.Length == 0) return;
        curve.Build(path.Length == 1 ? ThereAndBack(path) : path);
        engine.Arrangement.Add(curve.Points, 0, curve.Count, 0);
    }

    private static GridPoint[] WithoutRepeats(GridPoint[] points, bool closed)
    {
        var n = 0;
        var path = new GridPoint[points.Length];
        foreach (var p in points)
        {
            if (n == 0 || p != path[n - 1]) path[n++] = p;
        }
        while (closed && n > 1 && path[n - 1] == path[0]) n--;
        Array.Resize(ref path, n);
        return path;
    }

    // A line as a closed path without area that runs along it on both sides. A lone point becomes the shortest line.
    private static GridPoint[] ThereAndBack(GridPoint[] points)
    {
        if (points.Length == 0) return points;
        if (points.Length == 1) return new[] { points[0], new GridPoint(points[0].X + 1, points[0].Y) };
        var last = points.Length - 1;
        var path = new GridPoint[2 * last];
        for (var i = 0; i < last; i++)
        {
            path[i] = points[i];
            path[last + i] = points[last - i];
        }
        return path;
    }

    private static double Reach(in GridBox box)
        => Math.Max(Math.Max(-(double)box.MinX, box.MaxX), Math.Max(-(double)box.MinY, box.MaxY));
}

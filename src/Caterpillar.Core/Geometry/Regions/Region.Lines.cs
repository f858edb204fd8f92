using System;
using System.Collections.Generic;

namespace Caterpillar.Geometry;

/// <summary>A piece of a hatch line.</summary>
/// <param name="Row">Number of the line: its distance from the origin is phase + row · spacing.</param>
/// <param name="From">Start in mm, at Z 0.</param>
/// <param name="To">End in mm, in the direction of the hatch.</param>
public readonly record struct HatchLine(int Row, Vec3 From, Vec3 To);

public sealed partial class Region
{
    /// <summary>
    /// The parts of lines inside the region (or, with <paramref name="outside"/>, outside it). The boundary is inside. Original points and Z stay; new
    /// points are placed on the boundary, with Z interpolated. A closed polyline that is not cut stays closed; cut ones are open.
    /// </summary>
    /// <exception cref="ArgumentException">A coordinate is not a number or beyond ±5368.709 mm.</exception>
    public IReadOnlyList<Polyline> ClipLines(IEnumerable<Polyline> lines, bool outside = false)
    {
        if (lines is null) throw new ArgumentNullException(nameof(lines));
        var clipper = new LineClipper(Index, outside);
        foreach (var line in lines)
        {
            if (line is null) throw new ArgumentException("A line is missing.", nameof(lines));
            foreach (var p in line.Raw) Grid.FromMm(p, nameof(lines));
            clipper.Clip(line);
        }
        return clipper.Pieces;
    }

    /// <summary>
    /// The parts inside the region of parallel lines, sorted by row and along the row. A line that runs along a boundary follows the half-open rule: it
    /// is inside if the region lies on its left.
    /// </summary>
    /// <param name="angle">Direction of the lines, degrees counterclockwise from +X.</param>
    /// <param name="spacing">Distance of the lines in mm, positive.</param>
    /// <param name="phase">Distance of row 0 from the origin in mm, positive to the left of the direction.</param>
    /// <exception cref="ArgumentException">A parameter is not a number, the spacing is not positive, or there would be more than 10 million rows.</exception>
    public IReadOnlyList<HatchLine> HatchLines(double angle, double spacing, double phase = 0) => HatchScanner.Scan(_paths, angle, spacing, phase);

    /// <summary>
    /// Fewer vertices: contours are replaced by chords that stay within a tolerance (mm) of the dropped vertices, found in one pass by sleeve fitting (Zhao
    /// and Saalfeld 1997). Resulting crossings are resolved; parts smaller than the tolerance vanish.
    /// </summary>
    /// <exception cref="ArgumentException">The tolerance is negative or not a number.</exception>
    public Region Simplified(double tolerance) => Simplified(tolerance, new RegionEngine());

    internal Region Simplified(double tolerance, RegionEngine engine)
    {
        if (!(tolerance >= 0)) throw new ArgumentException("The tolerance must not be negative.", nameof(tolerance));
        if (IsEmpty || tolerance == 0) return this;
        var simplifier = engine.Simplifier;
        engine.Clear();
        foreach (var path in _paths)
        {
            simplifier.Simplify(path, tolerance * Grid.PerMm);
            engine.Arrangement.Add(simplifier.Points, 0, simplifier.Count, 0);
        }
        return Own(engine.Run(InsideRule.Positive));
    }

    /// <summary>
    /// The connected pieces: for each the outer contour first, then its holes; in the order of the outers. An island within a hole is a piece of its own.
    /// </summary>
    public IReadOnlyList<Region> Islands => _islands ?? System.Threading.Interlocked.CompareExchange(ref _islands, IslandFinder.Split(this), null) ?? _islands!;
}

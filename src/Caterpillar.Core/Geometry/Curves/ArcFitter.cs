namespace Caterpillar.Geometry;

/// <summary>
/// Finds arcs in the XY plane, flat or helical, that replace runs of straight segments. An arc starts and ends at vertices; its center is the least-squares one
/// on the perpendicular bisector of the two; the deviation is tested at all vertices and at the midpoints of all chords, so that a corner is never rounded
/// beyond the tolerance. Runs grow greedily.
/// </summary>
/// <param name="points">The vertices.</param>
/// <param name="tolerance">Maximum distance in mm between an arc and the vertices and chord midpoints that it replaces, also normal to the plane.</param>
/// <exception cref="ArgumentException">The tolerance is not positive and finite.</exception>
internal sealed class ArcFitter(IReadOnlyList<Vec3> points, double tolerance = 0.02)
{
    private const int MinSegments = 3;

    // mm: flatter runs stay straight.
    private const double MaxRadius = 2000;

    // Firmware may read a nearly full turn as 0.
    private const double MaxSweep = 330;

    private readonly IReadOnlyList<Vec3> _points = points ?? throw new ArgumentNullException(nameof(points));
    private readonly double _tolerance = tolerance > 0 && !double.IsInfinity(tolerance) ? tolerance
        : throw new ArgumentException("The tolerance of an arc must be positive.", nameof(tolerance));

    /// <summary>
    /// The longest arc found that starts at vertex <paramref name="start"/> and ends at or before vertex <paramref name="last"/>: the vertex it ends at, and
    /// the arc. Null if there is none.
    /// </summary>
    public (int End, Arc Arc)? From(int start, int last)
    {
        if (start + MinSegments > last) return null;
        var first = start + MinSegments;
        if (Try(start, first) is not { } best) return null;
        // Most runs are short, long ones are found in doubling steps; the accepted run has always been tested completely.
        var good = first;
        var step = 1;
        while (good < last)
        {
            var next = Math.Min(good + step, last);
            if (Try(start, next) is { } longer)
            {
                (good, best) = (next, longer);
                step *= 2;
            }
            else if (step == 1)
            {
                break;
            }
            else
            {
                step = Math.Max(1, (next - good) / 2);
            }
        }
        return (good, best);
    }

    private Arc? Try(int start, int end)
    {
        var a = _points[start];
        var b = _points[end];
        var middle = new Vec3((a.X + b.X) / 2, (a.Y + b.Y) / 2);
        var (dx, dy) = (b.X - a.X, b.Y - a.Y);
        var chord = Math.Sqrt(dx * dx + dy * dy);
        if (!(chord > _tolerance)) return null;
        var (nx, ny) = (-dy / chord, dx / chord);
        var quarter = chord * chord / 4;
        // A point at offset d from the chord is on the circle with center middle + h·n when |p − middle|² − (chord/2)² = 2 h d.
        double top = 0, bottom = 0;
        for (var i = start + 1; i < end; i++)
        {
            var (px, py) = (_points[i].X - middle.X, _points[i].Y - middle.Y);
            var d = px * nx + py * ny;
            top += (px * px + py * py - quarter) * d;
            bottom += d * d;
        }
        if (!(bottom > 0)) return null;
        var h = top / (2 * bottom);
        var radius = Math.Sqrt(h * h + quarter);
        if (!(radius <= MaxRadius)) return null;
        var center = new Vec3(middle.X + h * nx, middle.Y + h * ny);
        return Fits(start, end, center, radius) is { } sweep ? new Arc(center, sweep) : null;
    }

    // The sweep in degrees if everything between two vertices stays within the tolerance.
    private double? Fits(int start, int end, Vec3 center, double radius)
    {
        var sweep = 0.0;
        for (var i = start; i < end; i++)
        {
            var (px, py) = (_points[i].X - center.X, _points[i].Y - center.Y);
            var (qx, qy) = (_points[i + 1].X - center.X, _points[i + 1].Y - center.Y);
            if (Math.Abs(Math.Sqrt(qx * qx + qy * qy) - radius) > _tolerance) return null;
            var (mx, my) = ((px + qx) / 2, (py + qy) / 2);
            if (Math.Abs(Math.Sqrt(mx * mx + my * my) - radius) > _tolerance) return null;
            var turn = Angle.Atan2(px * qy - py * qx, px * qx + py * qy);
            if (turn == 0 || (i > start && turn > 0 != sweep > 0)) return null;
            sweep += turn;
            if (Math.Abs(sweep) > MaxSweep) return null;
        }
        // Across the plane the height changes linearly with the angle.
        var (low, rise) = (_points[start].Z, _points[end].Z - _points[start].Z);
        var turned = 0.0;
        for (var i = start; i < end - 1; i++)
        {
            var z = _points[i + 1].Z;
            if (rise == 0 && z == low) continue;
            var (px, py) = (_points[i].X - center.X, _points[i].Y - center.Y);
            var (qx, qy) = (_points[i + 1].X - center.X, _points[i + 1].Y - center.Y);
            turned += Angle.Atan2(px * qy - py * qx, px * qx + py * qy);
            if (Math.Abs(low + rise * (turned / sweep) - z) > _tolerance) return null;
        }
        return sweep;
    }
}

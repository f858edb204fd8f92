namespace Caterpillar.Toolpaths;

/// <summary>
/// Finds the minimum of a function while a tip moves from a to b past a higher extrusion: the distance seen from above, minus a slope times the height of the
/// extrusion above the tip, where this height is in some range. The function is convex, so its minimum is at their crossing or at the border of the range.
/// </summary>
internal struct SlopePass
{
    // The difference of the two at their starts, and how it changes along the path of the tip (s) and along the extrusion (t), each from 0 to 1.
    private readonly double _px, _py, _pz, _sx, _sy, _sz, _tx, _ty, _tz, _slope;

    public SlopePass(in Extrusion extrusion, Vec3 a, Vec3 b, double tolerance, double slope, double lowest, double highest)
    {
        (_px, _py, _pz) = (extrusion.Ax - a.X, extrusion.Ay - a.Y, extrusion.Az - a.Z - tolerance);
        (_sx, _sy, _sz) = (a.X - b.X, a.Y - b.Y, a.Z - b.Z);
        (_tx, _ty, _tz) = (extrusion.Bx - extrusion.Ax, extrusion.By - extrusion.Ay, extrusion.Bz - extrusion.Az);
        _slope = slope;
        Least = double.PositiveInfinity;
        Cross(lowest, highest);
        Search(lowest, highest);
    }

    /// <summary>The minimum, mm. Infinite if the height is nowhere in the range.</summary>
    public double Least { get; private set; }

    // The border: the parts of the sides that are in the range, and between them the lines on which the height is lowest and highest.
    private void Search(double lowest, double highest)
    {
        (double S, double T)? begin = null;
        (double S, double T) end = default;
        double s = 0, t = 0, excess = _pz;
        for (var corner = 1; corner <= 4; corner++)
        {
            double nextS = corner is 1 or 2 ? 1 : 0, nextT = corner is 2 or 3 ? 1 : 0;
            var next = _pz + _sz * nextS + _tz * nextT;
            double from = 0, to = 1;
            if (FlatSegment.Slab(excess, next - excess, lowest, highest, ref from, ref to))
            {
                (double S, double T) first = (s + (nextS - s) * from, t + (nextT - t) * from);
                if (begin is null) begin = first;
                else if (end != first) Edge(end, first);
                end = (s + (nextS - s) * to, t + (nextT - t) * to);
                Edge(first, end);
            }
            (s, t, excess) = (nextS, nextT, next);
        }
        if (begin is { } closed && end != closed) Edge(end, closed);
    }

    private void Cross(double lowest, double highest)
    {
        var turn = _sx * _ty - _sy * _tx;
        if (turn == 0) return;
        double s = (_tx * _py - _ty * _px) / turn, t = (_sy * _px - _sx * _py) / turn;
        if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) return;
        var excess = _pz + _sz * s + _tz * t;
        if (excess >= lowest && excess <= highest) Least = -_slope * excess;
    }

    private void Edge((double S, double T) from, (double S, double T) to)
    {
        double ds = to.S - from.S, dt = to.T - from.T;
        double px = _px + _sx * from.S + _tx * from.T, py = _py + _sy * from.S + _ty * from.T, pz = _pz + _sz * from.S + _tz * from.T;
        double dx = _sx * ds + _tx * dt, dy = _sy * ds + _ty * dt, dz = _sz * ds + _tz * dt;
        double square = dx * dx + dy * dy, gain = _slope * dz, steep = square - gain * gain;
        double at = gain > 0 ? 1 : 0;
        if (steep > 0)
        {
            // Where the distance grows as fast as what the height gains.
            double foot = -(px * dx + py * dy) / square, fx = px + dx * foot, fy = py + dy * foot;
            at = Math.Min(1, Math.Max(0, foot + gain * Math.Sqrt((fx * fx + fy * fy) / (square * steep))));
        }
        px += dx * at;
        py += dy * at;
        Least = Math.Min(Least, Math.Sqrt(px * px + py * py) - _slope * (pz + dz * at));
    }
}

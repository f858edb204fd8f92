namespace Caterpillar.Toolpaths;

/// <summary>
/// Finds the minimum of a function while a tip moves from a to b past a higher extrusion: the distance seen from above, minus a slope times the height of the
/// extrusion above the tip. The function is convex, so its minimum is at their crossing or at the border of the part where the extrusion is higher.
/// </summary>
internal struct SlopePass
{
    // The difference of the two at their starts, and how it changes along the path of the tip (s) and along the extrusion (t), each from 0 to 1.
    private readonly double _px, _py, _pz, _sx, _sy, _sz, _tx, _ty, _tz, _slope;

    public SlopePass(in Extrusion extrusion, Vec3 a, Vec3 b, double tolerance, double slope)
    {
        (_px, _py, _pz) = (extrusion.Ax - a.X, extrusion.Ay - a.Y, extrusion.Az - a.Z - tolerance);
        (_sx, _sy, _sz) = (a.X - b.X, a.Y - b.Y, a.Z - b.Z);
        (_tx, _ty, _tz) = (extrusion.Bx - extrusion.Ax, extrusion.By - extrusion.Ay, extrusion.Bz - extrusion.Az);
        _slope = slope;
        (Least, Distance, Excess) = (double.PositiveInfinity, 0, 0);
        Search();
    }

    /// <summary>The minimum, mm. Infinite if the extrusion is nowhere higher.</summary>
    public double Least { get; private set; }

    /// <summary>The distance there, mm.</summary>
    public double Distance { get; private set; }

    /// <summary>The height above the tip there, mm.</summary>
    public double Excess { get; private set; }

    private void Search()
    {
        Cross();
        // The border, and the line on which both are equally high.
        var (levels, ls, lt) = (0, 0.0, 0.0);
        double s = 0, t = 0, excess = _pz;
        for (var corner = 1; corner <= 4; corner++)
        {
            double nextS = corner is 1 or 2 ? 1 : 0, nextT = corner is 2 or 3 ? 1 : 0;
            var next = _pz + _sz * nextS + _tz * nextT;
            if (excess >= 0 && next >= 0)
            {
                Edge(s, t, nextS, nextT);
            }
            else if (excess >= 0 || next >= 0)
            {
                var at = excess / (excess - next);
                double ms = s + (nextS - s) * at, mt = t + (nextT - t) * at;
                if (excess >= 0) Edge(s, t, ms, mt);
                else Edge(ms, mt, nextS, nextT);
                if (levels++ == 0) (ls, lt) = (ms, mt);
                else Edge(ls, lt, ms, mt);
            }
            (s, t, excess) = (nextS, nextT, next);
        }
    }

    private void Cross()
    {
        var turn = _sx * _ty - _sy * _tx;
        if (turn == 0) return;
        double s = (_tx * _py - _ty * _px) / turn, t = (_sy * _px - _sx * _py) / turn;
        if (!(s >= 0 && s <= 1 && t >= 0 && t <= 1)) return;
        var excess = _pz + _sz * s + _tz * t;
        if (excess >= 0) Offer(0, excess);
    }

    private void Edge(double s0, double t0, double s1, double t1)
    {
        double ds = s1 - s0, dt = t1 - t0;
        double px = _px + _sx * s0 + _tx * t0, py = _py + _sy * s0 + _ty * t0, pz = _pz + _sz * s0 + _tz * t0;
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
        Offer(Math.Sqrt(px * px + py * py), pz + dz * at);
    }

    private void Offer(double distance, double excess)
    {
        var value = distance - _slope * excess;
        if (value < Least) (Least, Distance, Excess) = (value, distance, excess);
    }
}

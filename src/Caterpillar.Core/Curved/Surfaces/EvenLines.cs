namespace Caterpillar.Curved;

/// <summary>
/// Lines through a direction field at even distances (Jobard and Lefer, 1997): each new one begins beside those that are there, and ends where it comes too
/// near to them. One thread.
/// </summary>
internal sealed class EvenLines(PlanSurface surface, Bounds plan, Func<Vec3, Vec3> direction, double spacing)
{
    // Lines end where others are nearer than this share of their distance.
    private const double Nearest = 0.5;

    private readonly double _step = Math.Min(spacing / 4, 1);
    private readonly Dictionary<(int, int), List<Vec3>> _cells = [];
    private readonly List<Polyline> _lines = [];

    public IReadOnlyList<Polyline> Trace(CancellationToken cancel)
    {
        var shortest = 2 * spacing;
        Add(Through(plan.Center, 0), 0);
        for (var i = 0; i < _lines.Count; i++)
        {
            cancel.ThrowIfCancellationRequested();
            foreach (var p in _lines[i].Points)
            {
                foreach (var side in new[] { -1, 1 }) Try(Beside(p, side));
            }
        }
        // Places that no line is near to.
        for (var y = plan.Min.Y + spacing / 2; y < plan.Max.Y; y += spacing)
        {
            for (var x = plan.Min.X + spacing / 2; x < plan.Max.X; x += spacing) Try(On(new Vec3(x, y)));
            cancel.ThrowIfCancellationRequested();
        }
        return _lines;

        void Try(Vec3 seed)
        {
            if (seed.IsFinite && !IsNear(seed, 0.95 * spacing)) Add(Through(seed, Nearest * spacing), shortest);
        }
    }

    private Vec3 On(Vec3 p) => p.WithZ(surface.Height(p.X, p.Y));

    // A spacing away at right angles to the direction, along the surface.
    private Vec3 Beside(Vec3 p, int side)
    {
        var d = Direction(p, Vec3.Zero);
        if (d == Vec3.Zero) return new Vec3(double.NaN, double.NaN);
        var normal = Normal(p);
        var across = Vec3.Cross(normal, Along(p, d)).Unit();
        return On(p + across * (side * spacing));
    }

    private Vec3 Normal(Vec3 p)
    {
        const double H = 0.05;
        return new Vec3(surface.Height(p.X - H, p.Y) - surface.Height(p.X + H, p.Y), surface.Height(p.X, p.Y - H) - surface.Height(p.X, p.Y + H), 2 * H).Unit();
    }

    // The direction on the surface, of length 1.
    private Vec3 Along(Vec3 p, Vec3 d)
    {
        const double H = 0.05;
        return (d * (2 * H)).WithZ(surface.Height(p.X + d.X * H, p.Y + d.Y * H) - surface.Height(p.X - d.X * H, p.Y - d.Y * H)).Unit();
    }

    private Vec3 Direction(Vec3 p, Vec3 before)
    {
        var d = direction(p).WithZ(0);
        if (!d.IsFinite || d == Vec3.Zero) return Vec3.Zero;
        d = d.Unit();
        return Vec3.Dot(d, before) < 0 ? -d : d;
    }

    private List<Vec3> Through(Vec3 seed, double nearest)
    {
        var start = On(seed);
        var line = new List<Vec3>();
        Follow(start, -1, nearest, line);
        line.Reverse();
        if (Inside(start)) line.Add(start);
        Follow(start, 1, nearest, line);
        return line;
    }

    private void Follow(Vec3 from, int sign, double nearest, List<Vec3> line)
    {
        var first = line.Count;
        var p = from;
        var d = Direction(p, Vec3.Zero) * sign;
        for (var i = 0; i < 100_000 && d != Vec3.Zero; i++)
        {
            // The middle of the step decides (second order).
            var half = Direction(p + Along(p, d).WithZ(0) * (_step / 2), d);
            if (half == Vec3.Zero || Vec3.Dot(half, d) < 0.5) return;
            var next = On(p + Along(p, half).WithZ(0) * _step);
            if (!next.IsFinite || !Inside(next) || (nearest > 0 && IsNear(next, nearest))) return;
            // Round and back to itself.
            if (i > 8 && next.DistanceTo(from) < _step) return;
            line.Add(next);
            if (Circles(line, first, next)) return;
            d = Direction(next, half);
            if (Vec3.Dot(d, half) < 0.5) return;
            p = next;
        }
    }

    private bool Circles(List<Vec3> line, int first, Vec3 p)
    {
        var recent = (int)(3 * spacing / _step);
        for (var i = first; i < line.Count - recent; i += 2)
        {
            if (line[i].DistanceTo(p) < Nearest * spacing) return true;
        }
        return false;
    }

    private bool Inside(Vec3 p) => p.X >= plan.Min.X && p.X <= plan.Max.X && p.Y >= plan.Min.Y && p.Y <= plan.Max.Y && surface.Covers(p.X, p.Y);

    private void Add(List<Vec3> line, double shortest)
    {
        if (line.Count < 2 || line.Count * _step < shortest) return;
        _lines.Add(new Polyline(line));
        foreach (var p in line)
        {
            var cell = Cell(p);
            if (!_cells.TryGetValue(cell, out var list)) _cells.Add(cell, list = []);
            list.Add(p);
        }
    }

    private (int, int) Cell(Vec3 p) => ((int)Math.Floor(p.X / spacing), (int)Math.Floor(p.Y / spacing));

    private bool IsNear(Vec3 p, double distance)
    {
        var (x, y) = Cell(p);
        for (var i = x - 1; i <= x + 1; i++)
        {
            for (var k = y - 1; k <= y + 1; k++)
            {
                if (!_cells.TryGetValue((i, k), out var list)) continue;
                foreach (var q in list)
                {
                    if ((q - p).LengthSquared < distance * distance) return true;
                }
            }
        }
        return false;
    }
}

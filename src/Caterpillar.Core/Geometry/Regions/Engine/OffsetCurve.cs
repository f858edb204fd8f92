namespace Caterpillar.Geometry;

/// <summary>
/// The raw offset curve of closed paths: every edge moved sideways and joined with the next one. If neighbors overlap and are long enough they are cut at
/// their crossing at once, else the curve goes back through the vertex; the winding numbers are then ≤ 0 exactly where the area has to vanish.
/// </summary>
internal sealed class OffsetCurve
{
    // Degrees of a chord.
    private const double Coarse = 50;

    private readonly OffsetCorners _corners = new();
    private readonly Func<double, double, double> _extension;
    private double _d;
    private JoinStyle _join;
    private double _miterDot;
    private double _arcDot;
    private double _step;
    private int _arcSteps;

    public OffsetCurve() => _extension = Extension;

    /// <summary>How far, in grid units, the curve may be from the path.</summary>
    public double Reach { get; private set; }

    public GridPoint[] Points = [];

    public int Count { get; private set; }

    /// <summary>Parameters of the next curves: a distance, a miter limit (in distances) and an arc tolerance in grid units.</summary>
    public void Set(double distance, JoinStyle join, double miterLimit, double arcTolerance)
    {
        _d = distance;
        _join = join;
        var size = Math.Abs(distance);
        // The miter's length is d / cos(turn / 2), and the dot product of the normals is cos(turn).
        _miterDot = 2 / (miterLimit * miterLimit) - 1;
        var overshoot = 1 + arcTolerance / size;
        _arcDot = 2 / (overshoot * overshoot) - 1;
        // At least a square of chords, at most 720.
        _step = Math.Min(Math.Max(2 * Angle.ToDegrees(Math.Acos(Math.Max(0.0, 1 - arcTolerance / size))), 0.5), 90);
        _arcSteps = (int)(180 / _step) + 1;
        Reach = size * (join == JoinStyle.Miter ? Math.Max(miterLimit, 1.4143) : 1.4143) + 2;
    }

    /// <summary>Builds the curve of a path without equal consecutive points, into <see cref="Points"/>.</summary>
    public void Build(GridPoint[] path)
    {
        var n = path.Length;
        Count = 0;
        _corners.Compute(path, _d, _extension);
        for (var i = 0; i < n; i++)
        {
            if (!_corners.Dropped(i)) Corner(path[i], _corners.Previous(i), i);
        }
    }

    private bool Pointed(double dot) => dot > 0.9999 || dot >= (_join == JoinStyle.Miter ? _miterDot : _join == JoinStyle.Round ? _arcDot : 2);

    // By how much a join extends both moved edges.
    private double Extension(double cross, double dot)
    {
        if (Pointed(dot)) return Math.Abs(_d * cross) / (1 + dot);
        return _join == JoinStyle.Round ? 0 : SquareExtension(dot);
    }

    // d tan(turn / 4): up to the line at distance d across the bisector.
    private double SquareExtension(double dot)
        => Math.Abs(_d) * (1 - Math.Sqrt(Math.Max(0.0, (1 + dot) / 2))) / Math.Sqrt(Math.Max(0.0, (1 - dot) / 2));

    private void Corner(GridPoint v, int before, int i)
    {
        Buffers.Reserve(ref Points, Count + _arcSteps + 4);
        double mx = _corners.Nx[before], my = _corners.Ny[before], nx = _corners.Nx[i], ny = _corners.Ny[i];
        var kind = _corners.Kind[i];
        var dot = mx * nx + my * ny;
        if (kind == 3)
        {
            Put(v, mx * _d, my * _d);
            Points[Count++] = v;
            Put(v, nx * _d, ny * _d);
        }
        else if (kind == 2)
        {
            var (x, y) = _corners.Crossing(i);
            Put(v, x, y);
        }
        else if (kind == 1 || Pointed(dot))
        {
            var scale = _d / (1 + dot);
            Put(v, (mx + nx) * scale, (my + ny) * scale);
        }
        else if (_join == JoinStyle.Round)
        {
            Arc(v, mx, my, nx, ny);
        }
        else
        {
            var t = SquareExtension(dot);
            Put(v, mx * _d - my * t, my * _d + mx * t);
            Put(v, nx * _d + ny * t, ny * _d - nx * t);
        }
    }

    private void Arc(GridPoint v, double mx, double my, double nx, double ny)
    {
        var turn = Angle.ToDegrees(Math.Acos(Math.Max(mx * nx + my * ny, -1)));
        var chords = Math.Ceiling(turn / _step - 1e-9);
        // Coarse chords are of one length, so that none is a stub.
        var angle = _step > Coarse ? turn / chords : _step;
        var (sin, cos) = Angle.SinCos(_d > 0 ? angle : -angle);
        Put(v, mx * _d, my * _d);
        for (var k = 1; k < chords; k++)
        {
            (mx, my) = (mx * cos - my * sin, my * cos + mx * sin);
            Put(v, mx * _d, my * _d);
        }
        Put(v, nx * _d, ny * _d);
    }

    private void Put(GridPoint v, double dx, double dy) => Points[Count++] = new GridPoint(Grid.Round(v.X + dx), Grid.Round(v.Y + dy));
}

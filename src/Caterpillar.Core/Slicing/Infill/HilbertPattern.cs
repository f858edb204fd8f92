namespace Caterpillar.Slicing;

/// <summary>
/// Hilbert's curve (1891) through cells of the spacing. It is one curve over the whole bed, of which only the squares near the area are entered, so it does not
/// change from layer to layer.
/// </summary>
internal static class HilbertPattern
{
    public static List<Polyline> Curve(InfillRequest request)
    {
        var frame = new PatternFrame(request.Area, request.Angle);
        // Even, so that curves of all orders lie alike; from the corner of the whole, in cells.
        var order = 2;
        while (Math.Pow(2, order - 1) * request.Spacing < 2 * Grid.LimitMm) order += 2;
        var origin = -Math.Pow(2, order - 1) * request.Spacing;
        var walk = new Walk(frame, request.Spacing, origin);
        walk.Square(0, 0, 1L << order, 0, 1, 1, 0);
        walk.Flush();
        return walk.Pieces;
    }

    private sealed class Walk(PatternFrame frame, double cell, double origin)
    {
        private readonly List<Vec3> _points = [];
        private long _lastX = long.MinValue;
        private long _lastY;

        public List<Polyline> Pieces { get; } = [];

        // The square of a size at (x, y), entered at that corner: a is the direction to its second quarter, b the one to its fourth.
        public void Square(long x, long y, long size, int ax, int ay, int bx, int by)
        {
            // (x, y) is the cell of entry; the square extends along a and b.
            long ex = x + (ax + bx) * (size - 1), ey = y + (ay + by) * (size - 1);
            double low = Math.Min(x, ex) * cell + origin, high = (Math.Max(x, ex) + 1) * cell + origin;
            if (high < frame.MinU - cell || low > frame.MaxU + cell) return;
            low = Math.Min(y, ey) * cell + origin;
            high = (Math.Max(y, ey) + 1) * cell + origin;
            if (high < frame.MinV - cell || low > frame.MaxV + cell) return;
            if (size == 1)
            {
                Visit(x, y);
                return;
            }
            var half = size / 2;
            var far = size - 1;
            Square(x, y, half, bx, by, ax, ay);
            Square(x + ax * half, y + ay * half, half, ax, ay, bx, by);
            Square(x + ax * half + bx * half, y + ay * half + by * half, half, ax, ay, bx, by);
            Square(x + bx * far + ax * (half - 1), y + by * far + ay * (half - 1), half, -bx, -by, -ax, -ay);
        }

        public void Flush()
        {
            if (_points.Count > 1) Pieces.Add(Polyline.Own(_points.ToArray(), closed: false));
            _points.Clear();
        }

        private void Visit(long x, long y)
        {
            if (Math.Abs(x - _lastX) + Math.Abs(y - _lastY) != 1) Flush();
            (_lastX, _lastY) = (x, y);
            var p = frame.At(origin + (x + 0.5) * cell, origin + (y + 0.5) * cell);
            // Straight runs are one segment.
            var n = _points.Count;
            if (n > 1 && Vec3.Cross(_points[n - 1] - _points[n - 2], p - _points[n - 1]).LengthSquared < 1e-12 * cell * cell * cell * cell) _points[n - 1] = p;
            else _points.Add(p);
        }
    }
}

namespace Caterpillar.Planning;

/// <summary>
/// The nearest among points that are removed one by one: a k-d tree (Bentley 1975, 1990) with a count of the remaining points in every node. Among equally near
/// points the one with the lowest number wins, so that the answer does not depend on the shape of the tree.
/// </summary>
internal sealed class EntryTree
{
    private const int LeafSize = 8;
    private readonly Vec3[] _points;
    private readonly int[] _order;
    private readonly bool[] _dead;
    private readonly int[] _nodeOf;
    private readonly int[] _alive;
    private readonly double[] _box;
    private readonly int _leaves;

    public EntryTree(Vec3[] points)
    {
        var count = points.Length;
        _points = points;
        _order = new int[count];
        for (var i = 0; i < count; i++) _order[i] = i;
        _dead = new bool[count];
        _nodeOf = new int[count];
        _leaves = 1;
        while (_leaves * LeafSize < count) _leaves *= 2;
        _alive = new int[2 * _leaves];
        _box = new double[12 * _leaves];
        Build(1, 0, count);
    }

    public void Remove(int point)
    {
        if (_dead[point]) return;
        _dead[point] = true;
        for (var node = _nodeOf[point]; node > 0; node /= 2) _alive[node]--;
    }

    public void Restore(int point)
    {
        if (!_dead[point]) return;
        _dead[point] = false;
        for (var node = _nodeOf[point]; node > 0; node /= 2) _alive[node]++;
    }

    /// <summary>Index of the nearest remaining point, or −1.</summary>
    public int Nearest(Vec3 from)
    {
        if (_alive[1] == 0) return -1;
        var best = -1;
        var bestSquare = double.PositiveInfinity;
        Search(1, 0, _order.Length, from, ref best, ref bestSquare);
        return best;
    }

    private void Search(int node, int first, int end, Vec3 from, ref int best, ref double bestSquare)
    {
        if (node >= _leaves)
        {
            for (var i = first; i < end; i++)
            {
                var point = _order[i];
                if (_dead[point]) continue;
                var square = (_points[point] - from).LengthSquared;
                if (best >= 0 && (square > bestSquare || (square == bestSquare && point > best))) continue;
                best = point;
                bestSquare = square;
            }
            return;
        }
        var middle = first + (end - first) / 2;
        var left = node * 2;
        var toLeft = _alive[left] > 0 ? SquareTo(left, from) : double.PositiveInfinity;
        var toRight = _alive[left + 1] > 0 ? SquareTo(left + 1, from) : double.PositiveInfinity;
        if (toLeft <= toRight)
        {
            if (_alive[left] > 0 && toLeft <= bestSquare) Search(left, first, middle, from, ref best, ref bestSquare);
            if (_alive[left + 1] > 0 && toRight <= bestSquare) Search(left + 1, middle, end, from, ref best, ref bestSquare);
        }
        else
        {
            if (_alive[left + 1] > 0 && toRight <= bestSquare) Search(left + 1, middle, end, from, ref best, ref bestSquare);
            if (_alive[left] > 0 && toLeft <= bestSquare) Search(left, first, middle, from, ref best, ref bestSquare);
        }
    }

    private double SquareTo(int node, Vec3 p)
    {
        var at = node * 6;
        var x = Math.Max(Math.Max(_box[at] - p.X, p.X - _box[at + 3]), 0);
        var y = Math.Max(Math.Max(_box[at + 1] - p.Y, p.Y - _box[at + 4]), 0);
        var z = Math.Max(Math.Max(_box[at + 2] - p.Z, p.Z - _box[at + 5]), 0);
        return x * x + y * y + z * z;
    }

    private void Build(int node, int first, int end)
    {
        double x0 = double.PositiveInfinity, y0 = x0, z0 = x0, x1 = double.NegativeInfinity, y1 = x1, z1 = x1;
        for (var i = first; i < end; i++)
        {
            var p = _points[_order[i]];
            x0 = Math.Min(x0, p.X);
            y0 = Math.Min(y0, p.Y);
            z0 = Math.Min(z0, p.Z);
            x1 = Math.Max(x1, p.X);
            y1 = Math.Max(y1, p.Y);
            z1 = Math.Max(z1, p.Z);
        }
        var at = node * 6;
        _box[at] = x0;
        _box[at + 1] = y0;
        _box[at + 2] = z0;
        _box[at + 3] = x1;
        _box[at + 4] = y1;
        _box[at + 5] = z1;
        _alive[node] = end - first;
        if (node >= _leaves)
        {
            for (var i = first; i < end; i++) _nodeOf[_order[i]] = node;
            return;
        }
        var middle = first + (end - first) / 2;
        if (end - first > 1) Split(first, end, middle, x1 - x0 >= y1 - y0 ? (x1 - x0 >= z1 - z0 ? 0 : 2) : (y1 - y0 >= z1 - z0 ? 1 : 2));
        Build(node * 2, first, middle);
        Build(node * 2 + 1, middle, end);
    }

    // Quickselect: afterwards no point before the middle is greater than one after it, along the axis and then by number.
    private void Split(int first, int end, int middle, int axis)
    {
        int low = first, high = end - 1;
        while (low < high)
        {
            var pivot = _order[low + (high - low) / 2];
            int i = low, j = high;
            while (i <= j)
            {
                while (Before(_order[i], pivot, axis)) i++;
                while (Before(pivot, _order[j], axis)) j--;
                if (i > j) break;
                (_order[i], _order[j]) = (_order[j], _order[i]);
                i++;
                j--;
            }
            if (middle <= j) high = j;
            else if (middle >= i) low = i;
            else return;
        }
    }

    private bool Before(int a, int b, int axis)
    {
        var p = _points[a];
        var q = _points[b];
        var (u, v) = axis == 0 ? (p.X, q.X) : axis == 1 ? (p.Y, q.Y) : (p.Z, q.Z);
        return u < v || (u == v && a < b);
    }
}

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
    private readonly double[] _along;
    private readonly bool[] _dead;
    private readonly int[] _nodeOf;
    private readonly int[] _alive;
    private readonly GrowingBox[] _boxes;
    private readonly int _leaves;

    public EntryTree(Vec3[] points)
    {
        var count = points.Length;
        _points = points;
        _order = [.. Enumerable.Range(0, count)];
        _along = new double[count];
        _dead = new bool[count];
        _nodeOf = new int[count];
        _leaves = 1;
        while (_leaves * LeafSize < count) _leaves *= 2;
        _alive = new int[2 * _leaves];
        _boxes = new GrowingBox[2 * _leaves];
        Build(1, 0, count);
    }

    public void Remove(int point) => Set(point, dead: true);

    public void Restore(int point) => Set(point, dead: false);

    /// <summary>Index of the nearest remaining point, or −1.</summary>
    public int Nearest(Vec3 from)
    {
        var best = -1;
        var bestSquare = double.PositiveInfinity;
        Search(1, 0, _order.Length, from, ref best, ref bestSquare);
        return best;
    }

    private void Set(int point, bool dead)
    {
        if (_dead[point] == dead) return;
        _dead[point] = dead;
        for (var node = _nodeOf[point]; node > 0; node /= 2) _alive[node] += dead ? -1 : 1;
    }

    private void Search(int node, int first, int end, Vec3 from, ref int best, ref double bestSquare)
    {
        if (_alive[node] == 0 || SquareTo(node, from) > bestSquare) return;
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
        var isLeftNearer = SquareTo(left, from) <= SquareTo(left + 1, from);
        if (isLeftNearer) Search(left, first, middle, from, ref best, ref bestSquare);
        Search(left + 1, middle, end, from, ref best, ref bestSquare);
        if (!isLeftNearer) Search(left, first, middle, from, ref best, ref bestSquare);
    }

    private double SquareTo(int node, Vec3 p)
    {
        var box = _boxes[node];
        var x = Math.Max(Math.Max(box.MinX - p.X, p.X - box.MaxX), 0);
        var y = Math.Max(Math.Max(box.MinY - p.Y, p.Y - box.MaxY), 0);
        var z = Math.Max(Math.Max(box.MinZ - p.Z, p.Z - box.MaxZ), 0);
        return x * x + y * y + z * z;
    }

    private void Build(int node, int first, int end)
    {
        var box = _boxes[node] = new GrowingBox();
        for (var i = first; i < end; i++) box.Include(_points[_order[i]]);
        _alive[node] = end - first;
        if (node >= _leaves)
        {
            for (var i = first; i < end; i++) _nodeOf[_order[i]] = node;
            return;
        }
        // Halves along the longest side.
        double x = box.MaxX - box.MinX, y = box.MaxY - box.MinY, z = box.MaxZ - box.MinZ;
        for (var i = first; i < end; i++)
        {
            var p = _points[_order[i]];
            _along[i] = x >= y && x >= z ? p.X : y >= z ? p.Y : p.Z;
        }
        Array.Sort(_along, _order, first, end - first);
        var middle = first + (end - first) / 2;
        Build(node * 2, first, middle);
        Build(node * 2 + 1, middle, end);
    }
}

namespace Caterpillar.Slicing;

/// <summary>Numbered places in square cells, to find the nearest.</summary>
/// <param name="size">Width of a cell, mm.</param>
internal sealed class NodeCells(double size)
{
    private readonly Dictionary<(int X, int Y), List<int>> _cells = [];
    private int _minX = int.MaxValue;
    private int _minY = int.MaxValue;
    private int _maxX = int.MinValue;
    private int _maxY = int.MinValue;

    public void Add(Vec3 place, int number)
    {
        var key = Key(place);
        if (!_cells.TryGetValue(key, out var list)) _cells.Add(key, list = []);
        list.Add(number);
        _minX = Math.Min(_minX, key.X);
        _minY = Math.Min(_minY, key.Y);
        _maxX = Math.Max(_maxX, key.X);
        _maxY = Math.Max(_maxY, key.Y);
    }

    /// <summary>The nearest place within a limit and its distance in mm, or −1 and the limit. Of equals, the first.</summary>
    public int Nearest(Vec3 place, IReadOnlyList<Vec3> places, double limit, out double distance)
    {
        var best = -1;
        distance = limit;
        if (_cells.Count == 0) return best;
        var (x, y) = Key(place);
        // Rings of cells; what is in ring k is at least k − 1 cells away.
        var last = Math.Max(Math.Max(Math.Abs(x - _minX), Math.Abs(x - _maxX)), Math.Max(Math.Abs(y - _minY), Math.Abs(y - _maxY)));
        for (var ring = 0; ring <= last && (ring - 1) * size < distance; ring++)
        {
            for (var dy = -ring; dy <= ring; dy++)
            {
                // Whole rows at the top and the bottom of the ring, else its two sides.
                var stride = Math.Abs(dy) == ring || ring == 0 ? 1 : 2 * ring;
                for (var dx = -ring; dx <= ring; dx += stride)
                {
                    if (!_cells.TryGetValue((x + dx, y + dy), out var list)) continue;
                    foreach (var i in list)
                    {
                        var d = places[i].DistanceTo(place);
                        if (d > distance || (d == distance && best >= 0 && i > best)) continue;
                        (best, distance) = (i, d);
                    }
                }
            }
        }
        return best;
    }

    private (int X, int Y) Key(Vec3 p) => ((int)Math.Floor(p.X / size), (int)Math.Floor(p.Y / size));
}

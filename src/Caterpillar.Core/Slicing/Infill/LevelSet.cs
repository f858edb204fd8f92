namespace Caterpillar.Slicing;

/// <summary>
/// Lines where a formula is zero, by marching squares: crossings of the grid are found exactly, chords are halved until the curve lies within the tolerance of
/// them, and points that straight lines do not need are left away. Keeps its arrays for the next layer.
/// </summary>
internal sealed class LevelSet
{
    private const int Untouched = -1;

    private readonly LevelGrid _grid = new();
    private readonly List<Vec3> _places = [];
    private readonly List<int> _first = [];
    private readonly List<int> _second = [];
    private readonly List<Vec3> _line = [];
    private int[] _edges = [];

    /// <summary>What a formula may use: the place in mm, the number of the layer, spacing and width of the extrusions in mm.</summary>
    public static IReadOnlyList<string> Variables { get; } = ["x", "y", "z", "layer", "spacing", "width"];

    public List<Polyline> Trace(InfillRequest request)
    {
        var field = new LevelField(request);
        _grid.Sample(field, request.Area.Bounds, request.Spacing, request.Width);
        _places.Clear();
        _first.Clear();
        _second.Clear();
        var edges = 2 * _grid.Columns * _grid.Rows;
        if (_edges.Length < edges) _edges = new int[edges];
        for (var i = 0; i < edges; i++) _edges[i] = Untouched;
        for (var j = 0; j + 1 < _grid.Rows; j++)
        {
            for (var i = 0; i + 1 < _grid.Columns; i++) Cell(field, i, j);
        }
        var lines = new List<Polyline>();
        // Open lines from their ends first; what is left are loops.
        for (var i = 0; i < _places.Count; i++)
        {
            if (_first[i] >= 0 != _second[i] >= 0) Follow(field, i, lines);
        }
        for (var i = 0; i < _places.Count; i++)
        {
            if (_first[i] >= 0) Follow(field, i, lines);
        }
        return lines;
    }

    private void Cell(LevelField field, int i, int j)
    {
        var n = j * _grid.Columns + i;
        double a = _grid.Values[n], b = _grid.Values[n + 1], c = _grid.Values[n + _grid.Columns + 1], d = _grid.Values[n + _grid.Columns];
        // The signs of corners counter-clockwise; nothing passes through a cell with a value that is no number.
        int signs = (a < 0 ? 1 : 0) | (b < 0 ? 2 : 0) | (c < 0 ? 4 : 0) | (d < 0 ? 8 : 0);
        if (signs is 0 or 15) return;
        var sum = a + b + c + d;
        if (double.IsNaN(sum) || double.IsInfinity(sum)) return;
        int bottom = 2 * n, top = 2 * (n + _grid.Columns), left = 2 * n + 1, right = 2 * (n + 1) + 1;
        switch (signs)
        {
            case 1 or 14: Connect(bottom, left); break;
            case 2 or 13: Connect(bottom, right); break;
            case 4 or 11: Connect(right, top); break;
            case 8 or 7: Connect(top, left); break;
            case 3 or 12: Connect(left, right); break;
            case 6 or 9: Connect(bottom, top); break;
            default:
                // Two opposite corners: the middle tells which pair hangs together.
                var middle = (_grid.Node(i, j) + _grid.Node(i + 1, j + 1)) / 2;
                if (field.At(middle.X, middle.Y) < 0 == a < 0)
                {
                    Connect(bottom, right);
                    Connect(top, left);
                }
                else
                {
                    Connect(bottom, left);
                    Connect(right, top);
                }
                break;
        }

        void Connect(int e, int f)
        {
            int p = Crossing(field, e), q = Crossing(field, f);
            if (p < 0 || q < 0) return;
            Attach(p, q);
            Attach(q, p);
        }
    }

    private void Attach(int p, int q)
    {
        if (_first[p] < 0) _first[p] = q;
        else _second[p] = q;
    }

    // The number of the crossing of an edge; −2 where the field has a pole.
    private int Crossing(LevelField field, int edge)
    {
        if (_edges[edge] != Untouched) return _edges[edge];
        int n = edge >> 1, column = n % _grid.Columns, row = n / _grid.Columns;
        var upward = (edge & 1) == 1;
        var m = upward ? n + _grid.Columns : n + 1;
        var end = upward ? _grid.Node(column, row + 1) : _grid.Node(column + 1, row);
        if (!field.Zero(_grid.Node(column, row), _grid.Values[n], end, _grid.Values[m], out var zero)) return _edges[edge] = -2;
        _places.Add(zero);
        _first.Add(-1);
        _second.Add(-1);
        return _edges[edge] = _places.Count - 1;
    }

    // Walks on from a crossing and takes the connections away that it passes.
    private void Follow(LevelField field, int start, List<Polyline> lines)
    {
        _line.Clear();
        _line.Add(_places[start]);
        var at = start;
        var closed = false;
        while (true)
        {
            var next = _first[at] >= 0 ? _first[at] : _second[at];
            if (next < 0) break;
            Detach(at, next);
            Detach(next, at);
            Curve(field, _places[at], _places[next], 6);
            at = next;
            closed = at == start;
            if (closed) break;
        }
        if (closed) _line.RemoveAt(_line.Count - 1);
        var points = Thinned(_line, field.Tolerance / 4, closed);
        if (points.Length > 1) lines.Add(Polyline.Own(points, closed && points.Length > 2));
    }

    private void Detach(int p, int q)
    {
        if (_first[p] == q) _first[p] = -1;
        else _second[p] = -1;
    }

    private void Curve(LevelField field, Vec3 a, Vec3 b, int depth)
    {
        if (depth > 0 && a.DistanceTo(b) > 2 * field.Tolerance && field.Bulge(a, b, out var place, out var distance) && distance > field.Tolerance / 2)
        {
            Curve(field, a, place, depth - 1);
            Curve(field, place, b, depth - 1);
            return;
        }
        _line.Add(b);
    }

    private static Vec3[] Thinned(List<Vec3> line, double tolerance, bool closed)
    {
        var kept = LineThinner.Thin(line, tolerance);
        if (line.Count > 1) kept.Add(line[line.Count - 1]);
        if (closed && kept.Count < 3) kept = line;
        return kept.ToArray();
    }
}

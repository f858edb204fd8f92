namespace Caterpillar.Slicing;

/// <summary>The trees of one layer. Nodes follow their parents, and roots are on the boundary of the area.</summary>
/// <param name="reach">Distance up to which a line supports the area next to it, mm.</param>
internal sealed class LightningForest(double reach)
{
    // Branches along a wall would only stand in for it.
    private const double WallPreference = 0.75;

    private readonly double _step = reach / 2;
    private List<Vec3> _places = [];
    private List<int> _parents = [];
    private List<Vec3> _oldPlaces = [];
    private List<int> _oldParents = [];
    private Region _area = Region.Empty;

    /// <summary>Goes on to the area of the layer below; nodes move by at most <paramref name="lean"/> mm.</summary>
    public void Descend(Region area, double lean)
    {
        _area = area;
        (_oldPlaces, _places) = (_places, _oldPlaces);
        (_oldParents, _parents) = (_parents, _oldParents);
        _places.Clear();
        _parents.Clear();
        var count = _oldPlaces.Count;
        if (area.IsEmpty || count == 0) return;
        var children = new int[count];
        var sum = new Vec3[count];
        for (var i = 0; i < count; i++)
        {
            var parent = _oldParents[i];
            if (parent < 0) continue;
            children[parent]++;
            sum[parent] += _oldPlaces[i];
        }
        // A tip that ends is held by its parent, which then must not move away.
        var holds = new bool[count];
        for (var i = 0; i < count; i++)
        {
            if (children[i] == 0 && _oldParents[i] >= 0 && _oldPlaces[i].DistanceTo(_oldPlaces[_oldParents[i]]) <= lean) holds[_oldParents[i]] = true;
        }
        var now = new int[count];
        for (var i = 0; i < count; i++)
        {
            now[i] = -1;
            var parent = _oldParents[i];
            var place = _oldPlaces[i];
            if (!(holds[i] || Moved(i, children[i], sum[i], lean, out place)) || !area.Contains(place.X, place.Y)) continue;
            if (parent >= 0 && now[parent] >= 0)
            {
                now[i] = Add(place, now[parent]);
                continue;
            }
            // A root, or what has lost its root to a wall.
            var ground = _area.NearestEdge(place) ?? place;
            now[i] = ground.DistanceTo(_oldPlaces[i]) <= Math.Max(lean, 1e-6) ? Add(ground, -1) : Branch(ground, place, -1);
        }
    }

    /// <summary>Grows branches until every place of an area is near a line or the boundary.</summary>
    public void Support(Region top, CancellationToken cancel)
    {
        if (top.IsEmpty || _area.IsEmpty) return;
        var cells = new NodeCells(reach);
        for (var i = 0; i < _places.Count; i++) cells.Add(_places[i], i);
        foreach (var (place, distance, ground) in Unsupported(top))
        {
            cancel.ThrowIfCancellationRequested();
            var node = cells.Nearest(place, _places, Math.Max(reach, WallPreference * distance), out var near);
            if (node >= 0 && near <= reach) continue;
            // The nearest branch, where it is clearly nearer than any wall.
            var first = _places.Count;
            Branch(node < 0 ? ground : _places[node], place, node);
            for (var i = first; i < _places.Count; i++) cells.Add(_places[i], i);
        }
    }

    /// <summary>The trees as lines, each from a tip to the root or to a line before it.</summary>
    public List<Polyline> Lines()
    {
        var lines = new List<Polyline>();
        var inner = new bool[_places.Count];
        var drawn = new bool[_places.Count];
        foreach (var parent in _parents)
        {
            if (parent >= 0) inner[parent] = true;
        }
        for (var i = 0; i < _places.Count; i++)
        {
            if (inner[i] || _parents[i] < 0) continue;
            var points = new List<Vec3>();
            for (var at = i; at >= 0; at = _parents[at])
            {
                points.Add(_places[at]);
                if (drawn[at]) break;
                drawn[at] = true;
            }
            lines.Add(Polyline.Own(Straightened(points), closed: false));
        }
        return lines;
    }

    // Where a node of the layer above is in this one; false where it ends.
    private bool Moved(int i, int children, Vec3 sum, double lean, out Vec3 place)
    {
        place = _oldPlaces[i];
        var parent = _oldParents[i];
        if (children == 0)
        {
            if (parent < 0) return false;
            var back = _oldPlaces[parent] - place;
            var length = back.LengthXY;
            if (length <= lean) return false;
            place += back * (lean / length);
            return true;
        }
        var mean = sum / children;
        // Roots slide towards the foot of what they carry, the rest towards the straight line.
        var goal = parent < 0 ? _area.NearestEdge(mean) ?? mean : (_oldPlaces[parent] + mean) / 2;
        var move = goal - place;
        var distance = move.LengthXY;
        place = distance <= lean ? goal : place + move * (lean / distance);
        return true;
    }

    private List<(Vec3 Place, double Distance, Vec3 Ground)> Unsupported(Region top)
    {
        var places = new List<(Vec3 Place, double Distance, Vec3 Ground)>();
        foreach (var row in top.HatchLines(0, _step))
        {
            for (var k = Math.Ceiling(row.From.X / _step); k * _step <= row.To.X; k++)
            {
                var place = new Vec3(k * _step, row.From.Y);
                var ground = _area.NearestEdge(place) ?? place;
                var distance = ground.DistanceTo(place);
                if (distance > reach && _area.Contains(place.X, place.Y)) places.Add((place, distance, ground));
            }
        }
        // From the walls inwards, so that trees grow by twigs.
        places.Sort((a, b) => a.Distance != b.Distance ? a.Distance.CompareTo(b.Distance)
            : a.Place.Y != b.Place.Y ? a.Place.Y.CompareTo(b.Place.Y) : a.Place.X.CompareTo(b.Place.X));
        return places;
    }

    private int Add(Vec3 place, int parent)
    {
        _places.Add(place);
        _parents.Add(parent);
        return _places.Count - 1;
    }

    // Nodes up to a place, from a node or, where there is none, from a new root.
    private int Branch(Vec3 from, Vec3 to, int node)
    {
        var last = node >= 0 ? node : Add(from, -1);
        var pieces = (int)Math.Ceiling(from.DistanceTo(to) / _step);
        for (var i = 1; i <= pieces; i++) last = Add(Vec3.Lerp(from, to, (double)i / pieces), last);
        return last;
    }

    private static Vec3[] Straightened(List<Vec3> points)
    {
        const double Tolerance = 1e-3;
        var kept = new List<Vec3> { points[0] };
        for (var i = 1; i + 1 < points.Count; i++)
        {
            Vec3 a = kept[kept.Count - 1], chord = points[i + 1] - a, p = points[i] - a;
            if (Math.Abs(p.X * chord.Y - p.Y * chord.X) > Tolerance * chord.LengthXY) kept.Add(points[i]);
        }
        kept.Add(points[points.Count - 1]);
        return kept.ToArray();
    }
}

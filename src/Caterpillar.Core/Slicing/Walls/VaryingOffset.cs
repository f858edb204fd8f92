namespace Caterpillar.Slicing;

/// <summary>
/// Offsets of a region inwards by a distance that follows the local thickness. The raw curve has a distance for each sample of the contours; as with plain
/// offsets, the union by positive winding numbers takes away what has turned over.
/// </summary>
internal sealed class VaryingOffset(RegionEngine engine)
{
    // Sides that open by more than 30° (cosine of the angle between contacts) are a corner and no strip.
    private const double ParallelEnough = -0.866;

    // By how much the distance may change along the contour.
    private const double Slope = 0.1;

    // Where strips meet they are wider than along themselves. Of that a side takes so much: its beads lie partly in those of the others there.
    private const double Share = 0.5;

    /// <summary>Measures thickness.</summary>
    public BoundarySampler Sampler { get; } = new();

    private readonly List<BoundarySample> _samples = [];
    private readonly List<List<Item>> _contours = [];
    private readonly Dictionary<GridPoint, double> _distances = [];
    private Region _region = Region.Empty;
    private double _least;
    private int _used;
    private GridPoint[] _raw = new GridPoint[256];
    private int _count;

    private struct Item
    {
        public Vec3 Point;
        public Vec3 Normal;
        public double Distance;

        // Half the radius of the local disc; 0 where it is large.
        public double Half;
        public bool Strip;
    }

    /// <summary>Takes a region. The lists of the one before are used again.</summary>
    /// <param name="region">The region.</param>
    /// <param name="strips">Its parts that are thinner than two limits; elsewhere the distance is the nominal one.</param>
    /// <param name="nominal">Distance where the region is thick, mm. In strips it is half the radius of the local disc, a quarter of the thickness.</param>
    /// <param name="limit">Radius of discs that are thick, mm.</param>
    /// <param name="least">Least distance, mm.</param>
    public void Take(Region region, Region strips, double nominal, double limit, double least)
    {
        _region = region;
        _least = least;
        Sampler.Aim(region, strips, Math.Min(0.25, limit / 2), limit);
        _used = Sampler.Edges.Contours;
        for (var c = 0; c < _used; c++)
        {
            Sampler.Take(c, _samples);
            if (_contours.Count == c) _contours.Add([]);
            var items = _contours[c];
            items.Clear();
            foreach (var s in _samples)
            {
                var known = double.IsInfinity(s.Disc.Radius) || s.Disc.Opposite <= ParallelEnough;
                var strip = known && !double.IsInfinity(s.Disc.Radius);
                var distance = !known ? double.NaN : strip ? Math.Max(s.Disc.Radius / 2, least) : nominal;
                var half = double.IsInfinity(s.Disc.Radius) ? 0 : s.Disc.Radius / 2;
                items.Add(new Item { Point = s.Point, Normal = s.Normal, Distance = distance, Half = half, Strip = strip });
            }
            Bridge(items, nominal, 2 * limit);
            Ease(items);
            Thin(items);
        }
    }

    /// <summary>The rings at the distance, and the distance at each vertex, mm.</summary>
    public List<(GridPoint[] Ring, double[] Distances)> Rings()
    {
        _distances.Clear();
        var rings = Run(1, 0);
        // At tips both sides may run past each other and out again.
        if (engine.Arrangement.Touches || engine.Arrangement.Cut)
            rings = Region.Own(rings).Intersect(_region.Offset(-0.9 * _least, JoinStyle.Miter, 2, 0.005, engine), engine).Paths;
        return rings.Select(ring => (ring, DistancesOf(ring))).ToList();
    }

    /// <summary>Area beyond twice the distance.</summary>
    /// <param name="more">Added in strips, so that both sides take all, mm.</param>
    public Region Inner(double more)
        => Region.Own(Run(2, more)).Intersect(_region.Offset(-1.8 * _least, JoinStyle.Miter, 2, 0.005, engine), engine);

    // Where the disc touches a neighbor nothing is known of the strip, and a short thick place in a strip is none: straight between what is known.
    private static void Bridge(List<Item> items, double nominal, double shortest)
    {
        var n = items.Count;
        var start = items.FindIndex(i => i.Strip);
        if (start < 0)
        {
            for (var i = 0; i < n; i++) Set(items, i, nominal);
            return;
        }
        for (var k = 0; k < n;)
        {
            // k is a strip; next is the strip after it.
            var next = k + 1;
            var length = 0.0;
            var unknown = false;
            var thick = 0.0;
            for (; next <= n; next++)
            {
                Item a = items[(start + next - 1) % n], b = items[(start + next) % n];
                var step = (b.Point - a.Point).LengthXY;
                length += step;
                if (b.Strip) break;
                if (double.IsNaN(b.Distance)) unknown = true;
                else thick += step;
            }
            if (next > k + 1)
            {
                if (thick < shortest) Straight(items, start + k, start + next, length, widens: true);
                else if (unknown) Unknowns(items, start + k, start + next);
            }
            k = next;
        }
    }

    private static void Straight(List<Item> items, int from, int to, double length, bool widens)
    {
        var n = items.Count;
        double a = items[from % n].Distance, b = items[to % n].Distance, done = 0;
        for (var i = from + 1; i < to; i++)
        {
            done += (items[i % n].Point - items[(i - 1) % n].Point).LengthXY;
            var distance = length > 0 ? a + (b - a) * done / length : a;
            var more = Math.Max(0, items[i % n].Half - distance);
            Set(items, i % n, widens ? distance + Share * more : distance);
        }
    }

    // The unknown ones between two known ones, of whatever kind.
    private static void Unknowns(List<Item> items, int from, int to)
    {
        var n = items.Count;
        for (var i = from; i < to;)
        {
            var next = i + 1;
            var length = 0.0;
            for (; next <= to; next++)
            {
                length += (items[next % n].Point - items[(next - 1) % n].Point).LengthXY;
                if (!double.IsNaN(items[next % n].Distance)) break;
            }
            Straight(items, i, next, length, widens: false);
            i = next;
        }
    }

    // Leaves the samples away between which the distance is straight.
    private static void Thin(List<Item> items)
    {
        var kept = 0;
        for (var i = 0; i < items.Count; i++)
        {
            var item = items[i];
            if (kept > 0 && i + 1 < items.Count)
            {
                Item a = items[kept - 1], b = items[i + 1];
                double before = (item.Point - a.Point).LengthXY, after = (b.Point - item.Point).LengthXY;
                var onEdge = a.Normal == item.Normal && item.Normal == b.Normal && before > 0 && after > 0 && a.Strip == item.Strip && b.Strip == item.Strip;
                if (onEdge && Math.Abs(a.Distance + (b.Distance - a.Distance) * before / (before + after) - item.Distance) < 0.0005) continue;
            }
            items[kept++] = item;
        }
        items.RemoveRange(kept, items.Count - kept);
    }

    private static void Set(List<Item> items, int i, double distance)
    {
        var item = items[i];
        item.Distance = distance;
        items[i] = item;
    }

    // A wide bead does not end at once where the place becomes thick.
    private static void Ease(List<Item> items)
    {
        var n = items.Count;
        for (var k = 1; k < 2 * n; k++) Ease(items, (k - 1) % n, k % n);
        for (var k = 2 * n - 1; k > 0; k--) Ease(items, k % n, (k - 1) % n);
    }

    private static void Ease(List<Item> items, int from, int to)
    {
        if (items[to].Strip) return;
        var least = items[from].Distance - Slope * (items[to].Point - items[from].Point).LengthXY;
        if (items[to].Distance < least) Set(items, to, least);
    }

    private GridPoint[][] Run(double factor, double more)
    {
        engine.Clear();
        for (var c = 0; c < _used; c++)
        {
            var items = _contours[c];
            _count = 0;
            for (int i = 0, next; i < items.Count; i = next)
            {
                for (next = i + 1; next < items.Count && items[next].Point == items[i].Point;) next++;
                Corner(items, i, next, factor, more);
            }
            engine.Arrangement.Add(_raw, 0, _count, 0);
        }
        return engine.Run(InsideRule.Positive);
    }

    // The samples of one point: one on an edge, two at a corner, more in a fan.
    private void Corner(List<Item> items, int from, int to, double factor, double more)
    {
        if (to == from + 2 && Mitered(items, from, factor, more, out var at))
        {
            Put(at, (items[from].Distance + items[from + 1].Distance) / 2);
            return;
        }
        for (var i = from; i < to; i++)
        {
            var item = items[i];
            Put(item.Point + item.Normal * Moved(item, factor, more), item.Distance);
            // Where the moved edges overlap, back through the vertex.
            if (i + 1 < to && Cross(item.Normal, items[i + 1].Normal) > 0) Put(item.Point, item.Distance);
        }
    }

    // The one point in which the moved edges meet, where both are long enough.
    private static bool Mitered(List<Item> items, int i, double factor, double more, out Vec3 at)
    {
        Item a = items[i], b = items[i + 1], before = items[i == 0 ? items.Count - 1 : i - 1], after = items[i + 2 == items.Count ? 0 : i + 2];
        at = default;
        var dot = a.Normal.X * b.Normal.X + a.Normal.Y * b.Normal.Y;
        if (dot < -0.45) return false;
        var distance = (Moved(a, factor, more) + Moved(b, factor, more)) / 2;
        var cross = Cross(a.Normal, b.Normal);
        var cut = distance * Math.Abs(cross) / (1 + dot);
        if (cross > 0 && cut > 0.45 * Math.Min((a.Point - before.Point).LengthXY, (after.Point - b.Point).LengthXY)) return false;
        at = a.Point + (a.Normal + b.Normal) * (distance / (1 + dot));
        return true;
    }

    private static double Moved(in Item item, double factor, double more) => item.Distance * factor + (item.Strip ? more : 0);

    private static double Cross(Vec3 a, Vec3 b) => a.X * b.Y - a.Y * b.X;

    private void Put(Vec3 p, double distance)
    {
        if (_raw.Length == _count) Array.Resize(ref _raw, 2 * _count);
        var g = new GridPoint(Grid.Round(p.X * Grid.PerMm), Grid.Round(p.Y * Grid.PerMm));
        if (_count > 0 && _raw[_count - 1] == g) return;
        _raw[_count++] = g;
        _distances[g] = distance;
    }

    // New vertices, where the curve crossed itself, have a distance between those of their neighbors.
    private double[] DistancesOf(GridPoint[] ring)
    {
        var n = ring.Length;
        var result = new double[n];
        var start = -1;
        for (var i = 0; i < n; i++)
        {
            result[i] = _distances.TryGetValue(ring[i], out var d) ? d : double.NaN;
            if (start < 0 && !double.IsNaN(result[i])) start = i;
        }
        if (start < 0) start = 0;
        if (double.IsNaN(result[start])) result[start] = _contours[0][0].Distance;
        for (var k = 1; k < n; k++)
        {
            var i = (start + k) % n;
            if (!double.IsNaN(result[i])) continue;
            var before = result[(i + n - 1) % n];
            var next = k + 1;
            while (double.IsNaN(result[(start + next) % n])) next++;
            result[i] = (before + result[(start + next) % n]) / 2;
        }
        return result;
    }
}

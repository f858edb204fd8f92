namespace Caterpillar.Planning;

/// <summary>
/// Shortens the travel between paths by exchanges: 2-opt (a section of the order is reversed, each path from its other end) and Or-opt (up to three paths
/// move elsewhere), tried only between near ends (Bentley 1992, "Fast algorithms for geometric traveling salesman problems"). Ends after a number of passes,
/// never by the clock.
/// </summary>
internal sealed class TourImprover
{
    // Ends that are tried near each end of a path.
    private const int Neighbors = 3;
    private const int MostPasses = 8;
    private const double MinGain = 1e-7;
    private readonly SortItem[] _items;
    private readonly PathPlacement[] _order;
    private readonly int[] _place;
    private readonly int[][] _near;
    private readonly Vec3? _start;
    private readonly bool _reversible;
    private readonly int _reach;

    // Paths whose neighbors have changed since they were last tried ("don't look" bits, Bentley 1992).
    private readonly bool[] _fresh;

    private TourImprover(SortItem[] items, PathPlacement[] order, Vec3? start)
    {
        _items = items;
        _order = order;
        _start = start;
        _place = new int[order.Length];
        for (var i = 0; i < order.Length; i++) _place[order[i].Index] = i;
        _reversible = Array.TrueForAll(items, i => i.CanTurn);
        // Long sections cost time to reverse and gain no more than short ones.
        _reach = order.Length <= 10_000 ? order.Length : 1_000;
        _near = NearPaths();
        _fresh = [.. Enumerable.Repeat(true, order.Length)];
    }

    public static PathPlacement[] Improve(SortItem[] items, PathPlacement[] order, Vec3? start, CancellationToken cancel)
    {
        if (order.Length < 3) return order;
        var tour = new TourImprover(items, (PathPlacement[])order.Clone(), start);
        var pass = 0;
        while (pass < MostPasses && tour.Pass(cancel)) pass++;
        tour.RotateLoops();
        return NearestOrder.TravelLength(items, tour._order, start) < NearestOrder.TravelLength(items, order, start) ? tour._order : order;
    }

    private Vec3 Entry(int place) => _items[_order[place].Index].Entry(_order[place]);

    private Vec3 Exit(int place) => _items[_order[place].Index].Exit(_order[place]);

    // TravelLength into a place of the order from the one before it.
    private double Gap(int place) => place == 0
        ? (_start is { } from ? from.DistanceTo(Entry(0)) : 0)
        : place == _order.Length ? 0 : Exit(place - 1).DistanceTo(Entry(place));

    private double FromBefore(int place, Vec3 to) => place == 0 ? (_start is { } from ? from.DistanceTo(to) : 0) : Exit(place - 1).DistanceTo(to);

    private double ToAfter(int place, Vec3 from) => place + 1 == _order.Length ? 0 : from.DistanceTo(Entry(place + 1));

    private bool Pass(CancellationToken cancel)
    {
        var better = false;
        // Without a start position, the first path stays first.
        var first = _start is null ? 1 : 0;
        for (var path = 0; path < _order.Length; path++)
        {
            if ((path & 1023) == 0) cancel.ThrowIfCancellationRequested();
            if (!_fresh[path]) continue;
            _fresh[path] = false;
            foreach (var other in _near[path])
            {
                var a = _place[path];
                var b = _place[other];
                if (_reversible && (TryReverse(Math.Min(a, b) + 1, Math.Max(a, b), first) || TryReverse(Math.Min(a, b), Math.Max(a, b) - 1, first)))
                {
                    better = true;
                    continue;
                }
                better |= TryMove(_place[path], _place[other], first);
            }
        }
        return better;
    }

    private bool TryReverse(int from, int to, int first)
    {
        if (from < first || to < from || to - from > _reach) return false;
        var gain = Gap(from) + Gap(to + 1) - FromBefore(from, Exit(to)) - ToAfter(to, Entry(from));
        if (gain <= MinGain) return false;
        Reverse(from, to);
        Touch(from - 1, from, to, to + 1);
        return true;
    }

    private void Touch(params int[] places)
    {
        foreach (var place in places.Where(p => p >= 0 && p < _order.Length)) _fresh[_order[place].Index] = true;
    }

    // Moves one, two or three paths that start or end at a position to after or before another.
    private bool TryMove(int at, int target, int first)
    {
        for (var length = 1; length <= 3; length++)
        {
            for (var side = 0; side < (length == 1 ? 1 : 2); side++)
            {
                var from = side == 0 ? at : at - length + 1;
                var to = from + length - 1;
                if (from < first || to >= _order.Length || (target >= from && target <= to)) continue;
                if (TryPlace(from, to, target) || (target > 0 && TryPlace(from, to, target - 1))) return true;
            }
        }
        return false;
    }

    // Moves a section to after a position.
    private bool TryPlace(int from, int to, int after)
    {
        if (after >= from - 1 && after <= to) return false;
        if (Math.Abs(after - from) > _reach) return false;
        var near = Exit(after);
        var next = after + 1 < _order.Length ? Entry(after + 1) : default;
        var hasNext = after + 1 < _order.Length;
        var closed = to + 1 < _order.Length ? FromBefore(from, Entry(to + 1)) : 0;
        var saved = Gap(from) + Gap(to + 1) + Gap(after + 1) - closed;
        var straight = near.DistanceTo(Entry(from)) + (hasNext ? Exit(to).DistanceTo(next) : 0);
        var turned = _reversible ? near.DistanceTo(Exit(to)) + (hasNext ? Entry(from).DistanceTo(next) : 0) : double.PositiveInfinity;
        if (saved - Math.Min(straight, turned) <= MinGain) return false;
        // A move is three reversals: of the whole section, and of its two parts.
        int left, middle, right;
        if (after > to) (left, middle, right) = (from, from + (after - to), after);
        else (left, middle, right) = (after + 1, after + 1 + (to - from + 1), to);
        Reverse(left, right);
        var movedIsFirst = after < from;
        if (movedIsFirst ? straight <= turned : true) Reverse(left, middle - 1);
        if (movedIsFirst || straight <= turned) Reverse(middle, right);
        Touch(left - 1, left, middle - 1, middle, right, right + 1);
        return true;
    }

    private void Reverse(int from, int to)
    {
        for (; from <= to; from++, to--)
        {
            var a = Reversed(_order[from]);
            var b = Reversed(_order[to]);
            _order[from] = b;
            _order[to] = a;
            _place[b.Index] = from;
            _place[a.Index] = to;
        }
    }

    private PathPlacement Reversed(PathPlacement place) => !_items[place.Index].Reverse ? place : place with { Reversed = !place.Reversed };

    private void RotateLoops()
    {
        for (var i = 0; i < _order.Length; i++)
        {
            var item = _items[_order[i].Index];
            if (!item.Rotate || (i == 0 && _start is null)) continue;
            var from = i > 0 ? Exit(i - 1) : _start!.Value;
            _order[i] = i + 1 < _order.Length ? item.Between(_order[i].Index, from, Entry(i + 1)) : item.NearestEntry(_order[i].Index, from);
        }
    }

    // For each path the paths with the nearest ends, first those near its start.
    private int[][] NearPaths()
    {
        var ends = new Vec3[_order.Length * 2];
        foreach (var place in _order)
        {
            ends[place.Index * 2] = _items[place.Index].Entry(place);
            ends[place.Index * 2 + 1] = _items[place.Index].Exit(place);
        }
        var tree = new EntryTree(ends);
        var near = new int[_order.Length][];
        var found = new List<int>();
        var taken = new List<int>();
        for (var path = 0; path < near.Length; path++)
        {
            found.Clear();
            tree.Remove(path * 2);
            tree.Remove(path * 2 + 1);
            for (var end = 0; end < 2; end++)
            {
                taken.Clear();
                while (taken.Count < Neighbors && tree.Nearest(ends[path * 2 + end]) is >= 0 and var nearest)
                {
                    taken.Add(nearest);
                    tree.Remove(nearest);
                }
                foreach (var point in taken) tree.Restore(point);
                found.AddRange(taken.Select(point => point / 2));
            }
            tree.Restore(path * 2);
            tree.Restore(path * 2 + 1);
            near[path] = [.. found.Distinct()];
        }
        return near;
    }
}

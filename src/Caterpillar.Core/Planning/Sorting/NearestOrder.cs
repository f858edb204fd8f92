namespace Caterpillar.Planning;

/// <summary>Orders by the nearest start, and the travel of an order.</summary>
internal static class NearestOrder
{
    /// <summary>
    /// From each end to the nearest start; the first path stays first if the position of the head is unknown. The given order, if that is shorter.
    /// </summary>
    public static PathPlacement[] Find(SortItem[] items, Vec3? start, CancellationToken cancel)
    {
        if (items.Length == 0) return [];
        if (items.Length == 1) return [start is { } from ? items[0].NearestEntry(0, from) : new PathPlacement(0)];
        var entries = new EntryPoints(items.Select((item, i) => (item, i)));
        var order = new PathPlacement[items.Length];
        var at = start ?? items[0].Path.Start;
        for (var n = 0; n < order.Length; n++)
        {
            if ((n & 1023) == 0) cancel.ThrowIfCancellationRequested();
            var owner = n == 0 && start is null ? 0 : entries.NearestOwner(at);
            order[n] = n == 0 && start is null ? new PathPlacement(0) : items[owner].NearestEntry(owner, at);
            entries.Remove(owner);
            at = items[owner].Exit(order[n]);
        }
        var given = AsGiven(items.Length);
        return TravelLength(items, given, start) < TravelLength(items, order, start) ? given : order;
    }

    /// <summary>The given order, each path from its nearest end or vertex.</summary>
    public static PathPlacement[] Orient(SortItem[] items, Vec3? start)
    {
        var order = new PathPlacement[items.Length];
        for (var i = 0; i < items.Length; i++)
        {
            order[i] = start is { } from ? items[i].NearestEntry(i, from) : new PathPlacement(i);
            start = items[i].Exit(order[i]);
        }
        return order;
    }

    public static PathPlacement[] AsGiven(int count) => Enumerable.Range(0, count).Select(i => new PathPlacement(i)).ToArray();

    /// <summary>Length in mm of the travel between the paths.</summary>
    public static double TravelLength(SortItem[] items, PathPlacement[] order, Vec3? start)
    {
        var sum = 0.0;
        foreach (var place in order)
        {
            var item = items[place.Index];
            if (start is { } from) sum += from.DistanceTo(item.Entry(place));
            start = item.Exit(place);
        }
        return sum;
    }
}

namespace Caterpillar.Planning;

/// <summary>Sorts paths for short travel between them. All rules are deterministic: equal distances are decided by the order of the input.</summary>
public static class PathSorter
{
    // Paths whose lowest points differ by less lie at the same height, mm.
    private const double SameHeight = 1e-4;

    /// <summary>The paths in the requested order, reversed and rotated if allowed. None is lost or duplicated.</summary>
    /// <exception cref="ArgumentException">A path is null.</exception>
    public static IReadOnlyList<PrintPath> Sort(
        IReadOnlyList<PrintPath> paths, SortOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
        => [.. Order(paths, options, progress, cancel).Select(place => place.Of(paths[place.Index]))];

    /// <summary>The same order as indices of the paths, with their direction and start.</summary>
    /// <exception cref="ArgumentException">A path is null.</exception>
    public static IReadOnlyList<PathPlacement> Order(
        IReadOnlyList<PrintPath> paths, SortOptions? options = null, IProgress<double>? progress = null, CancellationToken cancel = default)
    {
        if (paths is null) throw new ArgumentNullException(nameof(paths));
        options ??= new SortOptions();
        SortItem[] items = [.. paths.Select(path => new SortItem(
            path ?? throw new ArgumentException("A path is null.", nameof(paths)), options.Reverse, options.Rotate))];
        return options.Rule switch
        {
            SortRule.Layer => Grouped(items, ByLayer(paths), options, progress, cancel),
            SortRule.Z => Grouped(items, ByHeight(paths), options, progress, cancel),
            _ => Find(items, options, cancel),
        };
    }

    /// <summary>Total distance in mm from the end of each path to the start of the next.</summary>
    public static double TravelBetween(IReadOnlyList<PrintPath> paths)
    {
        if (paths is null) throw new ArgumentNullException(nameof(paths));
        return paths.Zip(paths.Skip(1), (path, next) => path.End.DistanceTo(next.Start)).Sum();
    }

    internal static PathPlacement[] Find(SortItem[] items, SortOptions options, CancellationToken cancel)
    {
        switch (options.Rule)
        {
            case SortRule.None:
                return NearestOrder.AsGiven(items.Length);
            case SortRule.Orient:
                return NearestOrder.Orient(items, options.Start);
            default:
                var order = NearestOrder.Find(items, options.Start, cancel);
                return options.Rule == SortRule.Tour ? TourImprover.Improve(items, order, options.Start, cancel) : order;
        }
    }

    private static List<PathPlacement> Grouped(
        SortItem[] items, IEnumerable<int[]> groups, SortOptions options, IProgress<double>? progress, CancellationToken cancel)
    {
        var order = new List<PathPlacement>(items.Length);
        var at = options.Start;
        foreach (var group in groups)
        {
            var members = Array.ConvertAll(group, i => items[i]);
            var found = NearestOrder.Find(members, at, cancel);
            foreach (var place in found) order.Add(place with { Index = group[place.Index] });
            at = members[found[found.Length - 1].Index].Exit(found[found.Length - 1]);
            progress?.Report((double)order.Count / items.Length);
        }
        return order;
    }

    private static IEnumerable<int[]> ByLayer(IReadOnlyList<PrintPath> paths) => Enumerable.Range(0, paths.Count)
        .GroupBy(i => paths[i].Layer?.Index ?? -1)
        .OrderBy(g => g.Key)
        .Select(g => g.ToArray());

    private static IEnumerable<int[]> ByHeight(IReadOnlyList<PrintPath> paths)
    {
        var heights = paths.Select(path => path.RawPoints.Min(p => p.Z)).ToArray();
        var byHeight = Enumerable.Range(0, paths.Count).OrderBy(i => heights[i]).ToArray();
        for (int first = 0, end = 0; first < byHeight.Length; first = end)
        {
            while (end < byHeight.Length && heights[byHeight[end]] - heights[byHeight[first]] < SameHeight) end++;
            yield return [.. new ArraySegment<int>(byHeight, first, end - first).OrderBy(i => i)];
        }
    }
}

namespace Caterpillar.Planning;

/// <summary>A step in planned order, with its number in the design.</summary>
internal readonly struct OrderedStep(Step step, PrintPath? path, int source)
{
    public readonly Step Step = step;

    /// <summary>The path of a path step, reversed or rotated; null for other steps.</summary>
    public readonly PrintPath? Path = path;

    public readonly int Source = source;
}

/// <summary>
/// Sorts the paths of steps where their groups allow it: layers from below, in a layer the nearest island first, in an island the ranks from the lowest.
/// Events, drawn travels and paths without a group stay where they are, and no path crosses them.
/// </summary>
internal sealed class StepOrder(IReadOnlyList<Step> steps, SortOptions options, CancellationToken cancel)
{
    // The steps in order so far, and where the head is after them.
    private OrderedStep[] _ordered = new OrderedStep[steps.Count];
    private int _count;
    private Vec3? _at = options.Start;

    // The numbers of the steps that are being sorted, by their groups.
    private int[] _run = [];

    public static OrderedStep[] Find(IReadOnlyList<Step> steps, SortOptions options, IProgress<double>? progress, CancellationToken cancel)
        => new StepOrder(steps, options, cancel).Find(progress);

    private OrderedStep[] Find(IProgress<double>? progress)
    {
        for (int first = 0, end; first < steps.Count; first = end)
        {
            end = first + 1;
            if (options.Rule == SortRule.None || steps[first] is not PathStep { Group: not null })
            {
                if (steps[first] is TravelStep travel) _at = travel.Points[travel.Points.Count - 1];
                var path = (steps[first] as PathStep)?.Path;
                if (path is not null) _at = path.End;
                _ordered[_count++] = new OrderedStep(steps[first], path, first);
                continue;
            }
            while (end < steps.Count && steps[end] is PathStep { Group: not null }) end++;
            SortRun(first, end);
            progress?.Report((double)end / steps.Count);
        }
        return _ordered;
    }

    private void SortRun(int first, int end)
    {
        _run = [.. Enumerable.Range(first, end - first).OrderBy(i => GroupOf(i).Layer).ThenBy(i => GroupOf(i).Island).ThenBy(i => GroupOf(i).Rank)];
        var from = 0;
        foreach (var layer in _run.GroupBy(i => GroupOf(i).Layer))
        {
            var islands = new List<(int From, int To)>();
            foreach (var island in layer.GroupBy(i => GroupOf(i).Island))
            {
                var to = from + island.Count();
                islands.Add((from, to));
                from = to;
            }
            SortLayer(islands);
        }
    }

    private void SortLayer(List<(int From, int To)> islands)
    {
        // An island starts with its group of the lowest rank: the nearest of those entries decides which island comes next.
        var choose = islands.Count > 1 && options.Rule != SortRule.Orient ? Entries(islands) : null;
        var sorted = new (int From, int To)[islands.Count];
        var starts = new int[islands.Count];
        var (at, leads) = (_at, 0);
        for (var n = 0; n < islands.Count; n++)
        {
            // Islands below zero (a skirt) come first, in their order.
            var isLead = GroupOf(_run[islands[n].From]).Island < 0;
            if (isLead) leads++;
            var next = isLead || choose is null || _at is null ? n : choose.NearestOwner(_at.Value);
            choose?.Remove(next);
            sorted[n] = islands[next];
            starts[n] = _count;
            SortIsland(sorted[n]);
        }
        if (options.Rule == SortRule.Tour && islands.Count - leads >= 3) Exchange(sorted, starts, leads, at);
    }

    private void SortIsland((int From, int To) island)
    {
        for (int from = island.From, to; from < island.To; from = to)
        {
            var rank = RankAt(from);
            to = from + 1;
            while (to < island.To && RankAt(to) == rank) to++;
            SortGroup(from, to);
        }
    }

    // The order of the islands improved by exchanges, each taken as a line from its entry to its exit; kept where the travel is shorter in the end.
    private void Exchange((int From, int To)[] islands, int[] starts, int leads, Vec3? at)
    {
        var items = new SortItem[islands.Length - leads];
        for (var i = 0; i < items.Length; i++)
        {
            var end = leads + i + 1 < starts.Length ? starts[leads + i + 1] : _count;
            // One that ends where it began may be passed in either direction.
            items[i] = new SortItem(_ordered[starts[leads + i]].Path!, false, false, _ordered[end - 1].Path!);
        }
        var start = leads == 0 ? at : _ordered[starts[leads] - 1].Path!.End;
        var places = TourImprover.Improve(items, NearestOrder.AsGiven(items.Length), start, cancel);
        if (Enumerable.Range(0, places.Length).All(i => places[i].Index == i)) return;
        var from = starts[leads];
        var (ordered, count, exit) = (_ordered, _count, _at);
        (_ordered, _count, _at) = (new OrderedStep[count - from], 0, start);
        foreach (var place in places) SortIsland(islands[leads + place.Index]);
        var (better, other) = (_ordered, _at);
        (_ordered, _count, _at) = (ordered, count, exit);
        if (!(Travel(better, 0, better.Length, start) < Travel(ordered, from, count, start))) return;
        Array.Copy(better, 0, ordered, from, better.Length);
        _at = other;
    }

    private static double Travel(OrderedStep[] ordered, int from, int end, Vec3? at)
    {
        var sum = 0.0;
        for (; from < end; from++)
        {
            var path = ordered[from].Path!;
            if (at is { } last) sum += last.DistanceTo(path.Start);
            at = path.End;
        }
        return sum;
    }

    private void SortGroup(int from, int to)
    {
        // Paths that stay together are one item; heads are where they begin.
        int[] heads = [.. Enumerable.Range(from, to - from).Where(i => i == from || !PathAt(i).Joined), to];
        var items = new SortItem[heads.Length - 1];
        for (var i = 0; i < items.Length; i++)
        {
            var last = heads[i + 1] - 1;
            items[i] = Item(heads[i], last > heads[i] ? PathAt(last).Path : null);
        }
        foreach (var place in PathSorter.Find(items, options with { Start = _at }, cancel))
        {
            var head = heads[place.Index];
            Add(head, place.Of(items[place.Index].Path));
            for (var i = head + 1; i < heads[place.Index + 1]; i++)
            {
                var item = Item(i);
                Add(i, item.NearestEntry(0, _at!.Value).Of(item.Path));
            }
        }
    }

    private void Add(int place, PrintPath path)
    {
        _ordered[_count++] = new OrderedStep(steps[_run[place]], path, _run[place]);
        _at = path.End;
    }

    // One whose first path was taken out is the first itself.
    private EntryPoints Entries(List<(int From, int To)> islands)
        => new(islands.SelectMany((island, owner) => Enumerable.Range(island.From, island.To - island.From)
            .TakeWhile(i => RankAt(i) == RankAt(island.From))
            .Where(i => i == island.From || !PathAt(i).Joined)
            .Select(i => (Item(i), owner))));

    private SortItem Item(int place, PrintPath? tail = null)
    {
        var step = PathAt(place);
        return new SortItem(step.Path, options.Reverse && !step.KeepStart, options.Rotate && !step.KeepStart, tail);
    }

    private PathStep PathAt(int place) => (PathStep)steps[_run[place]];

    private StepGroup GroupOf(int step) => ((PathStep)steps[step]).Group!.Value;

    private int RankAt(int place) => GroupOf(_run[place]).Rank;
}

using System;
using System.Collections.Generic;
using System.Threading;
using Caterpillar.Basics;
using Caterpillar.Geometry;
using Caterpillar.Toolpaths;

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
internal static class StepOrder
{
    public static OrderedStep[] Find(IReadOnlyList<Step> steps, SortOptions options, IProgress<double>? progress, CancellationToken cancel)
    {
        var ordered = new OrderedStep[steps.Count];
        var count = 0;
        var at = options.Start;
        for (int first = 0, end; first < steps.Count; first = end)
        {
            end = first + 1;
            if (options.Rule == SortRule.None || steps[first] is not PathStep { Group: not null })
            {
                if (steps[first] is TravelStep travel) at = travel.Points[travel.Points.Count - 1];
                var path = (steps[first] as PathStep)?.Path;
                if (path is not null) at = path.End;
                ordered[count++] = new OrderedStep(steps[first], path, first);
                continue;
            }
            while (end < steps.Count && steps[end] is PathStep { Group: not null }) end++;
            at = SortRun(steps, first, end, ordered, ref count, at, options, cancel);
            progress?.Report((double)end / steps.Count);
        }
        return ordered;
    }

    private static Vec3? SortRun(
        IReadOnlyList<Step> steps, int first, int end, OrderedStep[] ordered, ref int count, Vec3? at, SortOptions options, CancellationToken cancel)
    {
        var run = new int[end - first];
        var groups = new StepGroup[run.Length];
        var isSorted = true;
        for (var i = 0; i < run.Length; i++)
        {
            run[i] = first + i;
            groups[i] = ((PathStep)steps[first + i]).Group!.Value;
            isSorted &= i == 0 || Compare(groups[i - 1], groups[i]) <= 0;
        }
        if (!isSorted) Array.Sort(run, (a, b) => Compare(groups[a - first], groups[b - first]) is var c and not 0 ? c : a.CompareTo(b));
        for (int from = 0, to; from < run.Length; from = to)
        {
            to = from;
            var layer = groups[run[from] - first].Layer;
            var islands = new List<(int From, int To)>();
            while (to < run.Length && groups[run[to] - first].Layer == layer)
            {
                var begin = to;
                var island = groups[run[to] - first].Island;
                while (to < run.Length && groups[run[to] - first] is var g && g.Layer == layer && g.Island == island) to++;
                islands.Add((begin, to));
            }
            at = SortLayer(steps, run, islands, ordered, ref count, at, options, cancel);
        }
        return at;
    }

    private static Vec3? SortLayer(
        IReadOnlyList<Step> steps, int[] run, List<(int From, int To)> islands, OrderedStep[] ordered, ref int count, Vec3? at, SortOptions options,
        CancellationToken cancel)
    {
        // An island starts with its group of the lowest rank: the nearest of those entries decides which island comes next.
        var choose = islands.Count > 1 && options.Rule != SortRule.Orient ? Entries(steps, run, islands, options) : null;
        var order = new int[islands.Count];
        var starts = new int[islands.Count + 1];
        var (to, leads) = (at, 0);
        for (var n = 0; n < islands.Count; n++)
        {
            // Islands below zero (a skirt) come first, in their order.
            var isLead = ((PathStep)steps[run[islands[n].From]]).Group!.Value.Island < 0;
            if (isLead) leads++;
            order[n] = isLead || choose is null || to is null ? n : choose.OwnerOf(choose.Nearest(to.Value));
            choose?.Remove(order[n]);
            starts[n] = count;
            to = SortIsland(steps, run, islands[order[n]], ordered, ref count, to, options, cancel);
        }
        starts[islands.Count] = count;
        if (options.Rule != SortRule.Tour || islands.Count - leads < 3 || options.Passes < 1) return to;
        return Exchange(steps, run, islands, order, starts, leads, ordered, at, options, cancel) ?? to;
    }

    private static Vec3? SortIsland(
        IReadOnlyList<Step> steps, int[] run, (int From, int To) island, OrderedStep[] ordered, ref int count, Vec3? at, SortOptions options,
        CancellationToken cancel)
    {
        for (int from = island.From, to; from < island.To; from = to)
        {
            var rank = Rank(steps[run[from]]);
            to = from + 1;
            while (to < island.To && Rank(steps[run[to]]) == rank) to++;
            at = SortGroup(steps, run, from, to, ordered, ref count, at, options, cancel);
        }
        return at;
    }

    // The order of the islands improved by exchanges, each taken as a line from its entry to its exit; kept where the travel is shorter in the end.
    private static Vec3? Exchange(
        IReadOnlyList<Step> steps, int[] run, List<(int From, int To)> islands, int[] order, int[] starts, int leads, OrderedStep[] ordered,
        Vec3? at, SortOptions options, CancellationToken cancel)
    {
        var items = new SortItem[islands.Count - leads];
        for (var i = 0; i < items.Length; i++)
        {
            var (a, b) = (ordered[starts[leads + i]].Path!, ordered[starts[leads + i + 1] - 1].Path!);
            // One that ends where it began may be passed in either direction.
            items[i] = new SortItem(a, false, false, b);
        }
        var start = leads == 0 ? at : ordered[starts[leads] - 1].Path!.End;
        var places = TourImprover.Improve(items, NearestOrder.AsGiven(items.Length), start, options.Passes, cancel);
        var same = true;
        for (var i = 0; i < places.Length; i++) same &= places[i].Index == i;
        if (same) return null;
        var from = starts[leads];
        var better = new OrderedStep[starts[islands.Count] - from];
        var count = 0;
        var to = start;
        foreach (var place in places) to = SortIsland(steps, run, islands[order[leads + place.Index]], better, ref count, to, options, cancel);
        if (!(Travel(better, 0, count, start) < Travel(ordered, from, starts[islands.Count], start))) return null;
        Array.Copy(better, 0, ordered, from, count);
        return to;
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

    private static Vec3? SortGroup(
        IReadOnlyList<Step> steps, int[] run, int from, int to, OrderedStep[] ordered, ref int count, Vec3? at, SortOptions options, CancellationToken cancel)
    {
        // Paths that stay together are one item; heads are where they begin.
        var heads = new List<int>();
        for (var i = from; i < to; i++)
        {
            if (i == from || !((PathStep)steps[run[i]]).Joined) heads.Add(i);
        }
        heads.Add(to);
        var items = new SortItem[heads.Count - 1];
        for (var i = 0; i < items.Length; i++)
        {
            var last = heads[i + 1] - 1;
            items[i] = Item((PathStep)steps[run[heads[i]]], options, last > heads[i] ? ((PathStep)steps[run[last]]).Path : null);
        }
        foreach (var place in PathSorter.Find(items, options with { Start = at }, cancel))
        {
            var head = heads[place.Index];
            ordered[count++] = new OrderedStep(steps[run[head]], items[place.Index].Placed(place), run[head]);
            at = ordered[count - 1].Path!.End;
            for (var i = head + 1; i < heads[place.Index + 1]; i++)
            {
                var item = Item((PathStep)steps[run[i]], options);
                var path = item.Placed(item.NearestEntry(0, at.Value));
                ordered[count++] = new OrderedStep(steps[run[i]], path, run[i]);
                at = path.End;
            }
        }
        return at;
    }

    private static IslandEntries Entries(IReadOnlyList<Step> steps, int[] run, List<(int From, int To)> islands, SortOptions options)
    {
        var items = new List<SortItem>();
        var owners = new List<int>();
        for (var island = 0; island < islands.Count; island++)
        {
            var (from, to) = islands[island];
            var rank = Rank(steps[run[from]]);
            for (var i = from; i < to && Rank(steps[run[i]]) == rank; i++)
            {
                // One whose first path was taken out is the first itself.
                if (i > from && ((PathStep)steps[run[i]]).Joined) continue;
                items.Add(Item((PathStep)steps[run[i]], options));
                owners.Add(island);
            }
        }
        return new IslandEntries(items.ToArray(), owners.ToArray(), islands.Count);
    }

    private static SortItem Item(PathStep step, SortOptions options, PrintPath? tail = null)
        => new(step.Path, options.Reverse && !step.KeepStart, options.Rotate && !step.KeepStart, tail);

    private static int Rank(Step step) => ((PathStep)step).Group!.Value.Rank;

    private static int Compare(StepGroup a, StepGroup b)
    {
        var layer = a.Layer.CompareTo(b.Layer);
        if (layer != 0) return layer;
        var island = a.Island.CompareTo(b.Island);
        return island != 0 ? island : a.Rank.CompareTo(b.Rank);
    }

    private sealed class IslandEntries
    {
        private readonly EntryPoints _entries;
        private readonly int[] _owners;
        private readonly int[] _firsts;

        public IslandEntries(SortItem[] items, int[] owners, int islands)
        {
            _entries = new EntryPoints(items);
            _owners = owners;
            _firsts = new int[islands + 1];
            foreach (var owner in owners) _firsts[owner + 1]++;
            for (var i = 0; i < islands; i++) _firsts[i + 1] += _firsts[i];
        }

        public int Nearest(Vec3 at) => _entries.Tree.Nearest(at);

        public int OwnerOf(int point) => _owners[_entries.OwnerOf(point)];

        public void Remove(int island)
        {
            for (var i = _firsts[island]; i < _firsts[island + 1]; i++) _entries.RemoveOwner(i);
        }
    }
}

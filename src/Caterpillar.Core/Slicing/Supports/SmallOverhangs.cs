namespace Caterpillar.Slicing;

/// <summary>
/// Overhangs that print without supports because they are small: pieces that touch from level to level, together no longer than what hangs freely and a few
/// lines wide, that begin at the part and stay near it.
/// </summary>
internal static class SmallOverhangs
{
    // mm; the length of a free end that sags little, and the farthest from the part.
    private const double MostFree = 5;
    private const double Farthest = 3;

    // Lines.
    private const double MostWide = 4;
    private const double Touch = 0.02;

    /// <summary>Takes them out of the levels.</summary>
    public static void Remove(SupportLevel[] levels, double width, CancellationToken cancel)
    {
        var engine = new RegionEngine();
        // Those that reach the level before.
        List<Cluster> open = [];
        var removed = new HashSet<Region>();
        for (var i = 1; i <= levels.Length; i++)
        {
            cancel.ThrowIfCancellationRequested();
            List<Cluster> next = i < levels.Length ? [.. levels[i].Overhang.Islands.Select(o => new Cluster(i, o))] : [];
            foreach (var cluster in open)
            {
                var touching = next.FindAll(c => c.Touches(cluster, width));
                foreach (var other in touching.Skip(1)) next.Remove(other);
                if (touching.Count > 0) touching[0].Add(touching.Skip(1).Prepend(cluster));
                else if (IsSmall(cluster)) removed.UnionWith(cluster.Pieces.Select(p => p.Overhang));
            }
            open = next;
        }
        if (removed.Count == 0) return;
        foreach (var level in levels.Where(l => l.Overhang.Islands.Any(removed.Contains)))
            level.Overhang = Region.Own([.. level.Overhang.Islands.Where(o => !removed.Contains(o)).SelectMany(o => o.Paths)]);

        bool IsSmall(Cluster cluster)
        {
            var size = cluster.Box.Size;
            return Math.Max(size.X, size.Y) <= MostFree && Math.Min(size.X, size.Y) <= MostWide * width
                && cluster.Pieces.All(p => IsHeld(p.Overhang, levels[p.Level - 1].Part));
        }

        bool IsHeld(Region overhang, Region below)
        {
            var near = below.Near([overhang.Box], Farthest);
            return !near.Offset(Touch, JoinStyle.Miter, 2, Touch, engine).Intersect(overhang, engine).IsEmpty
                && overhang.Subtract(near.Offset(Farthest, JoinStyle.Round, 2, Touch, engine), engine).IsEmpty;
        }
    }

    // Pieces that touch, by their boxes: where in doubt, they are supported.
    private sealed class Cluster(int level, Region overhang)
    {
        public Bounds Box { get; private set; } = overhang.Bounds;

        public List<(int Level, Region Overhang)> Pieces { get; } = [(level, overhang)];

        public bool Touches(Cluster other, double distance)
            => Box.Min.X <= other.Box.Max.X + distance && other.Box.Min.X <= Box.Max.X + distance
            && Box.Min.Y <= other.Box.Max.Y + distance && other.Box.Min.Y <= Box.Max.Y + distance;

        public void Add(IEnumerable<Cluster> others)
        {
            foreach (var other in others)
            {
                Box = Box.Include(other.Box);
                Pieces.AddRange(other.Pieces);
            }
        }
    }
}

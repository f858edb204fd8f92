namespace Caterpillar.Slicing;

/// <summary>Gives grown branches their smooth course and their thickness.</summary>
/// <param name="nodes">The branches of each level, from the bed up.</param>
/// <param name="space">What they keep out of.</param>
internal sealed class TreeShape(List<TreeNode>[] nodes, TreeSpace space)
{
    private const int Rounds = 150;

    /// <summary>Smooths the branches: each place moves toward the middle of its neighbors, as far as there is room around it.</summary>
    /// <param name="isFixed">Branches that stay.</param>
    public void Smooth(Predicate<TreeNode> isFixed)
    {
        var all = nodes.SelectMany(n => n).ToArray();
        var numbers = Enumerable.Range(0, all.Length).ToDictionary(i => all[i]);
        var below = Array.ConvertAll(all, n => n.Below is { } b ? numbers[b] : -1);
        var start = Array.ConvertAll(all, n => n.Place);
        var room = Array.ConvertAll(all, n => isFixed(n) || (n.Below is null && n.Level > 0) ? 0 : space.Room(n.Level, n.Place));
        var above = new Vec3[all.Length];
        var counts = new int[all.Length];
        for (var round = 0; round < Rounds; round++)
        {
            Array.Clear(above, 0, above.Length);
            Array.Clear(counts, 0, counts.Length);
            for (var i = 0; i < all.Length; i++)
            {
                if (below[i] < 0) continue;
                above[below[i]] += all[i].Place;
                counts[below[i]]++;
            }
            // From the bed up, so that those above see what is below them where it has moved to.
            for (var i = 0; i < all.Length; i++)
            {
                if (counts[i] == 0 || room[i] == 0) continue;
                var mean = above[i] / counts[i];
                var moved = Vec3.Lerp(all[i].Place, below[i] < 0 ? mean : Vec3.Lerp(mean, all[below[i]].Place, 0.5), 0.5);
                var distance = moved.DistanceTo(start[i]);
                all[i].Place = distance <= room[i] ? moved : Vec3.Lerp(start[i], moved, room[i] / distance);
            }
        }
    }

    /// <summary>Sets the radius of each branch: as wanted where there is room, and never more than what is below can carry.</summary>
    /// <param name="wanted">Gives the radius of a branch without regard to others.</param>
    /// <param name="least">Least radius, mm.</param>
    /// <param name="clear">What the space leaves clear, mm.</param>
    /// <param name="reach">mm that a level may lean out over the one below.</param>
    public void Thicken(Func<TreeNode, double> wanted, double least, double clear, Func<int, double> reach)
    {
        foreach (var node in nodes.SelectMany(n => n))
        {
            node.Radius = Math.Min(wanted(node), clear + space.Room(node.Level, node.Place));
            if (node.Below is not { } below) continue;
            var free = Math.Max(0, reach(node.Level) - node.Place.DistanceTo(below.Place));
            node.Radius = Math.Max(least, Math.Min(node.Radius, below.Radius + free));
        }
    }
}

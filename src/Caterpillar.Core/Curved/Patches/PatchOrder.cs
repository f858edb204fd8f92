namespace Caterpillar.Curved;

/// <summary>
/// The order of pieces of layers that lie at different heights beside each other: that of the layers, as long as the head meets nothing of what is printed
/// by then; else one in which it does not, along each branch as far up as it can go.
/// </summary>
internal static class PatchOrder
{
    // More patches are left in the order of their layers.
    private const int MostPatches = 20_000;

    /// <summary>The layers in the order in which they are printed; some in pieces, each of which is a layer of its own.</summary>
    public static SlicedLayer[] Arrange(SlicedLayer[] layers, Printer printer, DiagnosticList problems, bool tilts = false)
    {
        var several = layers.Any(l => !l.Support.IsEmpty || (l.Region.IsEmpty ? l.Steps.Count : l.Region.Contours.Count(c => c.SignedAreaXY > 0)) > 1)
            || layers.Select(l => l.Layer.Object).Distinct().Count() > 1;
        if (!several) return layers;
        var size = layers.SelectMany(l => l.Steps).Aggregate(Bounds.Empty, (b, s) => b.Include(s.Path.Bounds)).Size;
        var cell = Math.Max(1, size.LengthXY / 300);
        var found = new IReadOnlyList<LayerPatch>[layers.Length];
        Parallel.For(0, layers.Length, i => found[i] = LayerPatch.Of(layers[i], i, cell));
        var patches = found.SelectMany(p => p).ToArray();
        if (patches.Length == layers.Length || patches.Length > MostPatches) return layers;
        var under = Under(patches, out var isBelow);
        var clearance = new PatchClearance(printer, cell, cell * 1.4143);
        if (Blocked(patches, isBelow, clearance, inOrder: true) is null) return layers;

        var before = Blocked(patches, isBelow, clearance, inOrder: false)!;
        for (var i = 0; i < patches.Length; i++) before[i].AddRange(under[i]);
        if (Sorted(patches, before, under) is { } order)
        {
            var late = order.Where((p, at) => p != at).Count();
            problems.Add(Severity.Note, "curved.order", $"Layers are printed in pieces: {NumberFormatter.Format(late)} of "
                + $"{NumberFormatter.Format(patches.Length)} pieces are out of layer order, so that the print head hits no printed part.");
            return Pieces(layers, patches, order, cell);
        }
        // A head that leans may still pass.
        if (tilts) return layers;
        var exact = new PatchClearance(printer, cell, 0);
        if (Blocked(patches, isBelow, exact, inOrder: true) is { } hits)
        {
            var pairs = hits.SelectMany((late, early) => late.Select(k => (A: early, B: k))).ToList();
            var both = pairs.FindIndex(p => exact.IsBlocked(patches[p.B], patches[p.A]));
            var pair = pairs[Math.Max(0, both)];
            problems.Add(Severity.Warning, "curved.blocked_pieces", $"No collision-free order of layer pieces found: {Place(layers, patches[pair.A])} and "
                + $"{Place(layers, patches[pair.B])} block each other. They are printed in layer order.");
        }
        return layers;
    }

    // For each patch those right below it; and whether one is anywhere below another.
    private static List<int>[] Under(LayerPatch[] patches, out Func<int, int, bool> isBelow)
    {
        var words = (patches.Length + 63) / 64;
        var below = new ulong[patches.Length][];
        var under = new List<int>[patches.Length];
        var last = new Dictionary<(int, int), int>();
        for (var i = 0; i < patches.Length; i++)
        {
            var direct = new SortedSet<int>();
            foreach (var c in patches[i].Cells)
            {
                if (last.TryGetValue((c.Column, c.Row), out var lower)) direct.Add(lower);
                last[(c.Column, c.Row)] = i;
            }
            under[i] = direct.ToList();
            below[i] = new ulong[words];
            foreach (var lower in direct)
            {
                below[i][lower >> 6] |= 1UL << (lower & 63);
                for (var w = 0; w < words; w++) below[i][w] |= below[lower][w];
            }
        }
        isBelow = (low, high) => (below[high][low >> 6] & (1UL << (low & 63))) != 0;
        return under;
    }

    // For each patch those that it would block if it were printed before them; in order only those that follow it. Null if there are none.
    private static List<int>[]? Blocked(LayerPatch[] patches, Func<int, int, bool> isBelow, PatchClearance clearance, bool inOrder)
    {
        var before = Array.ConvertAll(patches, _ => new List<int>());
        var any = false;
        Parallel.For(0, patches.Length, i =>
        {
            for (var k = inOrder ? i + 1 : 0; k < patches.Length; k++)
            {
                if (k == i || isBelow(i, k) || isBelow(k, i)) continue;
                if (!clearance.IsBlocked(patches[i], patches[k])) continue;
                before[i].Add(k);
                any = true;
            }
        });
        return any ? before : null;
    }

    // Upward from the patch that was printed last, while nothing has to come before; else the first of the lowest layer.
    private static int[]? Sorted(LayerPatch[] patches, List<int>[] before, List<int>[] under)
    {
        var waits = Array.ConvertAll(before, b => b.Distinct().Count());
        var after = Array.ConvertAll(patches, _ => new List<int>());
        for (var i = 0; i < patches.Length; i++)
        {
            foreach (var early in before[i].Distinct()) after[early].Add(i);
        }
        var ready = new SortedSet<int>(Enumerable.Range(0, patches.Length).Where(i => waits[i] == 0));
        var order = new List<int>(patches.Length);
        while (ready.Count > 0)
        {
            var next = ready.Min;
            if (order.Count > 0)
            {
                var at = order[order.Count - 1];
                foreach (var above in after[at])
                {
                    if (waits[above] > 0 || !under[above].Contains(at)) continue;
                    next = above;
                    break;
                }
            }
            ready.Remove(next);
            order.Add(next);
            foreach (var late in after[next])
            {
                if (--waits[late] == 0) ready.Add(late);
            }
        }
        return order.Count == patches.Length ? order.ToArray() : null;
    }

    // Patches of one layer that follow each other stay together.
    private static SlicedLayer[] Pieces(SlicedLayer[] layers, LayerPatch[] patches, int[] order, double cell)
    {
        var result = new List<SlicedLayer>();
        var counts = new Dictionary<string, int>(StringComparer.Ordinal);
        for (int first = 0, next; first < order.Length; first = next)
        {
            next = first + 1;
            while (next < order.Length && patches[order[next]].Layer == patches[order[first]].Layer) next++;
            var source = layers[patches[order[first]].Layer];
            counts.TryGetValue(source.Layer.Object, out var index);
            counts[source.Layer.Object] = index + 1;
            var layer = source.Layer with { Index = index };
            var own = order.Skip(first).Take(next - first).Select(p => patches[p]).ToArray();
            var cells = new HashSet<(int, int)>(own.SelectMany(p => p.Cells).Select(c => (c.Column, c.Row)));
            var contours = source.Region.Contours.Where(c => Touches(c.Points[0], cells, cell)).ToArray();
            var region = contours.Length == source.Region.Contours.Count ? source.Region : Region.From(contours);
            var steps = own.SelectMany(p => p.Steps).Select(Moved).ToArray();
            result.Add(source with { Layer = layer, Region = region, Steps = steps });

            PathStep Moved(PathStep s) => s with
            {
                Path = s.Path with { Layer = layer }, Region = s.Region is null ? null : region,
                Group = s.Group is { } group ? group with { Layer = result.Count } : null,
            };
        }
        return result.ToArray();
    }

    // Outlines lie half an extrusion beside their walls.
    private static bool Touches(Vec3 p, HashSet<(int, int)> cells, double cell)
    {
        int column = (int)Math.Floor(p.X / cell), row = (int)Math.Floor(p.Y / cell);
        for (var dy = -1; dy <= 1; dy++)
        {
            for (var dx = -1; dx <= 1; dx++)
            {
                if (cells.Contains((column + dx, row + dy))) return true;
            }
        }
        return false;
    }

    private static string Place(SlicedLayer[] layers, LayerPatch patch)
        => $"layer {NumberFormatter.Format(layers[patch.Layer].Layer.Index + 1)} at {Round(patch.Steps[0].Path.Start)}";

    private static Vec3 Round(Vec3 p) => new(Math.Round(p.X, 2), Math.Round(p.Y, 2), Math.Round(p.Z, 2));
}

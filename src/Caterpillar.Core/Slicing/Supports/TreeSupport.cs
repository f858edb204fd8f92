namespace Caterpillar.Slicing;

/// <summary>
/// Supports as trees, grown from the top down: tips below what hangs over; further down, branches lean out of the shadow of the part, so that they reach
/// the bed, and toward each other until they join. They get thicker downwards.
/// </summary>
internal sealed class TreeSupport(SupportStack stack, SupportGaps gaps, ParallelOptions options)
{
    private const double ArcTolerance = 0.05;

    // Growth of the radius, mm for each mm down, and for each tip that a branch carries, of the line width.
    private const double Taper = 0.06;
    private const double Joined = 0.15;

    // Least radius, of the line width: a loop fits in.
    private const double Least = 1.05;

    // The nearest edge of the shadow is looked for again after so many levels.
    private const int TargetLevels = 10;

    private readonly PrintSettings _settings = stack.Settings;
    private readonly SupportLevel[] _levels = stack.Levels;
    private readonly double _width = stack.Settings.WidthOf(stack.Settings.SupportLineWidth, false);
    private readonly double _slope = Angle.Sin(stack.Settings.TreeBranchAngle) / Angle.Cos(stack.Settings.TreeBranchAngle);

    // Layers that hold a contact: the dense ones on a lattice over the tips.
    private readonly int _roofLayers = stack.Settings.SupportInterfaceLayers > 0 ? stack.Settings.SupportInterfaceLayers + 1 : 0;
    private readonly RegionEngine _engine = new();
    private List<Branch> _branches = [];

    // A branch where it passes a level.
    private readonly record struct Branch(Vec3 Place, double Depth, int Tips, Vec3? Target = null);

    /// <summary>Fills the supports of the levels, without regard to what carries them; trunks are where nothing is near.</summary>
    public void Grow()
    {
        var shadows = Shadows();
        var at = new List<Branch>?[_levels.Length];
        var next = new int[_levels.Length][];
        var waiting = Region.Empty;
        for (var i = shadows.Length - 1; i >= 0; i--)
        {
            options.CancellationToken.ThrowIfCancellationRequested();
            var level = _levels[i];
            if (_branches.Count > 0) next[i + 1] = Descend(level, shadows[i]);
            if (!level.Contact.IsEmpty || !waiting.IsEmpty)
            {
                Region[] wanted = [waiting, level.Contact];
                var ready = Region.Difference(wanted, [level.Forbidden], _engine).Offset(-_width / 20, JoinStyle.Miter, 2, ArcTolerance, _engine);
                AddTips(ready);
                // With the seam around it that was left away above: it would be looked at again on every level.
                var done = ready.Offset(_width, JoinStyle.Miter, 2, ArcTolerance, _engine);
                waiting = Region.Difference(wanted, [level.Part, done], _engine).Simplified(ArcTolerance, _engine);
            }
            if (_branches.Count > 0) at[i] = [.. _branches];
        }
        RegionEngine.ForEach(0, _levels.Length, options, (i, engine) => Divide(i, at[i] is { } branches ? Trunks(branches, next[i]) : [], engine));
    }

    // Trunks where nothing is near; the others are one with what they hold and stand at.
    private void Divide(int level, Trunk[] trunks, RegionEngine engine)
    {
        var free = new List<TrunkBundle>();
        var roof = _levels[level].Lattice = stack.ContactsOver(level, _roofLayers);
        var pieces = new List<Region>(roof);
        foreach (var group in TrunkBundle.Groups(trunks))
        {
            var isFree = group.TrueForAll(t => Array.TrueForAll(roof, t.IsApartFrom) && gaps.IsClear(level, t));
            if (isFree) free.Add(new TrunkBundle(group, Region.Union(group.Select(t => t.Region), engine)));
            else pieces.AddRange(group.Select(t => t.Region));
        }
        _levels[level].Bundles = free;
        if (pieces.Count > 0) _levels[level].Pieces = gaps.Clear(level, pieces, engine);
    }

    // What the part covers up to each level, seen from below, with the distance that branches keep.
    private Region[] Shadows()
    {
        var shadows = new Region[_levels.Length];
        var shadow = Region.Empty;
        for (var i = 0; i < shadows.Length; i++)
        {
            if (!shadow.Surrounds(_levels[i].Part)) shadow = shadow.Union(_levels[i].Part, _engine).Simplified(0.1, _engine);
            shadows[i] = shadow;
        }
        var top = Array.FindLastIndex(_levels, l => !l.Contact.IsEmpty);
        var around = new Region[top + 1];
        bool IsNew(int i) => i == 0 || shadows[i] != shadows[i - 1];
        RegionEngine.ForEach(0, top + 1, options, (i, engine) =>
        {
            if (IsNew(i)) around[i] = Around(shadows[i], engine);
        });
        for (var i = 1; i <= top; i++)
        {
            if (!IsNew(i)) around[i] = around[i - 1];
        }
        return around;
    }

    private Region Around(Region shadow, RegionEngine engine)
        => shadow.Offset(_settings.SupportXyGap + _width, JoinStyle.Round, 2, ArcTolerance, engine).Simplified(ArcTolerance, engine);

    // Takes the branches down to a level. Returns for each the number of the one that goes on with it there; −1 where it ends.
    private int[] Descend(SupportLevel level, Region shadow)
    {
        var step = level.Thickness * _slope;
        var reach = level.Top * _slope;
        var moved = new List<Branch>(_branches.Count);
        var places = new int[_branches.Count];
        for (var b = 0; b < _branches.Count; b++)
        {
            var branch = _branches[b];
            var place = branch.Place;
            places[b] = -1;
            // On the part: the branch ends here.
            if (level.Part.Contains(place.X, place.Y)) continue;
            var next = place;
            // A tip stays below the layers that rest on it.
            if (branch.Depth < _roofLayers * level.Thickness - 1e-6)
            {
                places[b] = moved.Count;
                moved.Add(branch with { Depth = branch.Depth + level.Thickness });
                continue;
            }
            if (shadow.Contains(place.X, place.Y))
            {
                // Lower shadows are no larger: a place outside stays outside.
                if (branch.Target is null || level.Work.Index % TargetLevels == 0) branch = branch with { Target = Edge(shadow, place) };
                var edge = branch.Target!.Value;
                var distance = edge.DistanceTo(place);
                if (distance <= reach) next = Toward(place, edge, Math.Min(step, distance + 0.01));
                else if (_settings.SupportPlacement == SupportPlacement.BuildPlate) continue;
                // Never through a wall.
                if (level.Forbidden.Contains(next.X, next.Y) && !level.Forbidden.Contains(place.X, place.Y)) next = place;
            }
            else if (Neighbor(b, 2 * reach) is { } other)
            {
                next = Toward(place, other, Math.Min(step, place.DistanceTo(other) / 2));
                if (shadow.Contains(next.X, next.Y)) next = place;
            }
            places[b] = moved.Count;
            moved.Add(branch with { Place = next, Depth = branch.Depth + level.Thickness });
        }
        var numbers = Merge(moved, level.Thickness);
        return Array.ConvertAll(places, p => p < 0 ? p : numbers[p]);
    }

    // Branches that have met become one. Returns the number of each among those that are left.
    private int[] Merge(List<Branch> branches, double thickness)
    {
        // No farther than what is above may lean out.
        var reach = Math.Min(_width / 2, thickness);
        var kept = new List<Branch>(branches.Count);
        var numbers = new int[branches.Count];
        for (var b = 0; b < numbers.Length; b++)
        {
            var branch = branches[b];
            var same = kept.FindIndex(k => k.Place.DistanceTo(branch.Place) < reach);
            numbers[b] = same < 0 ? kept.Count : same;
            if (same < 0) kept.Add(branch);
            else kept[same] = new Branch(kept[same].Place, Math.Max(kept[same].Depth, branch.Depth), kept[same].Tips + branch.Tips);
        }
        _branches = kept;
        return numbers;
    }

    private Vec3? Neighbor(int branch, double reach)
    {
        var least = reach;
        Vec3? best = null;
        for (var i = 0; i < _branches.Count; i++)
        {
            if (i == branch) continue;
            var distance = _branches[i].Place.DistanceTo(_branches[branch].Place);
            if (distance >= least) continue;
            least = distance;
            best = _branches[i].Place;
        }
        return best;
    }

    // Along the edges, so that the outermost extrusions of what tips carry have both ends of each span on one, and within.
    private void AddTips(Region ready)
    {
        var spacing = _settings.TreeTipDistance;
        foreach (var island in ready.Islands)
        {
            var count = _branches.Count;
            var edge = island.Offset(-_width / 2, JoinStyle.Miter, 2, ArcTolerance, _engine);
            if (edge.IsEmpty) edge = island;
            foreach (var contour in edge.Contours)
            {
                var length = contour.Length;
                // A small place has its tip in the middle.
                if (length < spacing) continue;
                var steps = Math.Ceiling(length / spacing);
                for (var k = 0; k < steps; k++) AddTip(LoopPlace.AtLength(contour.Raw, length * k / steps).Point);
            }
            var box = island.Bounds;
            for (var y = Math.Ceiling(box.Min.Y / spacing) * spacing; y <= box.Max.Y; y += spacing)
            {
                for (var x = Math.Ceiling(box.Min.X / spacing) * spacing; x <= box.Max.X; x += spacing)
                {
                    if (edge.Contains(x, y)) AddTip(new Vec3(x, y));
                }
            }
            if (_branches.Count == count && Middle(island) is { } middle) AddTip(middle);
        }
    }

    private void AddTip(Vec3 place)
    {
        if (!_branches.Exists(b => b.Place.DistanceTo(place) < _settings.TreeTipDistance / 2)) _branches.Add(new Branch(place, 0, 1));
    }

    // A point well inside: the middle of the longest level line at half its height.
    private static Vec3? Middle(Region island)
    {
        var box = island.Bounds;
        Vec3? middle = null;
        var longest = 0.0;
        foreach (var line in island.HatchLines(0, box.Size.Y + 1, box.Center.Y))
        {
            if (line.From.DistanceTo(line.To) <= longest) continue;
            longest = line.From.DistanceTo(line.To);
            middle = Vec3.Lerp(line.From, line.To, 0.5);
        }
        return middle;
    }

    private Trunk[] Trunks(List<Branch> branches, int[]? next)
    {
        var trunks = new Trunk[branches.Count];
        for (var b = 0; b < trunks.Length; b++)
        {
            var branch = branches[b];
            var radius = Math.Max(Least * _width, Math.Min(
                _settings.TreeBranchDiameter / 2, _width * (1 + Joined * Math.Sqrt(branch.Tips - 1)) + Taper * branch.Depth));
            trunks[b] = Trunk.Around(branch.Place, radius, b, next?[b] ?? -1);
        }
        return trunks;
    }

    private static Vec3 Edge(Region region, Vec3 from)
    {
        var best = from;
        var least = double.PositiveInfinity;
        foreach (var contour in region.Contours)
        {
            var place = LoopPlace.Nearest(contour.Raw, from).Point;
            var distance = place.DistanceTo(from);
            if (distance >= least) continue;
            least = distance;
            best = place;
        }
        return best;
    }

    private static Vec3 Toward(Vec3 from, Vec3 to, double step)
    {
        var distance = from.DistanceTo(to);
        return distance > 0 ? from + (to - from) * (step / distance) : from;
    }
}

namespace Caterpillar.Slicing;

/// <summary>
/// Supports as trees. Tips stand below what hangs over; from the top down, branches grow toward each other until they join, and out of where no path leads
/// to the bed. Then they are smoothed. They get thicker downwards. After the organic trees of PrusaSlicer and OrcaSlicer, with points instead of areas.
/// </summary>
internal sealed class TreeSupport(SupportStack stack, SupportGaps gaps, ParallelOptions options)
{
    private const double ArcTolerance = 0.05;

    // Least radius, of the line width: a loop fits in.
    private const double Least = 1.05;

    // A branch looks for its nearest neighbor again after so many levels.
    private const int PartnerLevels = 8;

    // Of the height that is left; where branches would meet lower, they stay apart.
    private const double Lowest = 0.8;

    // Of the line width, beyond the gap: else what leans out on a slope touches the roof below it all along.
    private const double Aside = 0.5;

    // Half of the width, of the line width, from which more tips hold what the first ones leave out.
    private const double LeftOut = 0.15;

    // mm; roofs that lie closer together than twice this are one.
    private const double Hairline = 0.1;

    // Share of a tip's height above the bed. If the part is no farther below the tip, the branch ends on the part: a trunk to the bed would take longer.
    private const double Close = 1 / 6.0;

    // mm; the foot is wider by half of the height below this.
    private const double Foot = 1.5;

    private readonly PrintSettings _settings = stack.Settings;
    private readonly SupportLevel[] _levels = stack.Levels;
    private readonly double _width = stack.LineWidth;
    private readonly double _least = Least * stack.LineWidth;

    // What branches keep clear of the part, so that they are no thinner along it.
    private readonly double _clear
        = Math.Max(Least * stack.LineWidth, Math.Min(2 * Least * stack.LineWidth, stack.Settings.TreeBranchDiameter / 2));
    private readonly double _slope = Angle.Sin(stack.Settings.TreeBranchAngle) / Angle.Cos(stack.Settings.TreeBranchAngle);
    private readonly double _taper = Angle.Sin(stack.Settings.TreeBranchDiameterAngle) / Angle.Cos(stack.Settings.TreeBranchDiameterAngle);

    // Layers that hold a contact: the dense ones on a lattice over the tips.
    private readonly int _roofLayers = stack.Settings.SupportInterfaceLayers > 0 ? stack.Settings.SupportInterfaceLayers + 1 : 0;
    private readonly RegionEngine _engine = new();

    // What roofs keep out of on each level.
    private Region[] _beside = [];

    /// <summary>Fills the supports of the levels, without regard to what carries them.</summary>
    /// <param name="carried">Removes what nothing carries: where that leaves something in the air, more tips hold it.</param>
    public void Grow(CarriedSupports carried)
    {
        var top = Array.FindLastIndex(_levels, l => !l.Contact.IsEmpty);
        var space = new TreeSpace([.. _levels.Take(top + 1).Select(l => (l.Obstacles, l.Thickness))], _clear, _slope, options);
        _beside = new Region[top + 1];
        RegionEngine.ForEach(0, top + 1, options, (i, engine) =>
            _beside[i] = _levels[i].Forbidden.Offset(Aside * _width, JoinStyle.Round, 2, ArcTolerance, engine));
        var areas = Areas(top);
        var tips = Array.ConvertAll(areas, _ => new List<Vec3>());
        AddTips(areas, 1, tips);
        Grow(tips, space);
        if (_roofLayers == 0) return;
        carried.Keep(options.CancellationToken);
        RegionEngine.ForEach(0, areas.Length, options, (i, engine) =>
        {
            if (areas[i].IsEmpty) return;
            var held = _levels[i].Pieces.Offset(_width / 2, JoinStyle.Miter, 2, ArcTolerance, engine);
            areas[i] = ThinParts.Thick(areas[i].Subtract(held, engine), LeftOut * _width, engine);
        });
        AddTips(areas, 0.5, tips);
        Grow(tips, space);
    }

    private void Grow(List<Vec3>[] tips, TreeSpace space)
    {
        var nodes = new List<TreeNode>[tips.Length];
        for (var i = tips.Length - 1; i >= 0; i--)
        {
            options.CancellationToken.ThrowIfCancellationRequested();
            nodes[i] = i + 1 < tips.Length ? Descend(nodes[i + 1], i, space) : [];
            foreach (var place in tips[i])
            {
                var tip = new TreeNode(i, place.WithZ(0)) { ReachesBed = ReachesBed(i, place.WithZ(0), space) };
                if (tip.ReachesBed || _settings.SupportPlacement == SupportPlacement.Everywhere) nodes[i].Add(tip);
            }
        }
        var shape = new TreeShape(nodes, space);
        shape.Smooth(IsUnderRoof);
        shape.Thicken(Radius, _least, _clear, i => _slope * _levels[i].Thickness);
        RegionEngine.ForEach(0, tips.Length, options, (i, engine) =>
        {
            _levels[i].Roofs = stack.ContactsOver(i, _roofLayers);
            // Strips of a slope on adjacent levels lie side by side, with hairlines between them.
            var roof = Region.Union(_levels[i].Roofs, engine).Offset(Hairline, JoinStyle.Miter, 2, ArcTolerance, engine)
                .Offset(-Hairline, JoinStyle.Miter, 2, ArcTolerance, engine);
            roof = ThinParts.Thick(roof.Subtract(_beside[i], engine), CarriedSupports.ThinRoof * _width, engine);
            Region[] pieces = [roof, .. nodes[i].Select(n => n.Region)];
            _levels[i].Pieces = gaps.Clear(i, pieces, engine);
        });
    }

    // A tip stays below the layers that rest on it.
    private bool IsUnderRoof(TreeNode node) => node.Depth < _roofLayers * _levels[node.Level].Thickness - 1e-6;

    private double Radius(TreeNode node)
        => Math.Max(_least, Math.Min(_settings.TreeBranchDiameter / 2, _least + _taper * node.Depth))
            + (node.ReachesBed ? Math.Max(0, Foot - _levels[node.Level].Top) / 2 : 0);

    // What is held from each level: where the part leaves room for roofs. Contacts that it leaves none move down.
    private Region[] Areas(int top)
    {
        var areas = new Region[top + 1];
        var waiting = Region.Empty;
        for (var i = top; i >= 0; i--)
        {
            options.CancellationToken.ThrowIfCancellationRequested();
            var level = _levels[i];
            areas[i] = Region.Empty;
            if (level.Contact.IsEmpty && waiting.IsEmpty) continue;
            Region[] wanted = [waiting, level.Contact];
            areas[i] = Region.Difference(wanted, [_beside[i]], _engine).Offset(-_width / 20, JoinStyle.Miter, 2, ArcTolerance, _engine);
            // With the seam around it that was left away above: it would be looked at again on every level.
            var done = areas[i].Offset(_width, JoinStyle.Miter, 2, ArcTolerance, _engine);
            level.Contact = Region.Union(wanted, _engine).Intersect(done, _engine);
            waiting = Region.Difference(wanted, [level.Part, done], _engine).Simplified(ArcTolerance, _engine);
        }
        return areas;
    }

    // So far apart, of the usual distance.
    private void AddTips(Region[] areas, double spacing, List<Vec3>[] tips)
    {
        var places = new TreeTips(spacing * _settings.TreeTipDistance, _width);
        for (var i = 0; i < areas.Length; i++) tips[i].AddRange(places.Below(areas[i], _levels[i].Top));
    }

    // Tips are nearer to the part than branches, which move away from it below.
    private bool ReachesBed(int level, Vec3 place, TreeSpace space)
    {
        if (_settings.SupportPlacement == SupportPlacement.Everywhere && IsCloseAbovePart(level, place)) return false;
        var below = Math.Max(0, level - _roofLayers);
        return !space.IsTrapped(below, place) || space.NearestExit(below, place).DistanceTo(place) <= _clear + _width / 2;
    }

    private bool IsCloseAbovePart(int level, Vec3 place)
    {
        var lowest = (1 - Close) * _levels[level].Top;
        for (var k = level - 1; k >= 0 && _levels[k].Top > lowest; k--)
        {
            if (_levels[k].Part.Contains(place.X, place.Y)) return true;
        }
        return false;
    }

    // Takes the branches down to a level: the strongest first, so that others join them.
    private List<TreeNode> Descend(List<TreeNode> above, int i, TreeSpace space)
    {
        var (level, thickness) = (_levels[i], _levels[i + 1].Thickness);
        var step = thickness * _slope;
        var moved = new List<TreeNode>(above.Count);
        foreach (var node in above.OrderByDescending(n => n.Tips))
        {
            // On the part: the branch ends here.
            if (level.Part.Contains(node.Place.X, node.Place.Y)) continue;
            var stays = IsUnderRoof(node);
            var joined = stays ? null : moved.Find(m => m.Place.DistanceTo(node.Place) <= step && (m.ReachesBed || !node.ReachesBed));
            if (joined is null)
            {
                if (!stays) node.Partner = Partner(node, above, space);
                joined = new TreeNode(i, stays ? node.Place : Next(node, i, step, space)) { Tips = 0, ReachesBed = node.ReachesBed, Partner = node.Partner };
                moved.Add(joined);
            }
            joined.Tips += node.Tips;
            joined.Depth = Math.Max(joined.Depth, node.Depth + thickness);
            node.Below = joined;
        }
        return moved;
    }

    private Vec3 Next(TreeNode node, int i, double step, TreeSpace space)
    {
        var place = node.Place;
        var next = node.Partner is { } partner ? Toward(place, partner.Place, Math.Min(step, place.DistanceTo(partner.Place) / 2)) : place;
        if (!node.ReachesBed) return space.IsBlocked(i, next) && !space.IsBlocked(i, place) ? place : next;
        if (!space.IsTrapped(i, next)) return next;
        var exit = space.NearestExit(i, next);
        if (exit.DistanceTo(place) > step) exit = space.NearestExit(i, place);
        return Toward(place, exit, Math.Min(step, exit.DistanceTo(place) + 0.01));
    }

    // The branch that another one grows toward: its nearest neighbor, if both can meet.
    private TreeNode? Partner(TreeNode node, List<TreeNode> others, TreeSpace space)
    {
        // The one that it has grown toward so far, on this level.
        if (node.Level % PartnerLevels != 0 && node.Partner?.Below is { } same && same != node && same.Level == node.Level) return same;
        TreeNode? best = null;
        var height = _levels[node.Level].Top;
        var least = 2 * _slope * Lowest * height;
        foreach (var other in others)
        {
            var distance = other.Place.DistanceTo(node.Place);
            if (other == node || distance >= least || (node.ReachesBed && !other.ReachesBed)) continue;
            var meeting = stack.LevelBelow(height - distance / 2 / _slope);
            if (meeting < 0 || space.IsTrapped(meeting, Vec3.Lerp(node.Place, other.Place, 0.5)) && node.ReachesBed) continue;
            least = distance;
            best = other;
        }
        return best;
    }

    private static Vec3 Toward(Vec3 from, Vec3 to, double step)
    {
        var distance = from.DistanceTo(to);
        return distance > 0 ? from + (to - from) * (step / distance) : from;
    }
}
